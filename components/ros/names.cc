#include "components/ros/names.h"

#include <cctype>

namespace goalnet::ros {
namespace {

constexpr std::size_t kLongestDdsTopic = 256;
constexpr std::size_t kLongestNodeName = 255;

// One part between slashes. Empty text if it is fine, else why not.
std::string_view fault_of_part(std::string_view part) {
  if (part.empty()) return "has an empty part";
  if (std::isdigit(static_cast<unsigned char>(part[0])) != 0) return "has a part that starts with a digit";
  if (part.find("__") != std::string_view::npos) return "has two underscores in a row";
  for (const char c : part) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_')
      return "has a character other than A-Z a-z 0-9 _";
  }
  return "";
}

Expected<void> check_absolute(std::string_view name, std::string_view original) {
  const auto bad = [&](std::string_view why) {
    return fail(Outcome::kInvalidRequest, "the ROS name '" + std::string(original.substr(0, 100)) + "' " +
                                              std::string(why) +
                                              "; write parts of letters, digits and _ between /");
  };
  if (name.size() + 8 > kLongestDdsTopic) return bad("is longer than 248 characters");
  std::size_t at = 1;
  while (true) {
    const auto end = name.find('/', at);
    const auto fault = fault_of_part(name.substr(at, end == std::string_view::npos ? end : end - at));
    if (!fault.empty()) return bad(fault);
    if (end == std::string_view::npos) return {};
    at = end + 1;
  }
}

std::string join(std::string_view space, std::string_view name) {
  return (space == "/" ? std::string() : std::string(space)) + "/" + std::string(name);
}

}  // namespace

Expected<std::string> expand_name(std::string_view name, std::string_view node_namespace,
                                  std::string_view node_name) {
  std::string full;
  if (name.empty())
    return fail(Outcome::kInvalidRequest, "an empty ROS name; give topics and services a name");
  if (name[0] == '/') {
    full = name;
  } else if (name[0] == '~') {
    full = join(node_namespace, node_name);
    if (name.size() > 1)
      full += name[1] == '/' ? std::string(name.substr(1)) : "/" + std::string(name.substr(1));
  } else {
    full = join(node_namespace, name);
  }
  if (auto ok = check_absolute(full, name); !ok) return tl::unexpected(ok.error());
  return full;
}

Expected<std::string> normalize_namespace(std::string_view node_namespace) {
  std::string full(node_namespace);
  if (full.empty() || full == "/") return std::string("/");
  if (full[0] != '/') full.insert(0, "/");
  if (full.back() == '/') full.pop_back();
  if (auto ok = check_absolute(full, node_namespace); !ok) return tl::unexpected(ok.error());
  return full;
}

Expected<void> check_node_name(std::string_view name) {
  const auto fault = name.size() > kLongestNodeName ? std::string_view("is longer than 255 characters")
                                                    : fault_of_part(name);
  if (fault.empty()) return {};
  return fail(Outcome::kInvalidRequest,
              "the node name '" + std::string(name.substr(0, 100)) + "' " + std::string(fault));
}

std::string topic_to_dds(std::string_view name) { return "rt" + std::string(name); }
std::string service_request_to_dds(std::string_view name) { return "rq" + std::string(name) + "Request"; }
std::string service_reply_to_dds(std::string_view name) { return "rr" + std::string(name) + "Reply"; }

std::string logger_name(std::string_view node_namespace, std::string_view node_name) {
  std::string name = join(node_namespace, node_name).substr(1);
  for (char& c : name) {
    if (c == '/') c = '.';
  }
  return name;
}

}  // namespace goalnet::ros
