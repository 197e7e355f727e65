// Some plan, quickly: searches of different temper take turns, each turn with four times the effort of the
// one before, because they fail on different problems. Effort is counted in states, not seconds, so that
// every machine finds the same.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/greedy_search.h"
#include "components/planner/plan.h"
#include "components/planner/relaxed_plan.h"

namespace goalnet::planner {

struct SatisficingOptions {
  std::int64_t upper_bound = INT64_MAX / 4;  // only plans cheaper than this count
  std::int64_t bytes = 0;                    // of one search's tables; 0 = no limit
  int turns = 1 << 20;
  bool best_of_turn =
      false;  // do not stop at the first plan, but let the others of its turn try for a cheaper one
};

class SatisficingSearch {
 public:
  using Result = GreedySearch::Result;

  // kExhausted: there is no plan below the bound at all. kLimit: the turns are used up.
  Result search(const RelaxedTask& relaxed, RelaxedPlanner& heuristic, const Word* initial,
                const SatisficingOptions& options, Budget& budget, Statistics& statistics);
  // Cheaper plans than `upper_bound`, one after the other, until the budget or the memory is used up; each is
  // told. kFound: there was one. kExhausted: there is none, so that the last one told, or the one that gave
  // the bound, is a cheapest plan.
  Result improve(const RelaxedTask& relaxed, RelaxedPlanner& heuristic, const Word* initial,
                 const SatisficingOptions& options, Budget& budget, Statistics& statistics,
                 const std::function<void()>& tell);
  const std::vector<std::int32_t>& plan() const { return plan_; }
  std::int64_t cost() const { return cost_; }
  const std::string& method() const { return method_; }

 private:
  std::vector<std::int32_t> plan_;
  std::int64_t cost_ = 0;
  std::string method_;
};

// Leaves out actions that the plan does not need: each is tried, together with what no longer applies without
// it. Greedy.
void shorten_plan(const GroundTask& task, const Word* initial, Budget& budget,
                  std::vector<std::int32_t>* plan);

}  // namespace goalnet::planner
