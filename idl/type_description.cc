#include "idl/type_description.h"

#include <algorithm>

namespace goalnet::idl {

const TypeDescription* find_type(std::string_view name) {
  const auto types = all_types();
  const auto found =
      std::lower_bound(types.begin(), types.end(), name,
                       [](const TypeDescription& type, std::string_view key) { return type.name < key; });
  return found != types.end() && found->name == name ? &*found : nullptr;
}

std::string dds_type_name(std::string_view ros_name) {
  const auto first = ros_name.find('/');
  const auto second = ros_name.find('/', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::string(ros_name);
  return std::string(ros_name.substr(0, first)) +
         "::" + std::string(ros_name.substr(first + 1, second - first - 1)) +
         "::dds_::" + std::string(ros_name.substr(second + 1)) + "_";
}

std::string ros_type_name(std::string_view dds_name) {
  const auto mark = dds_name.find("::dds_::");
  if (mark == std::string_view::npos || dds_name.empty() || dds_name.back() != '_') return "";
  std::string name(dds_name.substr(0, mark));
  const auto colons = name.find("::");
  if (colons == std::string::npos) return "";
  name.replace(colons, 2, "/");
  const auto last = dds_name.substr(mark + 8);
  return name + "/" + std::string(last.substr(0, last.size() - 1));
}

std::string full_definition(const TypeDescription& type) {
  std::string text = type.source;
  for (const char* const* name = type.referenced; *name != nullptr; ++name) {
    const TypeDescription* part = find_type(*name);
    std::string short_name = *name;  // pkg/msg/Type is written pkg/Type here
    if (const auto at = short_name.find("/msg/"); at != std::string::npos) short_name.erase(at, 4);
    text +=
        "\n" + std::string(80, '=') + "\nMSG: " + short_name + "\n" + (part != nullptr ? part->source : "");
  }
  return text;
}

}  // namespace goalnet::idl
