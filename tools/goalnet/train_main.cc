// goalnet-train: the commands of `goalnet` that learn. People type `goalnet`; see command.h.
#include "tools/goalnet/command.h"
#include "tools/goalnet/train_command.h"

namespace goalnet::tools {
namespace {

constexpr Command kCommands[] = {
    {"train", "learn a model from demonstrations", train_command},
};

}  // namespace
}  // namespace goalnet::tools

int main(int argc, char** argv) {
  return goalnet::tools::dispatch(goalnet::tools::kCommands,
                                  "usage: goalnet-train COMMAND (use: goalnet COMMAND)\n", argc, argv);
}
