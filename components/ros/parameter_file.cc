#include "components/ros/parameter_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace goalnet::ros {
namespace {

constexpr std::size_t kLargestFile = 1u << 20;  // [bytes]
constexpr int kDeepest = 32;                    // groups within groups
constexpr std::size_t kLongestArray = 65'536;
constexpr std::size_t kMostParameters = 10'000;
constexpr std::size_t kMostGroups = 10'000;  // also of aliases: 32 levels of two each would be 4e9

struct Collected {
  std::vector<ParameterOverride> parameters;
  std::size_t groups = 0;
};

tl::unexpected<Error> bad(const std::string& origin, const YAML::Node& node, const std::string& what) {
  return fail(Outcome::kInvalidRequest, origin + ":" + std::to_string(node.Mark().line + 1) + ": " + what);
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  for (const char* one : words) {
    if (word == one) return true;
  }
  return false;
}

// Quoted scalars are texts; plain ones are read as rcl does: booleans, integers, numbers, else texts.
ParameterValue scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (node.Tag() == "!" || node.Tag() == "!!str" || node.Tag() == "tag:yaml.org,2002:str") return text;
  if (is_one_of(text, {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON", "y", "Y"})) return true;
  if (is_one_of(text, {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF", "n", "N"}))
    return false;
  if (is_one_of(text, {".nan", ".NaN", ".NAN"})) return std::numeric_limits<double>::quiet_NaN();
  if (is_one_of(text, {".inf", ".Inf", ".INF", "+.inf", "+.Inf", "+.INF"}))
    return std::numeric_limits<double>::infinity();
  if (is_one_of(text, {"-.inf", "-.Inf", "-.INF"})) return -std::numeric_limits<double>::infinity();
  if (text.empty() || text.find_first_not_of("+-.0123456789abcdefABCDEFxX") != std::string::npos) return text;
  char* end = nullptr;
  errno = 0;
  const bool hexadecimal = text.find_first_of("xX") != std::string::npos;
  const long long whole = std::strtoll(text.c_str(), &end, 0);  // 010 is 8, as in YAML 1.1
  if (*end == '\0' && errno == 0) return std::int64_t{whole};
  const double number = std::strtod(text.c_str(), &end);
  if (*end == '\0' && end != text.c_str() && !hexadecimal) return number;
  return text;
}

Expected<ParameterValue> array(const YAML::Node& node, const std::string& origin) {
  if (node.size() > kLongestArray) return bad(origin, node, "an array of more than 65536 elements");
  std::vector<ParameterValue> values;
  std::array<bool, 10> kinds{};
  for (const auto& element : node) {
    if (!element.IsScalar())
      return bad(origin, element, "an array may only hold plain values, no arrays or groups");
    values.push_back(scalar(element));
    kinds[values.back().index()] = true;
  }
  if (kinds[2] && kinds[3]) {  // 1 and 2.5 together are numbers
    for (auto& value : values) {
      if (auto* whole = std::get_if<std::int64_t>(&value)) value = static_cast<double>(*whole);
    }
    kinds[2] = false;
  }
  if (std::count(kinds.begin(), kinds.end(), true) > 1) {
    return bad(origin, node, "the elements of an array must have one type; put quotation marks around texts");
  }
  const auto collect = [&](auto element) {
    std::vector<decltype(element)> out;
    for (const auto& value : values) out.push_back(std::get<decltype(element)>(value));
    return ParameterValue(std::move(out));
  };
  if (kinds[1]) return collect(bool{});
  if (kinds[2]) return collect(std::int64_t{});
  if (kinds[3]) return collect(double{});
  return collect(std::string{});
}

Expected<void> collect_parameters(const YAML::Node& map, const std::string& node, const std::string& prefix,
                                  const std::string& origin, int depth, Collected& out) {
  if (depth > kDeepest) return bad(origin, map, "groups are nested more than 32 deep");
  if (++out.groups > kMostGroups) return bad(origin, map, "more than 10000 groups");
  for (const auto& entry : map) {
    if (!entry.first.IsScalar()) return bad(origin, entry.first, "a parameter's name must be plain text");
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) {
      if (auto ok = collect_parameters(entry.second, node, name + ".", origin, depth + 1, out); !ok)
        return ok;
      continue;
    }
    Expected<ParameterValue> value = entry.second.IsSequence() ? array(entry.second, origin)
                                     : entry.second.IsScalar()
                                         ? Expected<ParameterValue>(scalar(entry.second))
                                         : bad(origin, entry.first, "parameter '" + name + "' has no value");
    if (!value) return tl::unexpected(value.error());
    if (out.parameters.size() >= kMostParameters)
      return bad(origin, entry.first, "more than 10000 parameters");
    out.parameters.push_back(
        {node, name, std::move(*value), origin + ":" + std::to_string(entry.first.Mark().line + 1)});
  }
  return {};
}

Expected<void> collect_nodes(const YAML::Node& map, const std::string& prefix, const std::string& origin,
                             int depth, Collected& out) {
  if (depth > kDeepest) return bad(origin, map, "namespaces are nested more than 32 deep");
  if (++out.groups > kMostGroups) return bad(origin, map, "more than 10000 groups");
  for (const auto& entry : map) {
    if (!entry.first.IsScalar()) return bad(origin, entry.first, "a node's name must be plain text");
    const std::string key = entry.first.Scalar();
    if (key == "ros__parameters") {
      if (prefix.empty())
        return bad(origin, entry.first, "ros__parameters must stand below a node's name or /**");
      if (!entry.second.IsMap())
        return bad(origin, entry.first, "ros__parameters must hold 'name: value' lines");
      if (auto ok = collect_parameters(entry.second, prefix, "", origin, 0, out); !ok) return ok;
      continue;
    }
    if (!entry.second.IsMap()) {
      return bad(origin, entry.first,
                 "'" + key.substr(0, 100) +
                     "' is neither a node nor ros__parameters; write NODE: {ros__parameters: {name: value}}");
    }
    const std::string path = key.starts_with("/") && prefix.empty() ? key : prefix + "/" + key;
    if (auto ok = collect_nodes(entry.second, path, origin, depth + 1, out); !ok) return ok;
  }
  return {};
}

}  // namespace

Expected<std::vector<ParameterOverride>> parse_parameters(const std::string& text,
                                                          const std::string& origin) {
  try {
    const YAML::Node root = YAML::Load(text);
    Collected out;
    if (root.IsNull()) return out.parameters;
    if (!root.IsMap())
      return bad(origin, root, "a parameter file must be NODE: {ros__parameters: {name: value}}");
    if (auto ok = collect_nodes(root, "", origin, 0, out); !ok) return tl::unexpected(ok.error());
    return std::move(out.parameters);
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest,
                origin + ":" + std::to_string(error.mark.line + 1) + ": not valid YAML: " + error.msg);
  }
}

Expected<std::vector<ParameterOverride>> read_parameter_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(Outcome::kInvalidRequest, "cannot open the parameter file " + path);
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return fail(Outcome::kInvalidRequest, "cannot read the parameter file " + path);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestFile)
    return fail(Outcome::kInvalidRequest, "the parameter file " + path + " is larger than 1 MiB");
  return parse_parameters(text, path);
}

Expected<ParameterValue> parse_parameter_value(const std::string& text, const std::string& origin) {
  try {
    const YAML::Node node = YAML::Load(text);
    if (node.IsSequence()) return array(node, origin);
    if (node.IsScalar()) return scalar(node);
    if (node.IsNull()) return ParameterValue(std::string());
    return fail(Outcome::kInvalidRequest,
                origin + ": '" + text.substr(0, 100) + "' is neither a value nor an array");
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest,
                origin + ": '" + text.substr(0, 100) + "' is not valid YAML: " + error.msg);
  }
}

bool matches_node(std::string_view pattern, std::string_view full_name) {
  if (!pattern.empty() && pattern[0] == '/') pattern.remove_prefix(1);
  if (!full_name.empty() && full_name[0] == '/') full_name.remove_prefix(1);
  while (true) {
    const auto part_end = std::min(pattern.find('/'), pattern.size());
    const std::string_view part = pattern.substr(0, part_end);
    const std::string_view rest = pattern.substr(std::min(part_end + 1, pattern.size()));
    if (part == "**") {
      if (rest.empty()) return true;
      for (std::string_view tail = full_name;;) {
        if (matches_node(rest, tail)) return true;
        const auto slash = tail.find('/');
        if (slash == std::string_view::npos) return false;
        tail.remove_prefix(slash + 1);
      }
    }
    const auto name_end = std::min(full_name.find('/'), full_name.size());
    if (part != "*" && part != full_name.substr(0, name_end)) return false;
    const bool pattern_done = part_end >= pattern.size();
    const bool name_done = name_end >= full_name.size();
    if (pattern_done || name_done) return pattern_done && name_done;
    pattern = rest;
    full_name.remove_prefix(name_end + 1);
  }
}

}  // namespace goalnet::ros
