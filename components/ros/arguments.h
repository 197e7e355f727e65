// The command line of a ROS 2 node: --ros-args -r from:=to -p name:=value --params-file F ... --.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/logger.h"
#include "components/ros/parameter_value.h"

namespace goalnet::ros {

// A value for a parameter of every node that `node` matches ("/**", "/robot_1/planner", "planner").
struct ParameterOverride {
  std::string node;
  std::string name;
  ParameterValue value;
  std::string origin;  // "params.yaml:12" or "-p", for messages
};

struct Remap {
  std::string node;  // "" for every node
  std::string from;
  std::string to;
};

struct Arguments {
  std::vector<std::string> remaining;         // what was not for ROS, in order, without the program's name
  std::vector<Remap> remaps;                  // __node and __ns are in the two members below
  std::optional<std::string> node_name;       // -r __node:=
  std::optional<std::string> node_namespace;  // -r __ns:=
  std::vector<ParameterOverride> parameters;  // in order: later ones win
  std::optional<LogLevel> log_level;          // --log-level LEVEL
  std::vector<std::pair<std::string, LogLevel>> logger_levels;  // --log-level NAME:=LEVEL
  std::optional<std::string> enclave;                           // -e, --enclave
  bool rosout = true;                                           // --disable-rosout-logs
  bool console = true;                                          // --disable-stdout-logs
};

// Takes the arguments after the program's name. Fails with kInvalidRequest and what is wrong, and where.
Expected<Arguments> parse_arguments(const std::vector<std::string>& words);

}  // namespace goalnet::ros
