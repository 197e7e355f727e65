#include "components/planner/grounder.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {

Grounder::Grounder(const CompiledDomain& compiled) : compiled_(compiled), actions_of_schema_(compiled.schemas.size()) {
  std::size_t most = 64;
  for (const CompiledSchema& schema : compiled.schemas) most = std::max(most, schema.slots.size());
  for (const CompiledAxiom& axiom : compiled.axioms) most = std::max(most, axiom.slots.size());
  binding_.assign(most, -1);
}

void Grounder::restart() {
  task_->clear();
  action_table_.clear();
  action_of_entry_.clear();
  for (auto& list : actions_of_schema_) list.clear();
  effects_.clear();
  side_effects_.clear();
  axioms_of_.clear();
  defined_.clear();
  queue_.clear();
  queue_next_ = 0;
  stopped_ = too_large_ = false;
}

Grounder::Result Grounder::ground(ProblemIndex& index, const Formula& goal, const std::vector<TypeSet>& goal_slots,
                                  Budget& budget, GroundTask& task) {
  index_ = &index;
  budget_ = &budget;
  task_ = &task;
  restart();
  if (goal_slots.size() > binding_.size()) binding_.resize(goal_slots.size(), -1);
  slots_ = &goal_slots;
  // The parts of a conjunction one by one, so that they stay literals.
  const std::vector<Formula> single = {goal};
  const auto& parts = goal.kind == Formula::Kind::kAnd ? goal.children : single;
  for (const Formula& part : parts) {
    const Value value = instantiate(part);
    if (stopped_) return Result::kStopped;
    if (value.kind == Value::Kind::kFalse) {
      task.goal_impossible = true;
      return Result::kDone;
    }
    if (value.kind == Value::Kind::kCondition) task.goal.push_back(value.condition);
  }
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
    for (std::uint32_t i = junction.begin; i < junction.end; ++i) need(task_->junction_children[i]);
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
    for (std::uint32_t i = junction.begin; i < junction.end; ++i) need_opposite(task_->junction_children[i]);
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
  const auto& producers =
      compiled_.producers[2 * static_cast<std::size_t>(predicate) + static_cast<std::size_t>(literal & 1)];
  for (const EffectReference& reference : producers) produce(reference, literal);
}

void Grounder::produce(const EffectReference& reference, Literal literal) {
  const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
  const CompiledEffect& effect = schema.effects[static_cast<std::size_t>(reference.effect)];
  if (effect.dominated) return;
  slots_ = &schema.slots;
  std::fill_n(binding_.begin(), schema.slots.size(), -1);
  if (!bind_fixed(schema) || !unify(schema, effect.literal.atom, task_->atoms[literal >> 1])) return;
  bind_open(schema, &effect, true, [&] {
    const std::int32_t action = action_for(reference.schema, true);
    if (action >= 0) add_effect(action, effect, literal, &effects_);
  });
}

bool Grounder::bind_fixed(const CompiledSchema& schema) {
  for (const auto& [slot, object] : schema.fixed) {
    if (!index_->problem().present(object)) return false;
    binding_[static_cast<std::size_t>(slot)] = object;
  }
  return true;
}

bool Grounder::bind(const CompiledSchema& schema, std::int32_t slot, ObjectId object) {
  ObjectId& bound = binding_[static_cast<std::size_t>(slot)];
  if (bound >= 0) return bound == object;
  if (!index_->object_fits(object, schema.slot_sets[static_cast<std::size_t>(slot)])) return false;
  bound = object;
  return true;
}

bool Grounder::unify(const CompiledSchema& schema, const AtomPattern& pattern, AtomRef atom) {
  for (std::size_t i = 0; i < pattern.arguments.size(); ++i) {
    const Term term = pattern.arguments[i];
    if (term.is_variable()) {
      if (!bind(schema, term.slot(), atom.arguments[i])) return false;
    } else if (term.value != atom.arguments[i]) {
      return false;
    }
  }
  return true;
}

bool Grounder::static_part_holds(const Condition& condition) const {
  for (const EqualityPattern& equality : condition.equalities) {
    if ((equality.left.resolve(binding_.data()) == equality.right.resolve(binding_.data())) == equality.negative) {
      return false;
    }
  }
  for (const LiteralPattern& literal : condition.fixed) {
    if (index_->holds_initially(literal.atom, binding_.data()) == literal.negative) return false;
  }
  return true;
}

template <class Visit>
void Grounder::bind_open(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters,
                         const Visit& visit) {
  if (stopped_ || too_large_) return;
  const auto is_open = [&](Term term) {
    return term.is_variable() && binding_[static_cast<std::size_t>(term.slot())] < 0;
  };
  // Quick refusal: an inequality or a static literal that is already decided.
  const auto refused = [&](const Condition& condition) {
    for (const EqualityPattern& equality : condition.equalities) {
      if (is_open(equality.left) || is_open(equality.right)) continue;
      if ((equality.left.resolve(binding_.data()) == equality.right.resolve(binding_.data())) == equality.negative) {
        return true;
      }
    }
    for (const LiteralPattern& literal : condition.fixed) {
      if (std::any_of(literal.atom.arguments.begin(), literal.atom.arguments.end(), is_open)) continue;
      if (index_->holds_initially(literal.atom, binding_.data()) == literal.negative) return true;
    }
    return false;
  };
  if (refused(schema.precondition) || (effect != nullptr && refused(effect->condition))) return;

  std::int32_t open = -1;
  if (parameters) {
    for (std::int32_t slot = 0; slot < schema.parameter_count && open < 0; ++slot) {
      if (binding_[static_cast<std::size_t>(slot)] < 0) open = slot;
    }
  }
  if (open < 0 && effect != nullptr) {
    for (const std::int32_t slot : effect->variables) {
      if (binding_[static_cast<std::size_t>(slot)] < 0) {
        open = slot;
        break;
      }
    }
  }
  if (open < 0) {
    visit();
    return;
  }
  if (budget_->poll()) {
    stopped_ = true;
    return;
  }
  const std::array<const Condition*, 2> conditions = {&schema.precondition,
                                                      effect == nullptr ? nullptr : &effect->condition};
  // An equality with one open side decides it.
  for (const Condition* condition : conditions) {
    if (condition == nullptr) continue;
    for (const EqualityPattern& equality : condition->equalities) {
      if (equality.negative || is_open(equality.left) == is_open(equality.right)) continue;
      const bool left_open = is_open(equality.left);
      const std::int32_t slot = (left_open ? equality.left : equality.right).slot();
      const ObjectId value = (left_open ? equality.right : equality.left).resolve(binding_.data());
      if (bind(schema, slot, value)) bind_open(schema, effect, parameters, visit);
      binding_[static_cast<std::size_t>(slot)] = -1;
      return;
    }
  }
  // Join with the static fact pattern that has the fewest candidates.
  const LiteralPattern* best = nullptr;
  std::span<const std::int32_t> candidates;
  for (const Condition* condition : conditions) {
    if (condition == nullptr) continue;
    for (const LiteralPattern& literal : condition->fixed) {
      const auto& arguments = literal.atom.arguments;
      if (literal.negative || std::none_of(arguments.begin(), arguments.end(), is_open)) continue;
      auto facts = index_->facts(literal.atom.predicate);
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (is_open(arguments[i])) continue;
        const auto fewer = index_->facts(literal.atom.predicate, i, arguments[i].resolve(binding_.data()));
        if (fewer.size() < facts.size()) facts = fewer;
      }
      if (best == nullptr || facts.size() < candidates.size()) {
        best = &literal;
        candidates = facts;
      }
    }
  }
  if (best != nullptr) {
    std::array<std::int32_t, 16> opened{};
    for (const std::int32_t fact : candidates) {
      std::size_t count = 0;
      for (const Term term : best->atom.arguments) {
        if (is_open(term)) opened[count++] = term.slot();
      }
      if (unify(schema, best->atom, index_->problem().initial[fact])) bind_open(schema, effect, parameters, visit);
      for (std::size_t i = 0; i < count; ++i) binding_[static_cast<std::size_t>(opened[i])] = -1;
    }
    return;
  }
  for (const ObjectId object : index_->objects(schema.slot_sets[static_cast<std::size_t>(open)])) {
    binding_[static_cast<std::size_t>(open)] = object;
    bind_open(schema, effect, parameters, visit);
    if (stopped_ || too_large_) break;
  }
  binding_[static_cast<std::size_t>(open)] = -1;
}

std::int32_t Grounder::action_for(std::int32_t schema_index, bool create) {
  const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(schema_index)];
  const auto parameters = static_cast<std::size_t>(schema.parameter_count);
  if (!create) {
    const std::int32_t entry = action_table_.find(schema_index, binding_.data(), parameters);
    return entry == AtomTable::kNone ? -1 : action_of_entry_[static_cast<std::size_t>(entry)];
  }
  bool is_new = false;
  const std::int32_t entry = action_table_.add(schema_index, binding_.data(), parameters, &is_new);
  if (!is_new) return action_of_entry_[static_cast<std::size_t>(entry)];
  action_of_entry_.push_back(-1);
  if (budget_->poll()) {
    stopped_ = true;
    return -1;
  }
  if (!static_part_holds(schema.precondition)) return -1;
  const std::int64_t cost = index_->cost(schema.cost, binding_.data());
  if (cost < 0) return -1;
  const auto begin = static_cast<std::uint32_t>(task_->conditions.size());
  if (!instantiate(schema.precondition, &task_->conditions)) {
    task_->conditions.resize(begin);
    return -1;
  }
  if (task_->actions.size() >= kMostActions) {
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
  task_->bindings.insert(task_->bindings.end(), binding_.begin(),
                         binding_.begin() + static_cast<std::ptrdiff_t>(parameters));
  task_->actions.push_back(ground);
  actions_of_schema_[static_cast<std::size_t>(schema_index)].push_back(action);
  action_of_entry_[static_cast<std::size_t>(entry)] = action;
  for (std::uint32_t i = ground.precondition_begin; i < ground.precondition_end; ++i) need(task_->conditions[i]);
  return action;
}

void Grounder::add_effect(std::int32_t action, const CompiledEffect& effect, Literal literal,
                          std::vector<RawEffect>* effects) {
  if (!static_part_holds(effect.condition)) return;
  RawEffect raw;
  raw.action = action;
  raw.effect.literal = literal;
  raw.effect.condition_begin = static_cast<std::uint32_t>(task_->conditions.size());
  if (!instantiate(effect.condition, &task_->conditions)) {
    task_->conditions.resize(raw.effect.condition_begin);
    return;
  }
  raw.effect.condition_end = static_cast<std::uint32_t>(task_->conditions.size());
  // What destroys a needed literal is not wanted itself.
  if (task_->needed[static_cast<std::size_t>(literal)] != 0) {
    for (std::uint32_t i = raw.effect.condition_begin; i < raw.effect.condition_end; ++i) need(task_->conditions[i]);
  }
  effects->push_back(raw);
}

// What the actions found do besides: they destroy needed literals, or produce them although nobody grounded them for
// that (dominated effects). Starts afresh in every round, because rounds add literals and actions; there are few.
void Grounder::gather_side_effects() {
  side_effects_.clear();
  const std::size_t literals = task_->needed.size();
  for (std::size_t i = 0; i < literals && !stopped_; ++i) {
    if (budget_->poll()) stopped_ = true;
    const auto literal = static_cast<Literal>(i);
    const bool wanted = task_->needed[i] != 0;
    if (!wanted && task_->needed[static_cast<std::size_t>(opposite(literal))] == 0) continue;
    const PredicateId predicate = task_->atoms.predicate(literal >> 1);
    for (const EffectReference& reference :
         compiled_.producers[2 * static_cast<std::size_t>(predicate) + (i & 1u)]) {
      if (actions_of_schema_[static_cast<std::size_t>(reference.schema)].empty()) continue;
      const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
      if (wanted && !schema.effects[static_cast<std::size_t>(reference.effect)].dominated) continue;  // found already
      gather(reference, literal);
    }
  }
  // A plan may have to make sure that a conditional effect does not happen.
  const auto protect = [this](const std::vector<RawEffect>& effects) {
    for (const RawEffect& raw : effects) {
      if (budget_->poll()) stopped_ = true;
      if (stopped_) return;
      if (!raw.effect.conditional() || task_->needed[static_cast<std::size_t>(opposite(raw.effect.literal))] == 0) {
        continue;
      }
      for (std::uint32_t i = raw.effect.condition_begin; i < raw.effect.condition_end; ++i) {
        need_opposite(task_->conditions[i]);
      }
    }
  };
  protect(effects_);
  protect(side_effects_);
}

// The instances of one effect among the actions that exist.
void Grounder::gather(const EffectReference& reference, Literal literal) {
  const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
  const CompiledEffect& effect = schema.effects[static_cast<std::size_t>(reference.effect)];
  slots_ = &schema.slots;
  std::fill_n(binding_.begin(), schema.slots.size(), -1);
  if (!bind_fixed(schema) || !unify(schema, effect.literal.atom, task_->atoms[literal >> 1])) return;
  const auto parameters = static_cast<std::size_t>(schema.parameter_count);
  const auto found = [&](std::int32_t action) {
    bind_open(schema, &effect, false, [&] { add_effect(action, effect, literal, &side_effects_); });
  };
  if (std::find(binding_.begin(), binding_.begin() + static_cast<std::ptrdiff_t>(parameters), -1) ==
      binding_.begin() + static_cast<std::ptrdiff_t>(parameters)) {
    const std::int32_t action = action_for(reference.schema, false);
    if (action >= 0) found(action);
    return;
  }
  const std::vector<ObjectId> pattern(binding_.begin(), binding_.begin() + static_cast<std::ptrdiff_t>(schema.slots.size()));
  for (const std::int32_t action : actions_of_schema_[static_cast<std::size_t>(reference.schema)]) {
    if (budget_->poll()) {
      stopped_ = true;
      return;
    }
    const ObjectId* mine = task_->bindings.data() + task_->actions[static_cast<std::size_t>(action)].binding;
    bool match = true;
    for (std::size_t i = 0; i < parameters && match; ++i) match = pattern[i] < 0 || pattern[i] == mine[i];
    if (!match) continue;
    std::copy(pattern.begin(), pattern.end(), binding_.begin());
    std::copy_n(mine, parameters, binding_.begin());
    found(action);
  }
}

// Lays the effects out by action, deletions first: where an action both deletes and adds a fact, it holds afterwards.
void Grounder::finish() {
  std::vector<GroundAction>& actions = task_->actions;
  effects_.insert(effects_.end(), side_effects_.begin(), side_effects_.end());
  for (const RawEffect& raw : effects_) {
    if (stopped_ = budget_->poll(); stopped_) return;
    ++actions[static_cast<std::size_t>(raw.action)].effect_end;
  }
  std::uint32_t total = 0;
  for (GroundAction& action : actions) {
    const std::uint32_t count = action.effect_end;
    action.effect_begin = action.effect_end = total;
    total += count;
  }
  task_->effects.resize(total);
  for (const Literal negative : {1, 0}) {
    for (const RawEffect& raw : effects_) {
      if (stopped_ = budget_->poll(); stopped_) return;
      if ((raw.effect.literal & 1) != negative) continue;
      task_->effects[actions[static_cast<std::size_t>(raw.action)].effect_end++] = raw.effect;
      task_->changes[static_cast<std::size_t>(raw.effect.literal >> 1)] = 1;
    }
  }
  if (!task_->axioms.empty()) finish_axioms();
}

}  // namespace goalnet::planner
