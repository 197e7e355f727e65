#include "components/ros/detail/user_data.h"

#include <algorithm>
#include <string_view>

namespace goalnet::ros::detail {
namespace {

constexpr std::string_view kKey = "typehash";
constexpr std::string_view kVersion = "RIHS01_";
constexpr std::size_t kDigits = 64;

bool is_hash(std::string_view value) {
  if (!value.starts_with(kVersion) || value.size() != kVersion.size() + kDigits) return false;
  const auto digits = value.substr(kVersion.size());
  return std::all_of(digits.begin(), digits.end(),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

// The first "key=value;" whose value is a good one; every pair ends with a semicolon.
std::string first_value(std::span<const std::uint8_t> user_data, std::string_view key,
                        bool (*good)(std::string_view)) {
  std::string_view rest(reinterpret_cast<const char*>(user_data.data()), user_data.size());
  for (auto end = rest.find(';'); end != std::string_view::npos; end = rest.find(';')) {
    const std::string_view pair = rest.substr(0, end);
    if (pair.starts_with(key) && pair.substr(key.size()).starts_with('=')) {
      const std::string_view value = pair.substr(key.size() + 1);
      if (good(value)) return std::string(value);
    }
    rest.remove_prefix(end + 1);
  }
  return "";
}

}  // namespace

std::string endpoint_user_data(Distro distro, const std::string& type_hash) {
  return distro == Distro::kHumble || type_hash.empty() ? "" : std::string(kKey) + "=" + type_hash + ";";
}

std::string user_data_value(std::span<const std::uint8_t> user_data, std::string_view key) {
  return first_value(user_data, key, [](std::string_view) { return true; });
}

std::string type_hash_of(std::span<const std::uint8_t> user_data) {
  return first_value(user_data, kKey, is_hash);
}

}  // namespace goalnet::ros::detail
