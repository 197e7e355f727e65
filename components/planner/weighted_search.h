// Makes a plan cheaper: lazy weighted A* with relaxed plans and a queue of its own for preferred actions, run
// again with a smaller weight, and below the cost found, as long as that helps (Richter, Thayer and Ruml,
// ICAPS 2010, restarting weighted A*). A state met again on a cheaper way is opened again.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/chunks.h"
#include "components/planner/greedy_search.h"
#include "components/planner/open_lists.h"
#include "components/planner/plan.h"
#include "components/planner/pruning.h"
#include "components/planner/relaxed_plan.h"
#include "components/planner/state_table.h"

namespace goalnet::planner {

class WeightedSearch {
 public:
  using Result = GreedySearch::Result;

  // A plan cheaper than `upper_bound`, each estimate taken `weight` times. kExhausted: there is none.
  // `most_bytes`: of tables before giving up with kMemory (0 = no limit).
  Result search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial,
                std::int64_t upper_bound, std::int64_t weight, std::int64_t most_bytes, Budget& budget,
                Statistics& statistics, const Pruning& pruning);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  struct Node {
    std::int64_t g = 0;
    std::int32_t parent = -1, action = -1;
  };
  enum List : std::size_t { kAll, kPreferred, kLists };

  void open(const GroundTask& task, RelaxedPlanner& heuristic, std::int32_t id, std::int64_t weight,
            Budget& budget, Statistics& statistics);
  void extract(std::int32_t id);
  std::int64_t bytes() const;

  StateTable states_;
  Chunks<Node> nodes_;
  OpenLists<kLists> open_;
  std::int64_t best_h_ = 0;
  std::vector<Word> next_, key_;
  std::vector<std::int32_t> plan_;
};

}  // namespace goalnet::planner
