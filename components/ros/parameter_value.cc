#include "components/ros/parameter_value.h"

#include <fmt/format.h>

#include <cmath>

namespace goalnet::ros {
namespace {

std::string text(bool value) { return value ? "true" : "false"; }
std::string text(std::int64_t value) { return std::to_string(value); }
std::string text(std::uint8_t value) { return fmt::format("0x{:02x}", value); }
std::string text(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::string digits = fmt::format("{}", value);
  if (digits.find_first_of(".e") == std::string::npos) digits += ".0";  // else it would read as an integer
  return digits;
}
std::string text(const std::string& value) {
  std::string out = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}
template <class T>
std::string text(const std::vector<T>& values) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ", ";
    out += text(static_cast<T>(values[i]));
  }
  return out + "]";
}

}  // namespace

const char* type_name(const ParameterValue& value) {
  static constexpr const char* kNames[] = {"not set",      "bool",        "integer",    "double",
                                           "string",       "byte_array",  "bool_array", "integer_array",
                                           "double_array", "string_array"};
  return kNames[value.index()];
}

std::string to_string(const ParameterValue& value) {
  return std::visit(
      [](const auto& held) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return "~";
        } else {
          return text(held);
        }
      },
      value);
}

}  // namespace goalnet::ros
