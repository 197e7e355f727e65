#include "components/ros/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goalnet::ros {
namespace {

// A range on numbers and on each element of number arrays. The step's tolerance is that of rclcpp: 1e-9
// relative.
std::string out_of_range(double value, const ParameterRange& range) {
  if (std::isnan(value) || value < range.from || value > range.to) {
    return fmt::format("{} is not within {} .. {}", value, range.from, range.to);
  }
  if (range.step <= 0 || value == range.to) return "";
  const double steps = (value - range.from) / range.step;
  if (std::abs(steps - std::round(steps)) > 1e-9 * std::max(1.0, std::abs(steps))) {
    return fmt::format("{} is not a whole number of steps of {} from {}", value, range.step, range.from);
  }
  return "";
}

std::string fault_of(const ParameterValue& value, const ParameterDescriptor& descriptor) {
  if (!descriptor.range) return "";
  const auto& range = *descriptor.range;
  if (const auto* number = std::get_if<double>(&value)) return out_of_range(*number, range);
  if (const auto* number = std::get_if<std::int64_t>(&value))
    return out_of_range(static_cast<double>(*number), range);
  std::string fault;
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    for (const double number : *numbers) fault = fault.empty() ? out_of_range(number, range) : fault;
  }
  if (const auto* numbers = std::get_if<std::vector<std::int64_t>>(&value)) {
    for (const auto number : *numbers)
      fault = fault.empty() ? out_of_range(static_cast<double>(number), range) : fault;
  }
  return fault;
}

// People write `5` where a double is meant, and `[]` where the type cannot be seen.
ParameterValue fitted(ParameterValue value, const ParameterValue& model) {
  if (std::holds_alternative<double>(model) && std::holds_alternative<std::int64_t>(value)) {
    return static_cast<double>(std::get<std::int64_t>(value));
  }
  if (std::holds_alternative<std::vector<double>>(model) &&
      std::holds_alternative<std::vector<std::int64_t>>(value)) {
    const auto& whole = std::get<std::vector<std::int64_t>>(value);
    return std::vector<double>(whole.begin(), whole.end());
  }
  const auto* empty = std::get_if<std::vector<std::string>>(&value);
  if (empty != nullptr && empty->empty() && model.index() >= 5) {
    return std::visit([](const auto& held) -> ParameterValue { return std::decay_t<decltype(held)>{}; },
                      model);
  }
  return value;
}

// Does YAML take this name without quotation marks as what it is?
bool reads_as_plain_text(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name[0]) && name != "null" && name != "Null" && name != "NULL" &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '.'; });
}

}  // namespace

void Parameters::set_override(const std::string& name, ParameterValue value, std::string origin) {
  overrides_[name] = Override{std::move(value), std::move(origin), false};
}

Expected<ParameterValue> Parameters::declare(const std::string& name, const ParameterValue& default_value,
                                             const ParameterDescriptor& descriptor) {
  if (name.empty()) return fail(Outcome::kInvalidRequest, "a parameter without a name");
  if (entries_.contains(name))
    return fail(Outcome::kInvalidRequest, "parameter '" + name + "' is declared twice");
  // `a` and `a.b` cannot both stand in a parameter file: ros2 param dump would fail.
  for (const auto& [other, entry] : entries_) {
    if (other.starts_with(name + '.') || name.starts_with(other + '.')) {
      return fail(Outcome::kInvalidRequest,
                  fmt::format("parameter '{}' cannot stand beside '{}': a value is no group", name, other));
    }
  }
  ParameterValue value = default_value;
  std::string origin = "its default";
  if (const auto found = overrides_.find(name); found != overrides_.end()) {
    found->second.used = true;
    origin = found->second.origin;
    value = fitted(found->second.value, default_value);
    if (value.index() != default_value.index() && default_value.index() != 0) {
      return fail(Outcome::kInvalidRequest,
                  fmt::format("{}: parameter '{}' must be {} {} (for example {}), not {} {}", origin, name,
                              default_value.index() == 2 ? "an" : "a", type_name(default_value),
                              to_string(default_value), type_name(value), to_string(value)));
    }
  }
  if (const std::string fault = fault_of(value, descriptor); !fault.empty()) {
    return fail(Outcome::kInvalidRequest, fmt::format("{}: parameter '{}': {}", origin, name, fault));
  }
  for (const auto& validator : validators_) {
    if (auto ok = validator({{name, value}}); !ok) {
      return fail(Outcome::kInvalidRequest,
                  fmt::format("{}: parameter '{}': {}", origin, name, ok.error().message));
    }
  }
  entries_[name] = {value, descriptor};
  for (const auto& observer : observers_) observer({{{name, value}}, {}});
  return value;
}

const ParameterValue* Parameters::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.value;
}

const ParameterDescriptor* Parameters::descriptor(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.descriptor;
}

std::vector<std::string> Parameters::names() const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return names;
}

Expected<void> Parameters::set(const std::vector<Parameter>& values) {
  for (const Parameter& parameter : values) {
    const auto refuse = [&](const std::string& why) {
      return fail(Outcome::kInvalidRequest,
                  fmt::format("parameter '{}' {}", parameter.name.substr(0, 200), why));
    };
    const auto found = entries_.find(parameter.name);
    if (found == entries_.end()) return refuse("is not declared");
    if (found->second.descriptor.read_only) return refuse("is read-only");
    if (parameter.value.index() != found->second.value.index()) {
      return refuse(
          fmt::format("is of type {}, not {}", type_name(found->second.value), type_name(parameter.value)));
    }
    if (const auto fault = fault_of(parameter.value, found->second.descriptor); !fault.empty())
      return refuse(": " + fault);
  }
  for (const auto& validator : validators_) {
    if (auto ok = validator(values); !ok) return ok;
  }
  for (const Parameter& parameter : values) entries_[parameter.name].value = parameter.value;
  for (const auto& observer : observers_) observer({{}, values});
  return {};
}

std::vector<std::string> Parameters::unused_overrides() const {
  std::vector<std::string> names;
  for (const auto& [name, override_] : overrides_) {
    if (!override_.used) names.push_back(name + " (" + override_.origin + ")");
  }
  return names;
}

std::string Parameters::dump(const std::string& node_full_name) const {
  if (entries_.empty()) return node_full_name + ":\n  ros__parameters: {}\n";
  std::string text = node_full_name + ":\n  ros__parameters:\n";
  for (const auto& [name, entry] : entries_) {
    const std::string key = reads_as_plain_text(name) ? name : to_string(ParameterValue(name));
    text += "    " + key + ": " + to_string(entry.value) + "\n";
  }
  return text;
}

}  // namespace goalnet::ros
