// What this build can train.
#include "tools/goalnet/train_kinds.h"

#include "tools/goalnet/train_ranker_kind.h"
#ifdef GOALNET_HAS_NETWORK_TRAINING
#include "tools/goalnet/train_network_kind.h"
#endif

namespace goalnet::tools {
namespace {

constexpr TrainKind kKinds[] = {
    {"ranker", "the model that ships: feature-sharing ranker with re-ranking (about a minute)",
     train_ranker_kind},
#ifdef GOALNET_HAS_NETWORK_TRAINING
    {"network", "the paper's GoalNet network (about a minute and a half)", train_network_kind},
#endif
};

}  // namespace

std::span<const TrainKind> train_kinds() { return kKinds; }

}  // namespace goalnet::tools
