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
  Array<std::int32_t> variables;
  Formula condition;
  AtomPattern atom;
  bool negative = false;
};

// What a condition consists of.
struct Parts {
  std::vector<LiteralPattern> fixed, fluent;
  std::vector<EqualityPattern> equalities;
  std::vector<const Formula*> complex;
};

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

using Places = std::vector<std::int32_t>;  // by slot: its new number

void rename(const Places& place, Term* term) {
  if (term->is_variable()) *term = Term::variable(place[static_cast<std::size_t>(term->slot())]);
}
void rename(const Places& place, AtomPattern* atom) {
  for (Term& term : atom->arguments) rename(place, &term);
}
// A copy of its own in the arena.
Formula renamed(const Places& place, const Formula& formula, Arena& arena) {
  Formula result;
  result.kind = formula.kind;
  result.atom = formula.atom;
  rename(place, &result.atom);
  result.slots = arena.copy(formula.slots);
  for (std::int32_t& slot : result.slots) slot = place[static_cast<std::size_t>(slot)];
  for (const Formula& child : formula.children)
    result.children.push_back(arena, renamed(place, child, arena));
  return result;
}

class Compiler {
 public:
  Compiler(CompiledDomain& compiled, const std::stop_token& stop) : compiled_(compiled), stop_(stop) {}

  void compile(std::int32_t index) {
    scratch_.clear();
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
    std::vector<TypeSet> slots(action.slots.begin(), action.slots.end());
    Normaliser normaliser(compiled_.domain, slots, scratch_, stop_);
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
    effects_.clear();
    flatten(normaliser, action.effect, {}, Formula{});
    if (stop_.stop_requested()) return;
    CompiledSchema schema;
    schema.action = index;
    schema.fixed = compiled_.arena.copy(chosen);
    schema.cost = action.cost;
    schema.cost.functions = compiled_.arena.copy(action.cost.functions);
    for (AtomPattern& function : schema.cost.functions) function = normaliser.substitute(function);
    for (const Formula& alternative : alternatives(precondition, kMostDisjuncts, scratch_)) {
      finish(alternative, exclusions, slots, action.parameter_count, schema);
    }
  }

  // The effects one by one, their conditions in normal form.
  void flatten(const Normaliser& normaliser, const Effect& effect, std::vector<std::int32_t> variables,
               const Formula& condition) {
    switch (effect.kind) {
      case Effect::Kind::kAdd:
      case Effect::Kind::kDelete: {
        const Formula normal = normaliser.normalise(condition);
        if (normal.kind == Formula::Kind::kFalse) return;
        effects_.push_back({scratch_.copy(variables), normal, normaliser.substitute(effect.atom),
                            effect.kind == Effect::Kind::kDelete});
        return;
      }
      case Effect::Kind::kAnd:
        for (const Effect& child : effect.children) {
          if (stop_.stop_requested()) return;
          flatten(normaliser, child, variables, condition);
        }
        return;
      case Effect::Kind::kForall:
        variables.insert(variables.end(), effect.slots.begin(), effect.slots.end());
        flatten(normaliser, effect.children.front(), std::move(variables), condition);
        return;
      case Effect::Kind::kWhen: {
        Formula both;
        both.kind = Formula::Kind::kAnd;
        both.children.push_back(scratch_, condition);
        both.children.push_back(scratch_, effect.condition);
        flatten(normaliser, effect.children.front(), std::move(variables), both);
        return;
      }
    }
  }

  // Variables under a leading 'exists' of the precondition become parameters: slots are renumbered so that
  // those bound with the action come first.
  void finish(Formula precondition, const std::vector<EqualityPattern>& exclusions,
              const std::vector<TypeSet>& types, std::int32_t parameter_count, CompiledSchema schema) {
    std::vector<std::int32_t> order;
    for (std::int32_t slot = 0; slot < parameter_count; ++slot) order.push_back(slot);
    precondition = open_exists(precondition, &order);
    schema.parameter_count = static_cast<std::int32_t>(order.size());
    for (std::int32_t slot = 0; slot < static_cast<std::int32_t>(types.size()); ++slot) {
      if (std::find(order.begin(), order.end(), slot) == order.end()) order.push_back(slot);
    }
    Places place(order.size());
    schema.slots = compiled_.arena.allocate_array<TypeSet>(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
      schema.slots[i] = types[static_cast<std::size_t>(order[i])];
    }
    schema.cost.functions = compiled_.arena.copy(schema.cost.functions);
    for (AtomPattern& function : schema.cost.functions) rename(place, &function);
    Parts parts = split(precondition, place);
    parts.equalities.insert(parts.equalities.end(), exclusions.begin(), exclusions.end());
    schema.precondition = keep(parts, place);
    compiled_effects_.clear();
    for (const FlatEffect& effect : effects_) {
      if (stop_.stop_requested()) return;
      add_effect(effect, place, schema.precondition);
    }
    schema.effects = compiled_.arena.copy(compiled_effects_);
    split_toggles(schema, compiled_.arena, &compiled_.schemas);
  }

  void add_effect(const FlatEffect& effect, const Places& place, const Condition& precondition) {
    CompiledEffect compiled;
    compiled.literal = {effect.atom, effect.negative};
    rename(place, &compiled.literal.atom);
    const auto& known = precondition.fluent;
    for (const Formula& alternative : alternatives(effect.condition, 16, scratch_)) {
      std::vector<std::int32_t> variables(effect.variables.begin(), effect.variables.end());
      const Formula opened = open_exists(alternative, &variables);
      Parts parts = split(opened, place);
      for (std::int32_t& variable : variables) variable = place[static_cast<std::size_t>(variable)];
      // What the precondition already says needs no condition.
      std::erase_if(parts.fluent, [&](const LiteralPattern& literal) {
        return std::any_of(known.begin(), known.end(), [&](const auto& l) { return same(l, literal); });
      });
      const bool impossible =
          std::any_of(parts.fluent.begin(), parts.fluent.end(), [&](const LiteralPattern& literal) {
            return std::any_of(known.begin(), known.end(),
                               [&](const auto& l) { return opposite(l, literal); });
          });
      if (impossible) continue;
      compiled.variables = compiled_.arena.copy(variables);
      compiled.condition = keep(parts, place);
      compiled_effects_.push_back(compiled);
    }
  }

  Formula open_exists(const Formula& formula, std::vector<std::int32_t>* variables) {
    if (formula.kind == Formula::Kind::kExists) {
      variables->insert(variables->end(), formula.slots.begin(), formula.slots.end());
      return open_exists(formula.children.front(), variables);
    }
    const auto may_open = [](const Formula& f) {
      return f.kind == Formula::Kind::kExists || f.kind == Formula::Kind::kAnd;
    };
    if (formula.kind != Formula::Kind::kAnd ||
        std::none_of(formula.children.begin(), formula.children.end(), may_open)) {
      return formula;
    }
    Formula result;
    result.kind = Formula::Kind::kAnd;
    for (const Formula& child : formula.children) {
      result.children.push_back(scratch_, open_exists(child, variables));
    }
    return result;
  }

  // Splits a normal-form formula at its top conjunction. Complex parts are not renamed yet.
  Parts split(const Formula& formula, const Places& place) const {
    Parts parts;
    std::vector<const Formula*> open = {&formula};
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Formula& part = *open[i];
      if (part.kind == Formula::Kind::kTrue) continue;
      if (part.kind == Formula::Kind::kAnd) {
        for (const Formula& child : part.children) open.push_back(&child);
        continue;
      }
      const bool negative = part.kind == Formula::Kind::kNot;
      AtomPattern atom = (negative ? part.children.front() : part).atom;
      const auto kind = (negative ? part.children.front() : part).kind;
      if (kind == Formula::Kind::kAtom) {
        rename(place, &atom);
        const bool fluent = compiled_.is_fluent[static_cast<std::size_t>(atom.predicate)] != 0;
        (fluent ? parts.fluent : parts.fixed).push_back({atom, negative});
      } else if (kind == Formula::Kind::kEqual) {
        rename(place, &atom);
        parts.equalities.push_back({atom.arguments[0], atom.arguments[1], negative});
      } else {
        parts.complex.push_back(&part);
      }
    }
    return parts;
  }

  Condition keep(const Parts& parts, const Places& place) {
    Arena& arena = compiled_.arena;
    Condition result{arena.copy(parts.fixed), arena.copy(parts.fluent), arena.copy(parts.equalities), {}};
    result.complex = arena.allocate_array<Formula>(parts.complex.size());
    for (std::size_t i = 0; i < parts.complex.size(); ++i) {
      result.complex[i] = renamed(place, *parts.complex[i], arena);
    }
    return result;
  }

  CompiledDomain& compiled_;
  const std::stop_token& stop_;
  // Of the action at hand:
  Arena scratch_;
  Chunks<FlatEffect> effects_;
  Chunks<CompiledEffect> compiled_effects_;
};

}  // namespace

void compile_actions(CompiledDomain& compiled, const std::stop_token& stop) {
  Compiler compiler(compiled, stop);
  for (std::size_t i = 0; i < compiled.domain.actions.size() && !stop.stop_requested(); ++i) {
    compiler.compile(static_cast<std::int32_t>(i));
  }
}

}  // namespace goalnet::planner
