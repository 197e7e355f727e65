// Greedy decoding of one step's predicates, within the grammar and what is not true yet.
#pragma once

#include <vector>

#include "components/goalnet/network/encoded_world.h"
#include "components/goalnet/network/grammar.h"
#include "components/goalnet/network/network.h"

namespace goalnet::inference::network {

// A predicate in terms of the world's objects; second or value is -1 where it has none.
struct DecodedPredicate {
  int token = kStopToken;
  int main = -1, second = -1, value = -1;
  bool operator==(const DecodedPredicate&) const = default;
};

struct DecodedGoal {
  std::vector<DecodedPredicate> predicates;
  double log_probability = 0;  // of all choices, the closing stop included
  int choices = 0;             // how many there were
};

// Not thread-safe; allocates only while its buffers grow.
class Decoder {
 public:
  Decoder(const NetworkConfig& config, const Grammar& grammar) : config_(config), grammar_(grammar) {}

  // Continues from network.start(). Ties go to the lower index.
  void decode(Network& network, const EncodedWorld& world, DecodedGoal& out);

 private:
  bool main_admitted(int token, int object, const EncodedWorld& world, const DecodedGoal& so_far) const;
  bool second_admitted(int token, int main, int object, const EncodedWorld& world,
                       const DecodedGoal& so_far) const;
  bool value_admitted(int token, int main, int value, const EncodedWorld& world,
                      const DecodedGoal& so_far) const;
  // The best admitted choice and its probability among the admitted ones; -1 when none is admitted.
  int choose(const Vector& scores, Eigen::Index count, DecodedGoal& out);

  const NetworkConfig& config_;
  const Grammar& grammar_;
  std::vector<std::uint8_t> admitted_;
};

}  // namespace goalnet::inference::network
