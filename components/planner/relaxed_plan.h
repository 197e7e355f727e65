// Relaxed plans by cheapest supporters (h-add): an inadmissible but informed estimate, preferred actions, and
// often the plan itself, because executing a relaxed plan in a sensible order already reaches most household
// goals.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/cost_queue.h"
#include "components/planner/growing.h"
#include "components/planner/relaxed_task.h"

namespace goalnet::planner {

class RelaxedPlanner {
 public:
  static constexpr std::int64_t kDeadEnd = INT64_MAX / 4;

  // Makes the tables for a task. If the budget runs out, nothing may be asked before the next restart().
  void restart(const RelaxedTask& relaxed, Budget& budget);
  // Whether every action is taken to cost 1, whatever it costs: cheap plans are not always those that are
  // found first. Off after restart().
  void count_actions(bool on) { counts_actions_ = on; }
  // The cost of a relaxed plan from `state`, or kDeadEnd. Where actions may be free, each counts one more.
  std::int64_t evaluate(const Word* state, Budget& budget);
  // Its actions, each after what it needs: the order in which a person would do them.
  const std::vector<std::int32_t>& actions() const { return plan_; }

  // Actions applicable in the state last evaluated, as far as they have a wanted effect there.
  const std::vector<std::int32_t>& applicable() const { return applicable_; }

  // Runs relaxed plans from `state` one after the other as far as their actions apply. True if the goal is
  // reached; `plan` then holds the real plan.
  bool execute(const Word* state, Budget& budget, std::vector<std::int32_t>* plan);

 private:
  void explore(const Word* state, Budget& budget);
  void reach(Proposition p, std::int64_t cost, std::int32_t op);
  void extract(Proposition goal);

  std::int64_t cost_of_action(std::int32_t action) const {
    return counts_actions_ ? 1 : relaxed_->task().actions[static_cast<std::size_t>(action)].cost + extra_;
  }
  std::int64_t cost_of(const RelaxedOperator& op) const {
    return op.action < 0 ? 0 : cost_of_action(op.action);
  }

  const RelaxedTask* relaxed_ = nullptr;
  bool counts_actions_ = false;
  std::int64_t extra_ =
      0;  // per action: 1 if some are free, so that only what applies at once is reached for nothing
  Growing<std::int64_t> cost_;         // by proposition
  Growing<std::int32_t> best_;         // by proposition: its cheapest producer, -1 = holds
  Growing<std::int32_t> unsatisfied_;  // by operator
  Growing<std::int64_t> sum_;          // by operator
  Growing<std::uint8_t> marked_;       // by proposition: extracted
  Growing<std::uint8_t> in_plan_;      // by action
  Growing<std::uint8_t> listed_;       // by action: in applicable_
  std::vector<std::int32_t> plan_, applicable_;
  std::vector<std::pair<Proposition, std::uint32_t>> stack_;
  std::vector<std::int32_t> rest_;
  std::vector<Word> current_, next_;
  CostQueue queue_;
};

}  // namespace goalnet::planner
