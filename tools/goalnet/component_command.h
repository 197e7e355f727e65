#pragma once

namespace goalnet::tools {

// goalnet component NAME [--ros-args …]: one component as a process of its own, until Ctrl-C. Returns the
// exit code: 0 after Ctrl-C or SIGTERM, 13 where name, arguments or files make no sense.
int component_command(int argc, char** argv);

}  // namespace goalnet::tools
