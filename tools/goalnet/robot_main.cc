// goalnet-robot: the commands of `goalnet` that bring DDS, Bullet and OMPL. People type `goalnet`; see
// command.h.
#include "tools/bench/bench_command.h"
#include "tools/goalnet/command.h"
#include "tools/goalnet/component_command.h"
#include "tools/goalnet/eval_physics_command.h"
#include "tools/goalnet/launch/launch_command.h"
#include "tools/goalnet/record_command.h"
#include "tools/goalnet/replay_command.h"
#include "tools/goalnet/run_command.h"
#include "tools/goalnet/tell_command.h"

namespace goalnet::tools {
namespace {

constexpr Command kCommands[] = {
    {"run", "let a simulated robot carry out an instruction", run_command},
    {"component", "run one component as a process of its own, as a ROS 2 node", component_command},
    {"launch", "start, watch and restart components", launch_command},
    {"tell", "give an instruction to a robot that is up", tell_command},
    {"record", "record topics into a bag", record_command},
    {"replay", "publish what a bag holds", replay_command},
    {"eval", "let the simulated robot carry out recorded instructions (--physics)", eval_physics_command},
    {"bench", "measure speed", bench_command},
};

}  // namespace
}  // namespace goalnet::tools

int main(int argc, char** argv) {
  return goalnet::tools::dispatch(goalnet::tools::kCommands,
                                  "usage: goalnet-robot COMMAND (use: goalnet COMMAND)\n", argc, argv);
}
