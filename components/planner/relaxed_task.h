// The delete relaxation of a ground task: what once holds stays. Propositions are the needed literals, the
// junctions, gates ("the preconditions of this action hold", where many conditional effects share them) and
// the goal; operators have plain lists of both. An action gives one operator for its unconditional effects
// and one for each conditional effect, an axiom one that is free.
#pragma once

#include <cstdint>
#include <span>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"
#include "components/planner/growing.h"

namespace goalnet::planner {

using Proposition = std::int32_t;

struct RelaxedOperator {
  std::int32_t action = -1;  // -1: only bookkeeping (a junction, the goal), free of cost
  std::uint32_t precondition_begin = 0, precondition_end = 0;
  std::uint32_t effect_begin = 0, effect_end = 0;
};

class RelaxedTask {
 public:
  // Stopped, the result is incomplete and must not be used.
  void build(const GroundTask& task, Budget& budget);

  const GroundTask& task() const { return *task_; }
  std::int32_t proposition_count() const { return goal_ + 2; }
  Proposition goal() const { return goal_; }
  // Holds in every state: the precondition of operators that have none.
  Proposition always() const { return goal_ + 1; }
  Proposition of(ConditionId condition) const {
    return condition >= 0 ? condition : static_cast<Proposition>(literals_) + ~condition;
  }
  bool is_gate(Proposition p) const {
    return p >= static_cast<Proposition>(literals_ + task_->junctions.size()) && p < goal_;
  }
  const Growing<RelaxedOperator>& operators() const { return operators_; }
  std::span<const Proposition> preconditions(const RelaxedOperator& op) const {
    return {preconditions_.data() + op.precondition_begin, op.precondition_end - op.precondition_begin};
  }
  std::span<const Proposition> effects(const RelaxedOperator& op) const {
    return {effects_.data() + op.effect_begin, op.effect_end - op.effect_begin};
  }
  // Operators that need / produce a proposition.
  std::span<const std::int32_t> users(Proposition p) const { return row(user_begin_, users_, p); }
  std::span<const std::int32_t> producers(Proposition p) const { return row(producer_begin_, producers_, p); }
  // Operators of an action are consecutive.
  std::span<const std::int32_t> operators_of(std::int32_t action) const {
    return row(action_begin_, action_operators_, action);
  }
  std::int64_t cost(const RelaxedOperator& op) const {
    return op.action < 0 ? 0 : task_->actions[static_cast<std::size_t>(op.action)].cost;
  }
  // Literals of atoms that the goal needs and that hold in `state`.
  template <class Visit>
  void for_each_true(const Word* state, Budget& budget, const Visit& visit) const {
    for (const Literal literal : tracked_) {
      if (budget.poll()) return;
      if (literal_holds(state, literal)) visit(literal);
    }
  }

 private:
  static std::span<const std::int32_t> row(const Growing<std::uint32_t>& begin,
                                           const Growing<std::int32_t>& values, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    return {values.data() + begin[i], begin[i + 1] - begin[i]};
  }
  void add_operator(std::int32_t action, std::span<const ConditionId> first,
                    std::span<const ConditionId> second);
  bool gated(const GroundAction& action) const;
  void index(Budget& budget);

  const GroundTask* task_ = nullptr;
  std::size_t literals_ = 0;
  Proposition goal_ = 0;
  Growing<Literal> tracked_;
  Growing<RelaxedOperator> operators_;
  Growing<Proposition> preconditions_, effects_;
  Growing<std::uint32_t> user_begin_, producer_begin_, action_begin_;
  Growing<std::int32_t> users_, producers_, action_operators_;
};

}  // namespace goalnet::planner
