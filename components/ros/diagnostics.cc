#include "components/ros/diagnostics.h"

#include <fmt/format.h>

#include <cmath>

namespace goalnet::ros {

void DiagnosticReport::summary(DiagnosticLevel level, std::string message) {
  if (level < level_ || (level == level_ && message_ != "ok")) return;
  level_ = level;
  message_ = std::move(message);
}

void DiagnosticReport::threshold(const std::string& key, double value, double warn, double error,
                                 const std::string& unit) {
  add(key, fmt::format("{:g}{}{}", value, unit.empty() ? "" : " ", unit));
  if (std::isnan(value) || value >= error) {
    summary(DiagnosticLevel::kError,
            fmt::format("{} is {:g} {}, the limit is {:g}", key, value, unit, error));
  } else if (value >= warn) {
    summary(DiagnosticLevel::kWarn,
            fmt::format("{} is {:g} {}, normal is below {:g}", key, value, unit, warn));
  }
}

Diagnostics::Diagnostics(Node& node)
    : node_(node),
      out_(node.advertise<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", Qos::standard())),
      timer_(node.create_timer(std::chrono::seconds(1), [this] { publish(); })) {}

void Diagnostics::add(std::string part, std::function<void(DiagnosticReport&)> check) {
  parts_.emplace_back(std::move(part), std::move(check));
}

void Diagnostics::publish() {
  diagnostic_msgs::msg::DiagnosticArray message;
  message.header().stamp(node_.now().to_msg());
  for (const auto& [part, check] : parts_) {
    DiagnosticReport report;
    check(report);
    diagnostic_msgs::msg::DiagnosticStatus status;
    status.level(static_cast<std::uint8_t>(report.level()));
    status.name(node_.full_name().substr(1) + ": " + part);
    status.message(report.message());
    status.hardware_id("none");
    for (const auto& [key, value] : report.values()) {
      diagnostic_msgs::msg::KeyValue entry;
      entry.key(key);
      entry.value(value);
      status.values().push_back(entry);
    }
    message.status().push_back(status);
  }
  out_->publish(message);
}

}  // namespace goalnet::ros
