// /diagnostics: once a second, the state of each part of a node, judged by thresholds.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "components/ros/node.h"
#include "diagnostic_msgs/msg/DiagnosticArray.h"

namespace goalnet::ros {

enum class DiagnosticLevel : std::uint8_t { kOk = 0, kWarn = 1, kError = 2, kStale = 3 };  // REP-107

// What one part says about itself; add values in any order, the worst level and its message win.
class DiagnosticReport {
 public:
  void summary(DiagnosticLevel level, std::string message);
  void add(std::string key, std::string value) { values_.emplace_back(std::move(key), std::move(value)); }
  // Adds the value; WARN from `warn` on and ERROR from `error` on (larger is worse). NaN is an error.
  void threshold(const std::string& key, double value, double warn, double error, const std::string& unit);

  DiagnosticLevel level() const { return level_; }
  const std::string& message() const { return message_; }
  const std::vector<std::pair<std::string, std::string>>& values() const { return values_; }

 private:
  DiagnosticLevel level_ = DiagnosticLevel::kOk;
  std::string message_ = "ok";
  std::vector<std::pair<std::string, std::string>> values_;
};

// Runs in the node's loop, on a wall-clock period of 1 s (or the node's clock where it is simulated).
class Diagnostics {
 public:
  explicit Diagnostics(Node& node);
  // `part` is published as "node: part".
  void add(std::string part, std::function<void(DiagnosticReport&)> check);
  // Publishes now: what is judged at once when something goes wrong.
  void publish();

 private:
  Node& node_;
  std::vector<std::pair<std::string, std::function<void(DiagnosticReport&)>>> parts_;
  std::shared_ptr<Publisher<diagnostic_msgs::msg::DiagnosticArray>> out_;
  std::shared_ptr<Timer> timer_;
};

}  // namespace goalnet::ros
