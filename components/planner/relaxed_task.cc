#include "components/planner/relaxed_task.h"

namespace goalnet::planner {
namespace {

// Rows of a compressed table: counts become ends, then items are filled in backwards.
template <class ForEach>
void fill_rows(std::size_t rows, Growing<std::uint32_t>& begin, Growing<std::int32_t>& values, Budget& budget,
               const ForEach& for_each) {
  begin.clear();
  for (std::size_t i = 0; i <= rows; ++i) {
    if (budget.poll()) return;
    begin.push_back(0);
  }
  for_each([&](std::int32_t row, std::int32_t) { ++begin[static_cast<std::size_t>(row)]; });
  std::uint32_t total = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (budget.poll()) return;
    total += begin[i];
    begin[i] = total;
  }
  begin[rows] = total;
  values.resize_for_overwrite(total);
  for_each([&](std::int32_t row, std::int32_t value) {
    auto& place = begin[static_cast<std::size_t>(row)];
    if (place > 0) values[--place] = value;  // 0 only where counting was stopped
  });
}

}  // namespace

bool RelaxedTask::gated(const GroundAction& action) const {
  // What the conditional effects of an action would otherwise repeat: its preconditions, once for each.
  constexpr std::size_t kFewConditions = 8, kFewEffects = 8;
  if (task_->preconditions(action).size() < kFewConditions) return false;
  std::size_t conditional = 0;
  for (const GroundEffect& effect : task_->effects_of(action)) {
    conditional +=
        effect.conditional() && task_->needed[static_cast<std::size_t>(effect.literal)] != 0 ? 1 : 0;
  }
  return conditional >= kFewEffects;
}

void RelaxedTask::add_operator(std::int32_t action, std::span<const ConditionId> first,
                               std::span<const ConditionId> second) {
  RelaxedOperator op;
  op.action = action;
  op.precondition_begin = static_cast<std::uint32_t>(preconditions_.size());
  for (const ConditionId condition : first) preconditions_.push_back(of(condition));
  for (const ConditionId condition : second) preconditions_.push_back(of(condition));
  if (preconditions_.size() == op.precondition_begin) preconditions_.push_back(always());
  op.precondition_end = static_cast<std::uint32_t>(preconditions_.size());
  op.effect_begin = op.effect_end = static_cast<std::uint32_t>(effects_.size());
  operators_.push_back(op);
}

void RelaxedTask::build(const GroundTask& task, Budget& budget) {
  task_ = &task;
  literals_ = task.needed.size();
  goal_ = static_cast<Proposition>(literals_ + task.junctions.size());
  Proposition next_gate = goal_;
  for (const GroundAction& action : task.actions) {
    if (budget.poll()) return;
    if (gated(action)) ++goal_;
  }
  operators_.clear();
  preconditions_.clear();
  effects_.clear();
  tracked_.clear();
  for (std::size_t literal = 0; literal < literals_; ++literal) {
    if (budget.poll()) return;
    if (task.needed[literal] != 0) tracked_.push_back(static_cast<Literal>(literal));
  }
  for (std::size_t a = 0; a < task.actions.size(); ++a) {
    const GroundAction& action = task.actions[a];
    if (budget.poll()) return;
    const auto id = static_cast<std::int32_t>(a);
    const bool has_gate = gated(action);
    if (has_gate) {
      add_operator(-1, task.preconditions(action), {});
      effects_.push_back(next_gate);
      ++operators_.back().effect_end;
    }
    bool open = false;
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (effect.conditional() || task.needed[static_cast<std::size_t>(effect.literal)] == 0) continue;
      if (!open) add_operator(id, task.preconditions(action), {});
      open = true;
      effects_.push_back(effect.literal);
      ++operators_.back().effect_end;
    }
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (!effect.conditional() || task.needed[static_cast<std::size_t>(effect.literal)] == 0) continue;
      add_operator(id, has_gate ? std::span<const ConditionId>{} : task.preconditions(action),
                   task.conditions_of(effect));
      if (has_gate) {
        preconditions_.push_back(next_gate);
        ++operators_.back().precondition_end;
      }
      effects_.push_back(effect.literal);
      ++operators_.back().effect_end;
    }
    if (has_gate) ++next_gate;
  }
  for (const GroundAxiom& axiom : task.axioms) {
    if (budget.poll()) return;
    if (task.needed[static_cast<std::size_t>(axiom.head)] == 0) continue;
    add_operator(-1, task.conditions_of(axiom), {});
    effects_.push_back(axiom.head);
    ++operators_.back().effect_end;
  }
  for (std::size_t atom = 0; atom < task.derived.size();
       ++atom) {  // that something is not derived costs nothing here
    if (task.derived[atom] == 0 || task.needed[2 * atom + 1] == 0) continue;
    add_operator(-1, {}, {});
    effects_.push_back(static_cast<Proposition>(2 * atom + 1));
    ++operators_.back().effect_end;
  }
  for (std::size_t j = 0; j < task.junctions.size(); ++j) {
    if (budget.poll()) return;
    const Junction& junction = task.junctions[j];
    const auto children = task.children(junction);
    for (std::size_t i = 0; i < (junction.conjunction ? 1 : children.size()); ++i) {
      add_operator(-1, junction.conjunction ? children : children.subspan(i, 1), {});
      effects_.push_back(static_cast<Proposition>(literals_ + j));
      ++operators_.back().effect_end;
    }
  }
  add_operator(-1, task.goal, {});
  effects_.push_back(goal_);
  ++operators_.back().effect_end;
  index(budget);
}

void RelaxedTask::index(Budget& budget) {
  const auto propositions = static_cast<std::size_t>(proposition_count());
  const auto each = [this, &budget](const Growing<Proposition>& values, bool effects, const auto& visit) {
    for (std::size_t i = 0; i < operators_.size() && !budget.poll(); ++i) {
      const RelaxedOperator& op = operators_[i];
      const std::uint32_t begin = effects ? op.effect_begin : op.precondition_begin;
      const std::uint32_t end = effects ? op.effect_end : op.precondition_end;
      for (std::uint32_t k = begin; k < end; ++k) visit(values[k], static_cast<std::int32_t>(i));
    }
  };
  fill_rows(propositions, user_begin_, users_, budget,
            [&](const auto& visit) { each(preconditions_, false, visit); });
  fill_rows(propositions, producer_begin_, producers_, budget,
            [&](const auto& visit) { each(effects_, true, visit); });
  fill_rows(task_->actions.size(), action_begin_, action_operators_, budget, [&](const auto& visit) {
    for (std::size_t i = 0; i < operators_.size() && !budget.poll(); ++i) {
      if (operators_[i].action >= 0) visit(operators_[i].action, static_cast<std::int32_t>(i));
    }
  });
}

}  // namespace goalnet::planner
