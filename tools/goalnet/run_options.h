// What `goalnet run` was asked to do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::tools {

struct RunOptions {
  std::string instruction;        // empty with --goal
  Goal goal;                      // empty with an instruction
  std::string scene = "kitchen";  // a name in config/scenes or a file
  std::string robot;              // a file; empty: config/robots/default.yaml
  std::string model;              // a file; empty: config/models/goalnet.safetensors
  std::uint64_t seed = 1;
  std::uint32_t max_steps = 0;          // 0: the coordinator's parameter
  double max_sim_time = 0.0;            // [s] 0: the coordinator's parameter
  std::string render;                   // folder for a picture after each action; empty: none
  std::string record;                   // directory of a bag of everything; empty: none
  std::string record_storage = "mcap";  // or sqlite3
  bool untidy = false;                  // things lie about, as the seed has it
  std::string start;                    // file of a world state to start from; empty: the scene's
  bool json = false;
  bool private_run = false;                // takes part in no domain
  bool verbose = false;                    // components log to standard error
  std::vector<std::string> ros_arguments;  // after --ros-args
};

// Parses the arguments; argv[0] is "goalnet run". After --help, which prints by itself, `help_shown` is set.
// A slip is kInvalidRequest; whether it is to be told as JSON is known even then.
struct ParsedRun {
  RunOptions options;
  bool help_shown = false;
  std::optional<Error> refused;
};
ParsedRun parse_run_options(int argc, char** argv);

}  // namespace goalnet::tools
