// The commands of `goalnet`: what they are called, what they do, and where they live.
//
// `goalnet plan` must start and end within 3 ms, so the program people type links nothing but what planning
// and inference need. The commands that move a robot bring DDS, Bullet and OMPL; they live in a second
// program, goalnet-robot, and training in a third, goalnet-train (libtorch). `goalnet` replaces itself by
// them.
#pragma once

#include <span>
#include <string_view>

namespace goalnet::tools {

// argv[0] is "goalnet NAME". Returns the exit code: the number of an Outcome (0; 10-19; 20-29; 30-39).
using CommandFunction = int (*)(int argc, char** argv);

struct Command {
  std::string_view name;
  std::string_view summary;
  CommandFunction function = nullptr;  // here, or
  std::string_view program = {};       // in this program beside us
};

// Becomes the program beside us that has the rest of a command: argv as a CommandFunction has it. Returns
// only if it cannot be started: the exit code.
int become(std::string_view program, std::string_view command, int argc, char** argv);

// Calls argv[1]'s command with the remaining arguments. Prints `usage` for --help (exit 0) and a message with
// the nearest name for an unknown command (exit 13).
int dispatch(std::span<const Command> commands, std::string_view usage, int argc, char** argv);

}  // namespace goalnet::tools
