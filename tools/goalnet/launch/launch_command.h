#pragma once

namespace goalnet::tools {

// goalnet launch FILE [NAME:=VALUE …] [--json]: starts, watches and restarts processes until Ctrl-C. Returns
// the exit code: 0 after Ctrl-C or SIGTERM or when all have ended well, 13 for a file that makes no sense, 32
// when a required process is lost.
int launch_command(int argc, char** argv);

}  // namespace goalnet::tools
