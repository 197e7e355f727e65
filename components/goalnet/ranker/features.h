// Binary features of a candidate action, hashed. Weights are shared over objects: an object counts by what it
// is and how it is named, not by which it is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

inline constexpr std::uint32_t kFeatureBits = 18;
inline constexpr std::uint32_t kFeatureBuckets = 1u << kFeatureBits;

// What recorded neighbours of the instruction did: how much they speak for an action. See neighbours.h.
struct NeighbourVote {
  Verb verb;
  ClassId x, y;  // classes; kNoClass where the action has no such argument
  float weight;  // 0..1: share of the neighbours that did this anywhere in their run
};
inline constexpr ClassId kNoClass = 0xffff;

// A run so far: where it began, where it is, what was done (macro actions, see with_means).
struct PartialRun {
  SymState start, now;
  std::vector<SymAction> actions;
};

// Everything about a decision that its candidates share. Make one per decision; it refers to its arguments.
class FeatureContext {
 public:
  FeatureContext(const Instruction& instruction, const Lexicon& lexicon, std::span<const NeighbourVote> votes,
                 const PartialRun& run);

  // Appends the features of `action` to `out`; numbers below kFeatureBuckets, possibly repeated.
  void extract(const SymAction& action, std::vector<std::uint32_t>& out) const;

 private:
  struct ObjectCode {
    std::uint32_t mention = 0, state = 0, before = 0, class_code = 0, rank = 0, place = 0, name = 0;
    bool named = false, held = false, handled = false;
    int index = -1;
  };
  ObjectCode code(Symbol object) const;
  float vote(const SymAction& action, ClassId x, ClassId y) const;
  void extract_stop(std::vector<std::uint32_t>& out) const;

  const Instruction& instruction_;
  const Lexicon& lexicon_;
  std::span<const NeighbourVote> votes_;
  const PartialRun& run_;
  std::vector<std::uint8_t> handled_;  // per object: 1 moved or used, 2 as a place
  std::uint32_t named_, named_handled_, held_named_, held_;
  std::uint32_t step_;
  SymAction last_, before_last_;
};

}  // namespace goalnet::inference
