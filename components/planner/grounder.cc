#include "components/planner/grounder.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {

Grounder::Grounder(const CompiledDomain& compiled)
    : compiled_(compiled),
      binder_(compiled),
      attainable_(compiled),
      reachable_(compiled),
      actions_of_schema_(compiled.schemas.size()) {}

void Grounder::restart() {
  task_->clear();
  objects_.clear();
  action_table_.clear();
  action_of_entry_.clear();
  for (auto& list : actions_of_schema_) list.clear();
  effects_.clear();
  side_effects_.clear();
  definitions_.clear();
  queue_.clear();
  queue_next_ = 0;
  stopped_ = too_large_ = false;
  without_cost_ = -1;
}

Grounder::Result Grounder::ground(ProblemIndex& index, const Formula& goal,
                                  std::span<const TypeSet> goal_slots, Budget& budget, GroundTask& task) {
  index_ = &index;
  budget_ = &budget;
  task_ = &task;
  // Forwards only where it pays: first with little effort, again where there is no other way.
  Result result = ground_backwards(goal, goal_slots, nullptr, kManyActions);
  for (const std::int64_t firings : {kFewFirings, kMostFirings}) {
    if (result != Result::kTooLarge) return result;
    const AtomLists* const reachable = reachable_.compute(index, firings, budget);
    if (budget.stopped()) return Result::kStopped;
    if (reachable == nullptr && firings == kMostFirings) break;
    result = ground_backwards(goal, goal_slots, reachable, kMostActions);
    if (reachable != nullptr) break;
  }
  return result;
}

Grounder::Result Grounder::ground_backwards(const Formula& goal, std::span<const TypeSet> goal_slots,
                                            const AtomLists* reachable, std::size_t most_actions) {
  restart();
  most_actions_ = most_actions;
  GroundTask& task = *task_;
  binder_.restart(*index_, *budget_);
  binder_.limit_to(reachable);
  attainable_.restart(*index_, *budget_);
  binder_.reserve(goal_slots.size());
  slots_ = goal_slots;
  // The parts of a conjunction one by one, so that they stay literals.
  const auto add_goal = [&](const Formula& part) {
    const Value value = instantiate(part);
    if (value.kind == Value::Kind::kFalse) task.goal_impossible = true;
    if (value.kind == Value::Kind::kCondition) task.goal.push_back(value.condition);
    return !stopped_ && !task.goal_impossible;
  };
  const bool possible = goal.kind == Formula::Kind::kAnd
                            ? std::all_of(goal.children.begin(), goal.children.end(), add_goal)
                            : add_goal(goal);
  if (stopped_) return Result::kStopped;
  if (!possible) return Result::kDone;
  for (const ConditionId condition : task.goal) need(condition);
  do {
    if (!close()) break;
    gather_side_effects();
  } while (queue_next_ < queue_.size() && !stopped_ && !too_large_);
  if (too_large_) return Result::kTooLarge;
  if (stopped_) return Result::kStopped;
  finish();
  return stopped_ ? Result::kStopped : Result::kDone;
}

void Grounder::need(ConditionId condition) {
  if (condition < 0) {
    const Junction junction = task_->junctions[static_cast<std::size_t>(~condition)];
    for (std::uint32_t i = junction.begin; i < junction.end && !stopped_; ++i) {
      need(task_->junction_children[i]);
      stopped_ = budget_->poll();
    }
    return;
  }
  auto& needed = task_->needed[static_cast<std::size_t>(condition)];
  if (needed != 0) return;
  needed = 1;
  queue_.push_back(condition);
}

void Grounder::need_opposite(ConditionId condition) {
  if (condition < 0) {
    const Junction junction = task_->junctions[static_cast<std::size_t>(~condition)];
    for (std::uint32_t i = junction.begin; i < junction.end && !stopped_; ++i) {
      need_opposite(task_->junction_children[i]);
      stopped_ = budget_->poll();
    }
    return;
  }
  need(opposite(condition));
}

bool Grounder::close() {
  while (queue_next_ < queue_.size()) {
    if (stopped_ || too_large_) return false;
    const Literal literal = queue_[queue_next_++];
    produce(literal);
  }
  return !stopped_ && !too_large_;
}

void Grounder::produce(Literal literal) {
  const PredicateId predicate = task_->atoms.predicate(literal >> 1);
  if (compiled_.domain.recursive(predicate)) return define(literal);
  const auto producers =
      compiled_.producers[2 * static_cast<std::size_t>(predicate) + static_cast<std::size_t>(literal & 1)];
  for (const EffectReference& reference : producers) produce(reference, literal);
}

void Grounder::produce(const EffectReference& reference, Literal literal) {
  const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
  const CompiledEffect& effect = schema.effects[static_cast<std::size_t>(reference.effect)];
  if (effect.dominated) return;
  slots_ = schema.slots;
  if (!binder_.begin(schema) || !binder_.unify(schema, effect.literal.atom, task_->atoms[literal >> 1]))
    return;
  bind_open(schema, effect, true, [&] {
    const std::int32_t action = action_for(reference.schema, true);
    if (action >= 0) add_effect(action, effect, literal, &effects_);
  });
}

std::int32_t Grounder::action_for(std::int32_t schema_index, bool create) {
  const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(schema_index)];
  const auto parameters = static_cast<std::size_t>(schema.parameter_count);
  if (!create) {
    const std::int32_t entry = action_table_.find(schema_index, binder_.data(), parameters);
    return entry == AtomTable::kNone ? -1 : action_of_entry_[static_cast<std::size_t>(entry)];
  }
  bool is_new = false;
  const std::int32_t entry = action_table_.add(schema_index, binder_.data(), parameters, &is_new);
  if (!is_new) return action_of_entry_[static_cast<std::size_t>(entry)];
  action_of_entry_.push_back(-1);
  if (budget_->poll()) {
    stopped_ = true;
    return -1;
  }
  if (!binder_.static_part_holds(schema.precondition)) return -1;
  if (!attainable_.can_hold(schema.precondition.fluent, binder_.data())) return -1;
  const std::int64_t cost = index_->cost(schema.cost, binder_.data());
  if (cost < 0) {
    without_cost_ = schema_index;
    return -1;
  }
  const auto begin = static_cast<std::uint32_t>(task_->conditions.size());
  if (!instantiate(schema.precondition, &task_->conditions)) {
    task_->conditions.truncate(begin);
    return -1;
  }
  if (task_->actions.size() >= most_actions_) {
    too_large_ = true;
    return -1;
  }
  const auto action = static_cast<std::int32_t>(task_->actions.size());
  GroundAction ground;
  ground.schema = schema_index;
  ground.binding = static_cast<std::uint32_t>(task_->bindings.size());
  ground.precondition_begin = begin;
  ground.precondition_end = static_cast<std::uint32_t>(task_->conditions.size());
  ground.cost = cost;
  task_->bindings.append({binder_.data(), parameters});
  task_->actions.push_back(ground);
  actions_of_schema_[static_cast<std::size_t>(schema_index)].push_back(action);
  action_of_entry_[static_cast<std::size_t>(entry)] = action;
  for (std::uint32_t i = ground.precondition_begin; i < ground.precondition_end; ++i)
    need(task_->conditions[i]);
  return action;
}

void Grounder::add_effect(std::int32_t action, const CompiledEffect& effect, Literal literal,
                          Growing<RawEffect>* effects) {
  if (!binder_.static_part_holds(effect.condition)) return;
  if (!attainable_.can_hold(effect.condition.fluent, binder_.data())) return;
  RawEffect raw;
  raw.action = action;
  raw.effect.literal = literal;
  raw.effect.condition_begin = static_cast<std::uint32_t>(task_->conditions.size());
  if (!instantiate(effect.condition, &task_->conditions)) {
    task_->conditions.truncate(raw.effect.condition_begin);
    return;
  }
  raw.effect.condition_end = static_cast<std::uint32_t>(task_->conditions.size());
  // What destroys a needed literal is not wanted itself.
  if (task_->needed[static_cast<std::size_t>(literal)] != 0) {
    for (std::uint32_t i = raw.effect.condition_begin; i < raw.effect.condition_end; ++i)
      need(task_->conditions[i]);
  }
  effects->push_back(raw);
}

}  // namespace goalnet::planner
