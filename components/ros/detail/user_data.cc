#include "components/ros/detail/user_data.h"

#include <algorithm>
#include <string_view>

namespace goalnet::ros::detail {
namespace {

constexpr std::string_view kKey = "typehash=";
constexpr std::string_view kVersion = "RIHS01_";
constexpr std::size_t kDigits = 64;

bool is_hash(std::string_view value) {
  if (!value.starts_with(kVersion) || value.size() != kVersion.size() + kDigits) return false;
  const auto digits = value.substr(kVersion.size());
  return std::all_of(digits.begin(), digits.end(),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

}  // namespace

std::string endpoint_user_data(Distro distro, const std::string& type_hash) {
  return distro == Distro::kHumble || type_hash.empty() ? "" : std::string(kKey) + type_hash + ";";
}

std::string type_hash_of(std::span<const std::uint8_t> user_data) {
  std::string_view rest(reinterpret_cast<const char*>(user_data.data()), user_data.size());
  while (!rest.empty()) {
    const auto end = rest.find(';');
    if (end == std::string_view::npos) return "";  // every pair ends with one
    const std::string_view pair = rest.substr(0, end);
    if (pair.starts_with(kKey) && is_hash(pair.substr(kKey.size())))
      return std::string(pair.substr(kKey.size()));
    rest.remove_prefix(end + 1);
  }
  return "";
}

}  // namespace goalnet::ros::detail
