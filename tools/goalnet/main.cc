// The program people type. See command.h for why it is this small.
#include "tools/goalnet/command.h"
#include "tools/goalnet/eval_command.h"
#include "tools/goalnet/infer_command.h"
#include "tools/goalnet/plan_command.h"

namespace goalnet::tools {
namespace {

constexpr const char* kUsage =
    "usage: goalnet COMMAND [arguments]\n"
    "\n"
    "Follows instructions in plain English with a (simulated) robot, as ROS 2-compatible components over "
    "DDS.\n"
    "Try: goalnet run \"fill the mug with water\"\n";

constexpr Command kCommands[] = {
    {"run", "let a simulated robot carry out an instruction", nullptr, "goalnet-robot"},
    {"component", "run one component as a process of its own, as a ROS 2 node", nullptr, "goalnet-robot"},
    {"launch", "start, watch and restart the components of a robot", nullptr, "goalnet-robot"},
    {"tell", "give an instruction to a robot that is up", nullptr, "goalnet-robot"},
    {"record", "record topics into a bag that ros2 bag and Foxglove open", nullptr, "goalnet-robot"},
    {"replay", "publish what a bag holds", nullptr, "goalnet-robot"},
    {"plan", "solve a PDDL problem", plan_command},
    {"infer", "infer the goal of an instruction in a given world state", infer_command},
    {"eval", "score a model on a folder of demonstrations", eval_command},
    {"train", "learn a model from demonstrations", nullptr, "goalnet-train"},
    {"ablate", "train and score the paper's network without each of its parts (needs libtorch)", nullptr,
     "goalnet-train"},
    {"bench", "measure speed: inference, planning, motion, real-time factor, jitter", nullptr,
     "goalnet-robot"},
};

}  // namespace
}  // namespace goalnet::tools

int main(int argc, char** argv) {
  return goalnet::tools::dispatch(goalnet::tools::kCommands, goalnet::tools::kUsage, argc, argv);
}
