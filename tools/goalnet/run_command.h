#pragma once

namespace goalnet::tools {

// goalnet run: see run_options.h. Returns the exit code.
int run_command(int argc, char** argv);

}  // namespace goalnet::tools
