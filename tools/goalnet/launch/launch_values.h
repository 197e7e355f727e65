// The values in a launch file: checked, and with its arguments put in for ${names}.
#pragma once

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace goalnet::tools {

// What is wrong, and where. Thrown by all functions below and caught in launch_file.cc: YAML errors come as
// exceptions anyway.
struct Slip {
  YAML::Mark mark;
  std::string what;
};
[[noreturn]] void slip(const YAML::Node& node, const std::string& what);

// "a, b, c"
std::string listed(const std::vector<std::string>& words);

// That `map` is a map with no other keys than these. `what` names it: "process 'a'".
void check_keys(const YAML::Node& map, const std::string& what, std::initializer_list<const char*> known);

class LaunchValues {
 public:
  // `declared`: the file's arguments with their defaults, or nothing; `given`: what replaces them.
  void take_arguments(const YAML::Node& declared, const std::map<std::string, std::string>& given);

  std::string text(const YAML::Node& node) const;
  double number(const YAML::Node& node, const std::string& name, double least, double most) const;
  bool flag(const YAML::Node& node, const std::string& name) const;
  std::map<std::string, std::string> texts_by_name(const YAML::Node& node, const std::string& what) const;

 private:
  std::map<std::string, std::string> arguments_;
};

}  // namespace goalnet::tools
