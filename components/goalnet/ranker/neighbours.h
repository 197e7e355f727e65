// Remembered neighbours of an instruction: who said something alike, and what was done then.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "components/goalnet/ranker/example.h"
#include "components/goalnet/ranker/features.h"

namespace goalnet::inference {

using Term = std::pair<std::uint32_t, float>;  // hash, amount

// What is kept of a demonstration: the terms by which instructions are compared, and what was done.
struct Memory {
  struct Step {
    SymAction action;
    ClassId x_class = kNoClass, y_class = kNoClass;
    std::int16_t x_mention = -1, y_mention = -1;  // index into mentions; -1: not named
  };
  std::string scenario;                 // empty in a shipped model
  std::vector<Term> terms;              // sorted by hash, not weighted
  std::vector<std::uint32_t> layout;    // hashes of what stood where at the start, sorted
  std::vector<std::uint32_t> mentions;  // hashes of the phrases
  std::vector<Step> steps;
};

Memory remember(const Example& example, bool grounding);

struct Neighbour {
  const Memory* memory = nullptr;
  float similarity = 0;  // 0..1, cosine of weighted terms
  float layout = 0;      // 0..1: share of the things that stand at the same places
};

class Neighbours {
 public:
  Neighbours() = default;
  explicit Neighbours(std::vector<Memory> memories);

  struct Nearest {
    std::vector<Neighbour> by_words;  // the most alike instructions, best first
    std::vector<Neighbour> by_room;   // the most alike in both words and room, best first
  };
  // At most `count` of each; those of `without_scenario` left out.
  Nearest nearest(const Instruction& instruction, const SymState& state, std::size_t count,
                  const std::string& without_scenario = {}) const;
  const std::vector<Memory>& memories() const { return memories_; }

 private:
  using Postings = std::vector<std::pair<std::uint32_t, float>>;  // memory, amount; by memory

  void weigh(std::vector<Term>& terms) const;

  std::vector<Memory> memories_;
  std::unordered_map<std::uint32_t, Postings> by_term_;                      // weighted and normalised
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_layout_;  // memories, by what stands where
  std::unordered_map<std::uint32_t, float> weight_;                          // inverse document frequency
  float unseen_weight_ = 1;
};

// What the neighbours did, by class.
std::vector<NeighbourVote> votes(std::span<const Neighbour> neighbours);
// What the neighbours by room did, by object.
std::vector<Habit> habits(std::span<const Neighbour> neighbours);

// The neighbour's actions carried over: objects that the neighbour's instruction named become those that this
// one names, the others stay. Actions that are not possible here fall away when played.
std::vector<SymAction> replay(const Memory& memory, const Instruction& instruction);

// All that neighbours and grammar say about an instruction.
Hints make_hints(const Neighbours::Nearest& near, const Instruction& instruction, Reading reading);

}  // namespace goalnet::inference
