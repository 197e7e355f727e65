// What the actions that the grounder found do besides what they were found for, and the last step: effects
// laid out by action.
#include <algorithm>

#include "components/planner/grounder.h"

namespace goalnet::planner {

// What the actions found do besides: they destroy needed literals, or produce them although nobody grounded
// them for that (dominated effects). Starts afresh in every round, because rounds add literals and actions;
// there are few.
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
      if (wanted && !schema.effects[static_cast<std::size_t>(reference.effect)].dominated)
        continue;  // found already
      gather(reference, literal);
    }
  }
  // A plan may have to make sure that a conditional effect does not happen.
  const auto protect = [this](const Growing<RawEffect>& effects) {
    for (const RawEffect& raw : effects) {
      if (budget_->poll()) stopped_ = true;
      if (stopped_) return;
      if (!raw.effect.conditional() ||
          task_->needed[static_cast<std::size_t>(opposite(raw.effect.literal))] == 0) {
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
  slots_ = schema.slots;
  if (!binder_.begin(schema) || !binder_.unify(schema, effect.literal.atom, task_->atoms[literal >> 1]))
    return;
  const auto parameters = static_cast<std::size_t>(schema.parameter_count);
  const auto found = [&](std::int32_t action) {
    bind_open(schema, effect, false, [&] { add_effect(action, effect, literal, &side_effects_); });
  };
  if (std::find(binder_.data(), binder_.data() + parameters, -1) == binder_.data() + parameters) {
    const std::int32_t action = action_for(reference.schema, false);
    if (action >= 0) found(action);
    return;
  }
  std::vector<ObjectId>& binding = binder_.values();
  const std::vector<ObjectId> pattern(binding.begin(),
                                      binding.begin() + static_cast<std::ptrdiff_t>(schema.slots.size()));
  for (const std::int32_t action : actions_of_schema_[static_cast<std::size_t>(reference.schema)]) {
    if (budget_->poll()) {
      stopped_ = true;
      return;
    }
    const ObjectId* mine = task_->bindings.data() + task_->actions[static_cast<std::size_t>(action)].binding;
    bool match = true;
    for (std::size_t i = 0; i < parameters && match; ++i) match = pattern[i] < 0 || pattern[i] == mine[i];
    if (!match) continue;
    std::copy(pattern.begin(), pattern.end(), binding.begin());
    std::copy_n(mine, parameters, binding.begin());
    found(action);
  }
}

// Lays the effects out by action, deletions first: where an action both deletes and adds a fact, it holds
// afterwards.
void Grounder::finish() {
  Growing<GroundAction>& actions = task_->actions;
  // visit(effect) for every one; false once stopped.
  const auto each = [this](const auto& visit) {
    for (const auto* effects : {&effects_, &side_effects_}) {
      for (const RawEffect& raw : *effects) {
        if (stopped_ = budget_->poll(); stopped_) return false;
        visit(raw);
      }
    }
    return true;
  };
  if (!each([&](const RawEffect& raw) { ++actions[static_cast<std::size_t>(raw.action)].effect_end; }))
    return;
  std::uint32_t total = 0;
  for (GroundAction& action : actions) {
    if (stopped_ = budget_->poll(); stopped_) return;
    const std::uint32_t count = action.effect_end;
    action.effect_begin = action.effect_end = total;
    total += count;
  }
  task_->effects.resize_for_overwrite(total);
  for (const Literal negative : {1, 0}) {
    const bool done = each([&](const RawEffect& raw) {
      if ((raw.effect.literal & 1) != negative) return;
      task_->effects[actions[static_cast<std::size_t>(raw.action)].effect_end++] = raw.effect;
      task_->changes[static_cast<std::size_t>(raw.effect.literal >> 1)] = 1;
    });
    if (!done) return;
  }
  if (!task_->axioms.empty()) finish_axioms();
}

}  // namespace goalnet::planner
