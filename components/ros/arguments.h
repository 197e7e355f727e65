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

// What a rule after -r renames. kName: topics and services alike; kTopic and kService: written as
// rostopic://FROM and rosservice://FROM.
enum class RemapKind { kName, kTopic, kService, kNodeName, kNamespace };

struct Remap {
  std::string node;  // "" for every node; else its name, or its full name
  RemapKind kind = RemapKind::kName;
  std::string from;  // "" for kNodeName and kNamespace
  std::string to;
};

struct Arguments {
  std::vector<std::string> remaining;         // what was not for ROS, in order, without the program's name
  std::vector<Remap> remaps;                  // in order: the first that applies wins
  std::vector<ParameterOverride> parameters;  // in order: later ones win
  std::optional<LogLevel> log_level;          // --log-level LEVEL
  std::vector<std::pair<std::string, LogLevel>> logger_levels;  // --log-level NAME:=LEVEL
  std::optional<std::string> enclave;                           // -e, --enclave
  bool rosout = true;                                           // --disable-rosout-logs
  bool console = true;                                          // --disable-stdout-logs

  // What -r __node and -r __ns make of a node that its program calls `name`; nullopt where none applies.
  std::optional<std::string> node_name(const std::string& name) const;
  std::optional<std::string> node_namespace(const std::string& name) const;
  // The level that --log-level gives a logger: that of its own name or of the nearest above it ("robot_1" for
  // "robot_1.planner"), else the one for all.
  std::optional<LogLevel> level_of(const std::string& logger) const;
};

// Takes the arguments after the program's name. Fails with kInvalidRequest and what is wrong, and where.
Expected<Arguments> parse_arguments(const std::vector<std::string>& words);

}  // namespace goalnet::ros
