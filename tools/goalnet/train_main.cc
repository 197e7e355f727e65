// goalnet-train: the commands of `goalnet` that learn. People type `goalnet`; see command.h.
#include "tools/goalnet/command.h"
#ifdef GOALNET_HAS_NETWORK_TRAINING
#include "tools/goalnet/ablate_command.h"
#else
#include "tools/goalnet/command_line.h"
#endif
#include "tools/goalnet/train_command.h"

namespace goalnet::tools {
namespace {

#ifndef GOALNET_HAS_NETWORK_TRAINING
int ablate_command(int, char**) {
  return tell("goalnet ablate",
              {Outcome::kInvalidRequest,
               "this build cannot train the paper's network, which needs libtorch; \"tools/setup 'build "
               "training' training\" makes build/training/bin/goalnet, which can"},
              false);
}
#endif

constexpr Command kCommands[] = {
    {"train", "learn a model from demonstrations", train_command},
    {"ablate", "train and score the paper's model, its baseline, ablations and explorations", ablate_command},
};

}  // namespace
}  // namespace goalnet::tools

int main(int argc, char** argv) {
  return goalnet::tools::dispatch(goalnet::tools::kCommands,
                                  "usage: goalnet-train COMMAND (use: goalnet COMMAND)\n", argc, argv);
}
