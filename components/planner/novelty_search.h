// Best-first search for something new (Lipovetzky and Geffner, AAAI 2017, best-first width search): states
// with a literal never seen before among states with as many landmarks missing come first, then those with a
// pair of atoms never seen together, and among equals those with fewer missing. It computes no relaxed plans,
// so that it makes many more states than the other searches, and plateaus do not hold it up for long: per
// number of missing landmarks there are at most as many new states as literals.
//
// Guided by a relaxed plan as well, states count as alike only if also as many facts of the relaxed plan have
// come true that was made where the number of missing landmarks last fell (the same authors, BFWS(f5)): that
// leads over long ways on which no landmark lies.
//
// Committed, it forgets all other states whenever fewer landmarks are missing than ever before: the way to
// large plans, but it may end where nothing leads on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/chunks.h"
#include "components/planner/greedy_search.h"
#include "components/planner/landmarks.h"
#include "components/planner/plan.h"
#include "components/planner/pruning.h"
#include "components/planner/relaxed_plan.h"
#include "components/planner/state_table.h"
#include "components/planner/successors.h"

namespace goalnet::planner {

class NoveltySearch {
 public:
  using Result = GreedySearch::Result;

  // `most_states`: generated before giving up with kLimit; `most_bytes` likewise with kMemory (0 = no limit).
  // Only plans cheaper than `upper_bound` count. A committed search answers kLimit where it ends without a
  // plan. `plans`: makes the relaxed plans of a guided search, or null; each counts as many states.
  Result search(const GroundTask& task, Landmarks& landmarks, const Word* initial, std::int64_t upper_bound,
                std::int64_t most_states, std::int64_t most_bytes, bool committed, RelaxedPlanner* plans,
                Budget& budget, Statistics& statistics, const Pruning& pruning);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  static constexpr std::size_t kGuideWords = 2;  // relaxed plans are cut off after so many facts
  struct Guide {
    std::vector<Literal> facts;
  };
  struct Node {
    std::int64_t g = 0;
    std::int32_t parent = -1;
    std::int32_t action = -1;
    std::int32_t missing = 0;
    std::int32_t guide = -1;               // in guides_
    std::array<Word, kGuideWords> came{};  // its facts that held on the way from there
  };
  struct Entry {
    std::int32_t old = 0;  // 0: with a new literal; 1: with a new pair; 2: with neither
    std::int32_t missing = 0;
    std::int32_t node = 0;
    bool operator<(const Entry& other) const {
      if (old != other.old) return old > other.old;
      if (missing != other.missing) return missing > other.missing;
      return node > other.node;  // first in, first out
    }
  };

  // `alike`: the class of states that the state is compared with.
  bool is_new(const GroundTask& task, const Word* state, std::size_t alike);
  // Looks at the pairs with an atom that does not hold in `before`, a state of the same class, or null.
  bool is_new_pair(const GroundTask& task, const Word* state, const Word* before, std::size_t alike);
  // Counts the landmarks missing in the state and queues it, unless its relaxed plan says that it leads
  // nowhere.
  std::int32_t push(const GroundTask& task, Landmarks& landmarks, std::int32_t id, bool committed,
                    RelaxedPlanner* plans, Budget& budget, Statistics& statistics);
  // The relaxed plan that the node goes by, and what of it has come true. False: there is none.
  bool guide(const GroundTask& task, std::int32_t id, RelaxedPlanner& plans, Budget& budget,
             Statistics& statistics);
  std::size_t class_of(const Node& node) const;
  void forget_seen();
  const Word* reached(std::int32_t id) { return reached_[static_cast<std::size_t>(id)]; }
  std::int64_t bytes() const;

  Successors successors_;
  StateTable states_;
  Chunks<Node> nodes_;
  ChunkedHeap<Entry> heap_;
  Rows reached_;  // by state: landmarks
  std::size_t landmark_words_ = 1;
  std::vector<Guide> guides_;
  std::vector<std::vector<Word>> seen_true_, seen_false_;  // by class: atoms
  std::vector<std::vector<Word>> seen_pairs_;              // likewise: a row of atoms for every atom
  std::size_t pair_bytes_ = 0, most_pair_bytes_ = 0;
  std::vector<Word> next_, next_reached_, key_;
  std::vector<std::int32_t> applicable_, plan_;
};

}  // namespace goalnet::planner
