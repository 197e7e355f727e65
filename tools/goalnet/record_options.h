// What `goalnet record` and `goalnet replay` were asked to do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/player.h"
#include "components/ros/bag/recorder.h"

namespace goalnet::tools {

struct ParsedRecord {
  ros::RecorderOptions options;
  std::string repair;                      // a directory: nothing is recorded, this is made whole
  std::vector<std::string> ros_arguments;  // after --ros-args
  bool help_shown = false;
};
// argv[0] is "goalnet record". A slip is kInvalidRequest.
Expected<ParsedRecord> parse_record_options(int argc, char** argv);

struct ParsedReplay {
  std::string bag;  // directory or file
  ros::PlayerOptions options;
  std::vector<std::string> ros_arguments;
  bool help_shown = false;
};
Expected<ParsedReplay> parse_replay_options(int argc, char** argv);

}  // namespace goalnet::tools
