// goalnet record: what goes over the topics, into a bag.
#pragma once

namespace goalnet::tools {

// argv[0] is "goalnet record". Returns the exit code.
int record_command(int argc, char** argv);

}  // namespace goalnet::tools
