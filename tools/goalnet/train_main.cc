// goalnet-train: the commands of `goalnet` that learn. People type `goalnet`; see command.h.
#include "tools/goalnet/command.h"
#ifdef GOALNET_HAS_NETWORK_TRAINING
#include "tools/goalnet/ablate_command.h"
#endif
#include "tools/goalnet/train_command.h"

namespace goalnet::tools {
namespace {

constexpr Command kCommands[] = {
    {"train", "learn a model from demonstrations", train_command},
#ifdef GOALNET_HAS_NETWORK_TRAINING
    {"ablate", "train and score the paper's model, its baseline, ablations and explorations", ablate_command},
#endif
};

}  // namespace
}  // namespace goalnet::tools

int main(int argc, char** argv) {
  return goalnet::tools::dispatch(goalnet::tools::kCommands,
                                  "usage: goalnet-train COMMAND (use: goalnet COMMAND)\n", argc, argv);
}
