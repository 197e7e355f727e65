// The thorough way to some plan: lazy greedy best-first search that alternates between two estimates, the
// relaxed plan and the number of landmarks still missing, each with a queue of its own for preferred actions
// (LAMA; Richter and Westphal, JAIR 2010). Where relaxed plans mislead, as in tall towers, the order of
// landmarks leads on.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/chunks.h"
#include "components/planner/greedy_search.h"
#include "components/planner/landmarks.h"
#include "components/planner/open_lists.h"
#include "components/planner/plan.h"
#include "components/planner/pruning.h"
#include "components/planner/relaxed_plan.h"
#include "components/planner/state_table.h"

namespace goalnet::planner {

class LandmarkSearch {
 public:
  using Result = GreedySearch::Result;

  // `most_states`: evaluated before giving up with kLimit; `most_bytes` likewise with kMemory (0 = no limit).
  // Only plans cheaper than `upper_bound` count.
  Result search(const GroundTask& task, RelaxedPlanner& heuristic, Landmarks& landmarks, const Word* initial,
                std::int64_t upper_bound, std::int64_t most_states, std::int64_t most_bytes, Budget& budget,
                Statistics& statistics, const Pruning& pruning);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  struct Node {
    std::int64_t g = 0;
    std::int32_t parent = -1;
    std::int32_t action = -1;
  };
  enum List : std::size_t { kByPlan, kByPlanPreferred, kByLandmarks, kByLandmarksPreferred, kLists };

  void open(const GroundTask& task, RelaxedPlanner& heuristic, Landmarks& landmarks, std::int32_t id,
            Budget& budget, Statistics& statistics);
  std::int64_t bytes() const;
  const Word* reached(std::int32_t id) { return reached_[static_cast<std::size_t>(id)]; }

  StateTable states_;
  Chunks<Node> nodes_;
  Rows reached_;  // by state: its landmarks
  std::size_t landmark_words_ = 1;
  OpenLists<kLists> open_;
  std::int64_t best_by_plan_ = 0, best_by_landmarks_ = 0;
  std::vector<Word> next_, next_reached_, key_;
  std::vector<std::uint8_t> preferred_;  // by action
  std::vector<std::int32_t> plan_;
};

}  // namespace goalnet::planner
