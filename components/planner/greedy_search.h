// Finds some plan quickly where an optimal one is out of reach: lazy greedy best-first search with the
// relaxed-plan heuristic and preferred actions (Helmert's Fast Downward, JAIR 2006, queues with boosting),
// and lookahead: each relaxed plan is carried out as far as it goes (Vidal's YAHSP, ICAPS 2004). Goals that
// the relaxed plan would undo again count as reached too early: that orders towers from the bottom up.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/chunks.h"
#include "components/planner/open_lists.h"
#include "components/planner/plan.h"
#include "components/planner/pruning.h"
#include "components/planner/relaxed_plan.h"
#include "components/planner/state_table.h"

namespace goalnet::planner {

class GreedySearch {
 public:
  enum class Result { kFound, kExhausted, kStopped, kLimit, kMemory };

  // kLazy takes the parent's estimate for a state's until it comes up, and looks ahead: quick where the way
  // is easy. kEager estimates every successor and counts goals reached too early: steady where the order of
  // goals matters.
  enum class Style { kLazy, kEager };

  // `most_states`: evaluated before giving up with kLimit; `most_bytes` likewise with kMemory (0 = no limit).
  // Only plans cheaper than `upper_bound` count.
  Result search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial,
                std::int64_t upper_bound, std::int64_t most_states, std::int64_t most_bytes, Budget& budget,
                Statistics& statistics, const Pruning& pruning, Style style = Style::kLazy);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  struct Node {
    std::int32_t parent = -1;
    std::int32_t action = -1;
    std::int64_t g = 0;
    bool opened = false;  // evaluated; states on the way of a lookahead are not
  };
  enum List : std::size_t { kAll, kPreferred, kLists };

  std::int64_t bytes() const;
  void note_goals(const GroundTask& task);
  // Goals that hold in `state` but that the last relaxed plan would undo: they were reached too early.
  std::int64_t undone_goals(const GroundTask& task, const RelaxedPlanner& heuristic, const Word* state);
  // Carries out the last relaxed plan from state `id`, as far as its actions apply in some order. The new
  // state where that ends, or -1.
  std::int32_t look_ahead(const GroundTask& task, const RelaxedPlanner& heuristic, const Pruning& pruning,
                          std::int32_t id, std::int64_t upper_bound, Budget& budget);

  StateTable states_;
  Chunks<Node> nodes_;
  OpenLists<kLists> open_;
  std::vector<Word> next_, key_;
  std::vector<std::int32_t> rest_;
  std::vector<std::uint8_t> is_goal_;  // by literal; 2 while counted
  std::vector<Literal> undone_;
  std::vector<std::int32_t> applicable_, helpful_;
  std::vector<std::int32_t> plan_;
};

}  // namespace goalnet::planner
