// Binary features of a candidate action, hashed. Weights are shared over objects: an object counts by what it
// is and how it is named, not by which it is.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
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

// What is the same for an action all through a run.
struct ActionHints {
  std::uint32_t votes = 0, habits = 0;  // how far neighbours did it, by class and by object, see vote_code()
  std::size_t by_class = 0, by_object = 0;  // number among the steps of plans
};

// Everything about a decision that its candidates share. Make one per decision; it refers to its arguments.
class FeatureContext {
 public:
  FeatureContext(const Instruction& instruction, const Hints& hints, const PartialRun& run);

  ActionHints hints(const SymAction& action) const;
  // Append features of `action` to `out`; numbers below kFeatureBuckets, possibly repeated. The fixed ones
  // are the same all through a run. `earlier`: empty, or from another moment of the same run and action.
  void extract_fixed(const SymAction& action, const ActionHints& hints,
                     std::vector<std::uint32_t>& out) const;
  void extract_moment(const SymAction& action, const ActionHints& hints, EarlierFeatures& earlier,
                      std::vector<std::uint32_t>& out) const;

 private:
  struct ObjectCode {
    std::uint32_t mention = 0, state = 0, before = 0, class_code = 0, rank = 0, place = 0, name = 0;
    std::uint32_t clause = 0, contents = 0, turn = 0, last_use = 0, last_place = 0;
    bool place_named = false;
    int mention_index = -1;
    std::uint64_t changing = 0;  // all that changes during a run, as one number
  };
  // A step of the grammar's reading.
  struct ReadStep {
    SymAction action;
    std::uint32_t x_class, y_class;
    std::uint32_t match;  // what reading_code() says of the same action
  };
  ObjectCode make_code(std::size_t object) const;  // all but where it is and what is in it
  void place_objects();
  void read_steps();
  // Of an object of this world, or `other`, made for what is none.
  const ObjectCode& code(Symbol object, ObjectCode& other) const;
  float vote(const SymAction& action) const;
  float stop_vote() const;
  StepKey class_key(const SymAction& action) const;
  float habit(const SymAction& action) const;
  static constexpr std::uint32_t kReadingCodes = 16;
  std::uint32_t reading_code(const SymAction& action, const ObjectCode& x, const ObjectCode& y) const;
  std::uint32_t class_code(Symbol symbol) const;
  std::uint32_t repeats(const SymAction& action, std::uint32_t x_class) const;
  void extract_stop(std::vector<std::uint32_t>& out) const;

  const Instruction& instruction_;
  const Hints& hints_;
  const PartialRun& run_;
  std::vector<std::uint8_t> handled_;                // per object: 1 moved or used, 2 as a place
  std::vector<std::uint8_t> near_or_held_;           // per object: 1 held, 2 near, of the robot
  std::vector<std::uint8_t> last_use_, last_place_;  // per object: the verb last done with it, 0 none
  std::vector<ObjectCode> codes_;                    // of the instruction's objects
  int next_mention_ = 0;                             // the first that nothing was done with yet
  std::uint32_t world_ = 0;                          // which devices are on or open
  std::uint32_t read_ = 0;                           // how much of the grammar's reading was done
  std::vector<ReadStep> reading_;
  std::vector<std::pair<Verb, std::uint32_t>> done_;  // of each action of the run, with the class of its x
  std::uint32_t named_, named_handled_, held_named_, held_;
  static constexpr std::uint32_t kSteps = 7;
  std::uint32_t step_;
  SymAction last_, before_last_;
  NextSteps next_by_words_, next_by_room_;
};

}  // namespace goalnet::inference
