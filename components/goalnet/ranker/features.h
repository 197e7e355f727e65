// Binary features of a candidate action, hashed. Weights are shared over objects: an object counts by what it
// is and how it is named, not by which it is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/goalnet/ranker/feature_codes.h"
#include "components/goalnet/ranker/hints.h"
#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/ranker/next_steps.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// A run so far: where it is, what was done (macro actions, see with_means).
struct PartialRun {
  SymState now;
  std::vector<SymAction> actions;
};

// Everything about a decision that its candidates share. Make one per decision; it refers to its arguments.
class FeatureContext {
 public:
  FeatureContext(const Instruction& instruction, const Lexicon& lexicon, const Hints& hints,
                 const PartialRun& run);

  // Append features of `action` to `out`; numbers below kFeatureBuckets, possibly repeated. The fixed ones
  // are the same all through a run.
  void extract_fixed(const SymAction& action, std::vector<std::uint32_t>& out) const;
  void extract_moment(const SymAction& action, std::vector<std::uint32_t>& out) const;

 private:
  struct ObjectCode {
    std::uint32_t mention = 0, state = 0, before = 0, class_code = 0, rank = 0, place = 0, name = 0;
    std::uint32_t clause = 0, contents = 0, turn = 0, last_use = 0, last_place = 0;
    bool named = false, held = false, handled = false, place_named = false;
    int index = -1, mention_index = -1;
  };
  ObjectCode make_code(std::size_t object) const;  // all but where it is and what is in it
  void place_objects();
  ObjectCode code(Symbol object) const;
  float vote(const SymAction& action, const ObjectCode& x, const ObjectCode& y) const;
  float stop_vote() const;
  StepKey class_key(const SymAction& action) const;
  float habit(const SymAction& action) const;
  std::uint32_t reading_code(const SymAction& action, const ObjectCode& x, const ObjectCode& y) const;
  std::uint32_t class_code(Symbol symbol) const;
  std::uint32_t repeats(const SymAction& action, std::uint32_t x_class) const;
  void extract_stop(std::vector<std::uint32_t>& out) const;

  const Instruction& instruction_;
  const Lexicon& lexicon_;
  const Hints& hints_;
  const PartialRun& run_;
  std::vector<std::uint8_t> handled_;                // per object: 1 moved or used, 2 as a place
  std::vector<std::uint8_t> last_use_, last_place_;  // per object: the verb last done with it, 0 none
  std::vector<ObjectCode> codes_;                    // of the instruction's objects
  int next_mention_ = 0;                             // the first that nothing was done with yet
  std::uint32_t world_ = 0;                          // which devices are on or open
  std::uint32_t read_ = 0;                           // how much of the grammar's reading was done
  std::uint32_t named_, named_handled_, held_named_, held_;
  std::uint32_t step_;
  SymAction last_, before_last_;
  NextSteps next_by_words_, next_by_room_;
};

}  // namespace goalnet::inference
