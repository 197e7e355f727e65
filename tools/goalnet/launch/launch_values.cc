#include "tools/goalnet/launch/launch_values.h"

#include <algorithm>
#include <sstream>

namespace goalnet::tools {

void slip(const YAML::Node& node, const std::string& what) { throw Slip{node.Mark(), what}; }

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_keys(const YAML::Node& map, const std::string& what, std::initializer_list<const char*> known) {
  if (!map.IsMap()) slip(map, what + " must be a map of names and values");
  for (const auto& entry : map) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    slip(entry.first, what + " has no key '" + key.substr(0, 60) +
                          "'; known: " + listed(std::vector<std::string>(known.begin(), known.end())));
  }
}

void LaunchValues::take_arguments(const YAML::Node& declared,
                                  const std::map<std::string, std::string>& given) {
  if (declared) {
    if (!declared.IsMap()) slip(declared, "'arguments' must be a map of names and default values");
    for (const auto& entry : declared) {
      if (!entry.second.IsScalar() && !entry.second.IsNull())
        slip(entry.second, "an argument's default must be plain text");
      arguments_[entry.first.as<std::string>()] = entry.second.IsNull() ? "" : entry.second.Scalar();
    }
  }
  for (const auto& [name, value] : given) {
    if (!arguments_.contains(name)) {
      std::vector<std::string> known;
      for (const auto& [one, ignored] : arguments_) known.push_back(one);
      throw Slip{YAML::Mark::null_mark(),
                 "there is no argument '" + name.substr(0, 60) +
                     "'; this file has: " + (known.empty() ? "none" : listed(known))};
    }
    arguments_[name] = value;
  }
}

// A scalar with its ${names} replaced.
std::string LaunchValues::text(const YAML::Node& node) const {
  if (!node.IsScalar()) slip(node, "plain text is needed here");
  const std::string& raw = node.Scalar();
  std::string out;
  for (std::size_t at = 0; at < raw.size();) {
    const std::size_t open = raw.find("${", at);
    out += raw.substr(at, open - at);
    if (open == std::string::npos) break;
    const std::size_t close = raw.find('}', open);
    if (close == std::string::npos) slip(node, "'${' without '}'");
    const std::string name = raw.substr(open + 2, close - open - 2);
    const auto found = arguments_.find(name);
    if (found == arguments_.end())
      slip(node, "${" + name.substr(0, 60) + "} is not among the file's arguments");
    out += found->second;
    at = close + 1;
  }
  return out;
}

double LaunchValues::number(const YAML::Node& node, const std::string& name, double least,
                            double most) const {
  double value = 0;
  std::istringstream in(text(node));
  if (!(in >> value) || !in.eof() || !(value >= least && value <= most)) {
    std::ostringstream what;
    what << "'" << name << "' must be a number from " << least << " to " << most;
    slip(node, what.str());
  }
  return value;
}

bool LaunchValues::flag(const YAML::Node& node, const std::string& name) const {
  const std::string word = text(node);
  if (word != "true" && word != "false") slip(node, "'" + name + "' must be true or false");
  return word == "true";
}

std::map<std::string, std::string> LaunchValues::texts_by_name(const YAML::Node& node,
                                                               const std::string& what) const {
  if (!node.IsMap()) slip(node, "'" + what + "' must be a map of names and values");
  std::map<std::string, std::string> out;
  for (const auto& entry : node) out[text(entry.first)] = text(entry.second);
  return out;
}

}  // namespace goalnet::tools
