#include "components/planner/schema_compiler.h"

#include <algorithm>

#include "components/planner/normal_form.h"
#include "components/planner/toggles.h"

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostCases = 64;     // of equality with constants, per action
constexpr std::size_t kMostDisjuncts = 4;  // of a precondition split into schemas

// An effect before its condition is split.
struct FlatEffect {
  std::vector<std::int32_t> variables;
  Formula condition;
  AtomPattern atom;
  bool negative = false;
};

Formula conjunction(Formula left, Formula right) {
  Formula result;
  result.kind = Formula::Kind::kAnd;
  result.children.push_back(std::move(left));
  result.children.push_back(std::move(right));
  return result;
}

void flatten(const Effect& effect, std::vector<std::int32_t> variables, const Formula& condition,
             std::vector<FlatEffect>* result) {
  switch (effect.kind) {
    case Effect::Kind::kAdd:
    case Effect::Kind::kDelete:
      result->push_back({std::move(variables), condition, effect.atom, effect.kind == Effect::Kind::kDelete});
      return;
    case Effect::Kind::kAnd:
      for (const Effect& child : effect.children) flatten(child, variables, condition, result);
      return;
    case Effect::Kind::kForall:
      variables.insert(variables.end(), effect.slots.begin(), effect.slots.end());
      flatten(effect.children[0], std::move(variables), condition, result);
      return;
    case Effect::Kind::kWhen:
      flatten(effect.children[0], std::move(variables), conjunction(condition, effect.condition), result);
      return;
  }
}

// Constants that the first `parameters` variables are compared with.
using Comparison = std::pair<std::int32_t, ObjectId>;

void collect_comparisons(const Formula& formula, std::int32_t parameters, std::vector<Comparison>* result) {
  if (formula.kind == Formula::Kind::kEqual) {
    Term left = formula.atom.arguments[0], right = formula.atom.arguments[1];
    if (!left.is_variable()) std::swap(left, right);
    if (left.is_variable() && left.slot() < parameters && !right.is_variable()) {
      result->emplace_back(left.slot(), right.value);
    }
  }
  for (const Formula& child : formula.children) collect_comparisons(child, parameters, result);
}

void collect_comparisons(const Effect& effect, std::int32_t parameters, std::vector<Comparison>* result) {
  if (effect.kind == Effect::Kind::kWhen) collect_comparisons(effect.condition, parameters, result);
  for (const Effect& child : effect.children) collect_comparisons(child, parameters, result);
}

class Compiler {
 public:
  Compiler(CompiledDomain& compiled, const std::stop_token& stop) : compiled_(compiled), stop_(stop) {}

  void compile(std::int32_t index) {
    const ActionSchema& action = compiled_.domain.actions[static_cast<std::size_t>(index)];
    std::vector<Comparison> comparisons;
    collect_comparisons(action.precondition, action.parameter_count, &comparisons);
    collect_comparisons(action.effect, action.parameter_count, &comparisons);
    std::sort(comparisons.begin(), comparisons.end());
    comparisons.erase(std::unique(comparisons.begin(), comparisons.end()), comparisons.end());
    std::size_t cases = 1;
    for (std::int32_t slot = 0; slot < action.parameter_count; ++slot) {
      cases *=
          1 + static_cast<std::size_t>(std::count_if(comparisons.begin(), comparisons.end(),
                                                     [&](const Comparison& c) { return c.first == slot; }));
      if (cases > kMostCases) break;
    }
    if (cases > kMostCases) comparisons.clear();
    flat_.clear();
    flatten(action.effect, {}, Formula{}, &flat_);
    split_cases(index, comparisons, 0, {});
  }

 private:
  // Chooses for each compared parameter one of its constants, or none of them.
  void split_cases(std::int32_t index, const std::vector<Comparison>& comparisons, std::int32_t slot,
                   std::vector<Comparison> chosen) {
    const ActionSchema& action = compiled_.domain.actions[static_cast<std::size_t>(index)];
    if (slot == action.parameter_count) {
      build(index, comparisons, chosen);
      return;
    }
    for (const Comparison& comparison : comparisons) {
      if (comparison.first != slot) continue;
      const TypeId type = compiled_.domain.constant_types[static_cast<std::size_t>(comparison.second)];
      if (!compiled_.domain.is_a(type, action.slots[static_cast<std::size_t>(slot)])) continue;
      std::vector<Comparison> with = chosen;
      with.push_back(comparison);
      split_cases(index, comparisons, slot + 1, std::move(with));
    }
    split_cases(index, comparisons, slot + 1, std::move(chosen));
  }

  void build(std::int32_t index, const std::vector<Comparison>& comparisons,
             const std::vector<Comparison>& chosen) {
    const ActionSchema& action = compiled_.domain.actions[static_cast<std::size_t>(index)];
    std::vector<TypeSet> slots = action.slots;
    Normaliser normaliser(compiled_.domain, slots, stop_);
    std::vector<EqualityPattern> exclusions;
    for (const Comparison& fixed : chosen) normaliser.fix(fixed.first, fixed.second);
    for (const Comparison& comparison : comparisons) {
      const bool decided = std::any_of(chosen.begin(), chosen.end(),
                                       [&](const Comparison& c) { return c.first == comparison.first; });
      if (decided) continue;
      normaliser.exclude(comparison.first, comparison.second);
      exclusions.push_back({Term::variable(comparison.first), Term::object(comparison.second), true});
    }
    const Formula precondition = normaliser.normalise(action.precondition);
    if (precondition.kind == Formula::Kind::kFalse || stop_.stop_requested()) return;
    std::vector<FlatEffect> effects;
    for (const FlatEffect& flat : flat_) {
      Formula condition = normaliser.normalise(flat.condition);
      if (condition.kind == Formula::Kind::kFalse) continue;
      effects.push_back(
          {flat.variables, std::move(condition), normaliser.substitute(flat.atom), flat.negative});
    }
    for (Formula& alternative : alternatives(precondition, kMostDisjuncts)) {
      CompiledSchema schema;
      schema.action = index;
      schema.fixed = chosen;
      schema.slots = slots;
      schema.parameter_count = action.parameter_count;
      schema.cost = action.cost;
      for (AtomPattern& function : schema.cost.functions) function = normaliser.substitute(function);
      finish(std::move(alternative), exclusions, effects, std::move(schema));
    }
  }

  // Variables under a leading 'exists' of the precondition become parameters: slots are renumbered so that
  // those bound with the action come first.
  void finish(Formula precondition, const std::vector<EqualityPattern>& exclusions,
              const std::vector<FlatEffect>& effects, CompiledSchema schema) {
    std::vector<std::int32_t> order;
    for (std::int32_t slot = 0; slot < schema.parameter_count; ++slot) order.push_back(slot);
    precondition = open_exists(std::move(precondition), &order);
    schema.parameter_count = static_cast<std::int32_t>(order.size());
    for (std::int32_t slot = 0; slot < static_cast<std::int32_t>(schema.slots.size()); ++slot) {
      if (std::find(order.begin(), order.end(), slot) == order.end()) order.push_back(slot);
    }
    std::vector<std::int32_t> place(order.size());
    std::vector<TypeSet> slots(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
      slots[i] = schema.slots[static_cast<std::size_t>(order[i])];
    }
    schema.slots = std::move(slots);
    rename(place, &precondition);
    for (AtomPattern& function : schema.cost.functions) rename(place, &function);
    schema.precondition = split_condition(compiled_.is_fluent, std::move(precondition));
    schema.precondition.equalities.insert(schema.precondition.equalities.end(), exclusions.begin(),
                                          exclusions.end());
    for (const FlatEffect& flat : effects) {
      if (stop_.stop_requested()) return;
      FlatEffect effect = flat;
      for (std::int32_t& variable : effect.variables) variable = place[static_cast<std::size_t>(variable)];
      rename(place, &effect.condition);
      rename(place, &effect.atom);
      add_effect(std::move(effect), &schema);
    }
    split_toggles(std::move(schema), &compiled_.schemas);
  }

  void add_effect(FlatEffect effect, CompiledSchema* schema) {
    for (Formula& alternative : alternatives(effect.condition, 16)) {
      CompiledEffect compiled;
      compiled.variables = effect.variables;
      alternative = open_exists(std::move(alternative), &compiled.variables);
      compiled.condition = split_condition(compiled_.is_fluent, std::move(alternative));
      compiled.literal.atom = effect.atom;
      compiled.literal.negative = effect.negative;
      // What the precondition already says needs no condition.
      std::erase_if(compiled.condition.fluent, [&](const LiteralPattern& literal) {
        const auto& known = schema->precondition.fluent;
        return std::any_of(known.begin(), known.end(), [&](const auto& l) { return same(l, literal); });
      });
      const bool impossible =
          std::any_of(compiled.condition.fluent.begin(), compiled.condition.fluent.end(),
                      [&](const LiteralPattern& literal) {
                        const auto& known = schema->precondition.fluent;
                        return std::any_of(known.begin(), known.end(),
                                           [&](const auto& l) { return opposite(l, literal); });
                      });
      if (!impossible) schema->effects.push_back(std::move(compiled));
    }
  }

  static Formula open_exists(Formula formula, std::vector<std::int32_t>* variables) {
    if (formula.kind == Formula::Kind::kExists) {
      variables->insert(variables->end(), formula.slots.begin(), formula.slots.end());
      Formula inner = std::move(formula.children[0]);
      return open_exists(std::move(inner), variables);
    }
    if (formula.kind == Formula::Kind::kAnd) {
      for (Formula& child : formula.children) child = open_exists(std::move(child), variables);
    }
    return formula;
  }

  static void rename(const std::vector<std::int32_t>& place, AtomPattern* atom) {
    for (Term& term : atom->arguments) {
      if (term.is_variable()) term = Term::variable(place[static_cast<std::size_t>(term.slot())]);
    }
  }
  static void rename(const std::vector<std::int32_t>& place, Formula* formula) {
    rename(place, &formula->atom);
    for (std::int32_t& slot : formula->slots) slot = place[static_cast<std::size_t>(slot)];
    for (Formula& child : formula->children) rename(place, &child);
  }

  CompiledDomain& compiled_;
  const std::stop_token& stop_;
  std::vector<FlatEffect> flat_;  // of the action at hand
};

}  // namespace

void compile_action(CompiledDomain& compiled, std::int32_t action, const std::stop_token& stop) {
  Compiler(compiled, stop).compile(action);
}

}  // namespace goalnet::planner
