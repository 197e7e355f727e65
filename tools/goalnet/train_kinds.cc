// What a build with libtorch can train.
#include "tools/goalnet/train_kinds.h"

#include "tools/goalnet/train_network_kind.h"

namespace goalnet::tools {
namespace {

constexpr TrainKind kKinds[] = {
    {"network", "the paper's GoalNet network (about a minute and a half)", train_network_kind},
};

}  // namespace

std::span<const TrainKind> train_kinds() { return kKinds; }

}  // namespace goalnet::tools
