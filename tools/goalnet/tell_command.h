// goalnet tell: an instruction for a robot that runs already, over the action /follow_instruction.
#pragma once

namespace goalnet::tools {

// argv[0] is "goalnet tell". Returns the exit code: the outcome of the instruction.
int tell_command(int argc, char** argv);

}  // namespace goalnet::tools
