#pragma once

namespace goalnet::tools {

// `goalnet eval --physics`, in goalnet-robot.
int eval_physics_command(int argc, char** argv);

}  // namespace goalnet::tools
