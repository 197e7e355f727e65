// Recorded neighbours of an instruction: who said something alike, and what was done then.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "components/goalnet/ranker/example.h"
#include "components/goalnet/ranker/features.h"

namespace goalnet::inference {

struct Neighbour {
  const Example* example = nullptr;
  float similarity = 0;  // 0..1, cosine of weighted words and pairs of words
};

class Neighbours {
 public:
  // Keeps pointers; the examples must outlive this.
  explicit Neighbours(std::vector<const Example*> examples, bool grounding);

  // The most alike, best first; those of `without_scenario` left out.
  std::vector<Neighbour> nearest(const Instruction& instruction, const SymState& state, std::size_t count,
                                 const std::string& without_scenario = {}) const;

 private:
  struct Row {
    const Example* example;
    std::vector<std::pair<std::uint32_t, float>> vector;  // sorted by hash, normalised
  };
  std::vector<std::pair<std::uint32_t, float>> vector_of(const Instruction& instruction, const SymState& state) const;

  bool grounding_;
  std::vector<Row> rows_;
  std::unordered_map<std::uint32_t, float> weight_;  // inverse document frequency
  float unseen_weight_ = 1;
};

// What the neighbours did, by class.
std::vector<NeighbourVote> votes(const std::vector<Neighbour>& neighbours, bool grounding);

// The neighbour's actions carried over: objects that the neighbour's instruction named become those that this one
// names, the others stay. Actions that are not possible here are left out.
std::vector<SymAction> replay(const Example& neighbour, const Instruction& instruction, bool grounding);

}  // namespace goalnet::inference
