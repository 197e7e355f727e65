#include "components/planner/task_filter.h"

#include <algorithm>
#include <numeric>

namespace goalnet::planner {

void TaskFilter::need(ConditionId condition) {
  if (condition < 0) {
    for (const ConditionId child : from_->children(from_->junctions[static_cast<std::size_t>(~condition)]))
      need(child);
    return;
  }
  auto& mark = needed_[static_cast<std::size_t>(condition)];
  if (mark != 0) return;
  mark = 1;
  queue_.push_back(condition);
}

void TaskFilter::need_opposite(ConditionId condition) {
  if (condition < 0) {
    for (const ConditionId child : from_->children(from_->junctions[static_cast<std::size_t>(~condition)])) {
      need_opposite(child);
    }
    return;
  }
  need(opposite(condition));
}

// The grounder's closure once more, over the actions that are left: from the goal to what produces it.
void TaskFilter::find_relevant(Budget& budget) {
  const GroundTask& from = *from_;
  needed_.assign(from.needed.size(), 0);
  std::vector<std::uint8_t> used(from.actions.size(), 0);
  queue_.clear();
  for (const ConditionId condition : from.goal) need(condition);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t a = 0; a < from.actions.size(); ++a) {
      if (budget.poll()) return;
      if (keep_action_[a] == 0) continue;
      const GroundAction& action = from.actions[a];
      for (std::uint32_t e = action.effect_begin; e < action.effect_end; ++e) {
        if (keep_effect_[e] == 0) continue;
        const GroundEffect& effect = from.effects[e];
        const std::size_t before = queue_.size();
        if (needed_[static_cast<std::size_t>(effect.literal)] != 0) {
          if (used[a] == 0) {
            used[a] = 1;
            grows = true;
            for (const ConditionId condition : from.preconditions(action)) need(condition);
          }
          for (const ConditionId condition : from.conditions_of(effect)) need(condition);
        }
        if (used[a] != 0 && needed_[static_cast<std::size_t>(opposite(effect.literal))] != 0) {
          for (const ConditionId condition : from.conditions_of(effect)) need_opposite(condition);
        }
        grows = grows || queue_.size() > before;
      }
    }
  }
  keep_action_.swap(used);
}

TaskFilter::Value TaskFilter::translate(ConditionId condition, GroundTask& to, ConditionId* result) {
  if (condition >= 0) {
    const auto atom = static_cast<std::size_t>(condition >> 1);
    if (changes_[atom] == 0) {
      return (from_->initial[atom] != 0) != ((condition & 1) != 0) ? Value::kTrue : Value::kFalse;
    }
    if (new_atom_[atom] < 0) {
      new_atom_[atom] = static_cast<std::int32_t>(to.initial.size());
      to.initial.push_back(from_->initial[atom]);
      to.changes.push_back(1);
      to.needed.push_back(needed_[2 * atom]);
      to.needed.push_back(needed_[2 * atom + 1]);
    }
    *result = 2 * new_atom_[atom] + (condition & 1);
    return Value::kOpen;
  }
  const Junction junction = from_->junctions[static_cast<std::size_t>(~condition)];
  std::vector<ConditionId> children;
  for (const ConditionId child : from_->children(junction)) {
    ConditionId translated = 0;
    const Value value = translate(child, to, &translated);
    if (value == Value::kOpen) {
      children.push_back(translated);
    } else if ((value == Value::kTrue) != junction.conjunction) {
      return value;
    }
  }
  if (children.empty()) return junction.conjunction ? Value::kTrue : Value::kFalse;
  if (children.size() == 1) {
    *result = children[0];
    return Value::kOpen;
  }
  Junction copy;
  copy.conjunction = junction.conjunction;
  copy.begin = static_cast<std::uint32_t>(to.junction_children.size());
  to.junction_children.append(children);
  copy.end = static_cast<std::uint32_t>(to.junction_children.size());
  to.junctions.push_back(copy);
  *result = ~static_cast<ConditionId>(to.junctions.size() - 1);
  return Value::kOpen;
}

// Appends to to.conditions; false if one can never hold.
bool TaskFilter::translate_all(std::span<const ConditionId> conditions, GroundTask& to) {
  for (const ConditionId condition : conditions) {
    ConditionId translated = 0;
    const Value value = translate(condition, to, &translated);
    if (value == Value::kFalse) return false;
    if (value == Value::kOpen) to.conditions.push_back(translated);
  }
  return true;
}

void TaskFilter::copy(const GroundTask& from, GroundTask& to) {
  to = from;
  original_.resize(from.actions.size());
  std::iota(original_.begin(), original_.end(), 0);
}

std::int64_t TaskFilter::filter(const GroundTask& from, const RelaxedTask& relaxed, const LmCut& lm_cut,
                                std::int64_t estimate, std::int64_t bound, GroundTask& to, Budget& budget) {
  from_ = &from;
  keep_action_.assign(from.actions.size(), 0);
  keep_effect_.assign(from.effects.size(), 0);
  changes_.assign(from.initial.size(), 0);
  std::int64_t left_out = 0;
  const auto reach = [&](std::span<const ConditionId> conditions) {
    std::int64_t highest = 0;
    for (const ConditionId condition : conditions) {
      highest = std::max(highest, lm_cut.cost_left_to(relaxed.of(condition)));
    }
    return highest;
  };
  for (std::size_t a = 0; a < from.actions.size(); ++a) {
    if (budget.poll()) return 0;
    const GroundAction& action = from.actions[a];
    const std::int64_t to_precondition = reach(from.preconditions(action));
    if (to_precondition >= LmCut::kDeadEnd) continue;
    const std::int64_t own = lm_cut.cost_left(static_cast<std::int32_t>(a));
    if (estimate + to_precondition + own >= bound) {
      ++left_out;
      continue;
    }
    keep_action_[a] = 1;
    for (std::uint32_t e = action.effect_begin; e < action.effect_end; ++e) {
      // Conditions of effects that only destroy are not propositions of the relaxation; they stay.
      if (from.needed[static_cast<std::size_t>(from.effects[e].literal)] == 0) {
        keep_effect_[e] = 1;
        continue;
      }
      const std::int64_t to_condition = reach(from.conditions_of(from.effects[e]));
      keep_effect_[e] = to_condition < LmCut::kDeadEnd && estimate + to_condition + own < bound ? 1 : 0;
    }
  }
  find_relevant(budget);
  if (budget.stopped()) return 0;
  for (std::size_t a = 0; a < from.actions.size(); ++a) {
    if (budget.poll()) return 0;
    if (keep_action_[a] == 0) continue;
    for (std::uint32_t e = from.actions[a].effect_begin; e < from.actions[a].effect_end; ++e) {
      if (keep_effect_[e] == 0 || !relevant(from.effects[e])) {
        keep_effect_[e] = 0;
      } else {
        changes_[static_cast<std::size_t>(from.effects[e].literal >> 1)] = 1;
      }
    }
  }

  to.clear();
  new_atom_.assign(from.initial.size(), -1);
  original_.clear();
  for (const ConditionId condition : from.goal) {
    ConditionId translated = 0;
    const Value value = translate(condition, to, &translated);
    if (value == Value::kFalse) to.goal_impossible = true;
    if (value == Value::kOpen) to.goal.push_back(translated);
  }
  for (std::size_t a = 0; a < from.actions.size(); ++a) {
    if (budget.poll()) return 0;
    if (keep_action_[a] == 0) continue;
    GroundAction action = from.actions[a];
    const auto before = to.conditions.size();
    const auto effects_before = to.effects.size();
    const std::uint32_t begin = action.effect_begin, end = action.effect_end;
    action.precondition_begin = static_cast<std::uint32_t>(before);
    const bool possible = translate_all(from.preconditions(from.actions[a]), to);
    action.precondition_end = static_cast<std::uint32_t>(to.conditions.size());
    action.effect_begin = static_cast<std::uint32_t>(effects_before);
    for (std::uint32_t e = begin; possible && e < end; ++e) {
      if (keep_effect_[e] == 0) continue;
      GroundEffect effect;
      effect.condition_begin = static_cast<std::uint32_t>(to.conditions.size());
      if (!translate_all(from.conditions_of(from.effects[e]), to)) {
        to.conditions.truncate(effect.condition_begin);
        continue;
      }
      effect.condition_end = static_cast<std::uint32_t>(to.conditions.size());
      translate(from.effects[e].literal, to, &effect.literal);
      to.effects.push_back(effect);
    }
    action.effect_end = static_cast<std::uint32_t>(to.effects.size());
    if (!possible || to.effects.size() == effects_before) {
      to.conditions.truncate(before);
      to.effects.truncate(effects_before);
      continue;
    }
    to.actions.push_back(action);
    original_.push_back(static_cast<std::int32_t>(a));
  }
  return left_out;
}

}  // namespace goalnet::planner
