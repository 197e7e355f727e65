#include "components/planner/normal_form.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {
namespace {

Formula constant(bool value) {
  Formula formula;
  formula.kind = value ? Formula::Kind::kTrue : Formula::Kind::kFalse;
  return formula;
}

}  // namespace

Formula Normaliser::negation(const Formula& inner) const {
  Formula formula;
  formula.kind = Formula::Kind::kNot;
  formula.children.push_back(arena_, inner);
  return formula;
}

Term Normaliser::substitute(Term term) const {
  if (!term.is_variable()) return term;
  for (const Replacement& replacement : fixed_) {
    if (replacement.slot == term.slot()) return replacement.term;
  }
  return term;
}

AtomPattern Normaliser::substitute(const AtomPattern& pattern) const {
  AtomPattern result = pattern;
  for (Term& term : result.arguments) term = substitute(term);
  return result;
}

Formula Normaliser::junction(bool conjunction, const List<Formula>& children) const {
  const auto kind = conjunction ? Formula::Kind::kAnd : Formula::Kind::kOr;
  const auto neutral = conjunction ? Formula::Kind::kTrue : Formula::Kind::kFalse;
  const auto absorbing = conjunction ? Formula::Kind::kFalse : Formula::Kind::kTrue;
  if (std::any_of(children.begin(), children.end(), [&](const Formula& c) { return c.kind == absorbing; })) {
    return constant(!conjunction);
  }
  Formula result;
  result.kind = kind;
  const bool as_it_is = std::none_of(children.begin(), children.end(),
                                     [&](const Formula& c) { return c.kind == kind || c.kind == neutral; });
  if (as_it_is) {
    result.children = children;
  } else {
    for (const Formula& child : children) {
      if (child.kind == kind) {
        for (const Formula& inner : child.children) result.children.push_back(arena_, inner);
      } else if (child.kind != neutral) {
        result.children.push_back(arena_, child);
      }
    }
  }
  if (result.children.empty()) return constant(conjunction);
  return result.children.size() == 1 ? result.children.front() : result;
}

Formula Normaliser::equality(const Formula& formula, bool negated) const {
  Formula result;
  result.kind = formula.kind;
  result.atom = substitute(formula.atom);
  const Term left = result.atom.arguments[0], right = result.atom.arguments[1];
  if (left == right) return constant(!negated);
  if (!left.is_variable() && !right.is_variable()) return constant(negated);
  for (const Exclusion& exclusion : excluded_) {
    const bool match =
        (left.is_variable() && left.slot() == exclusion.slot && right == Term::object(exclusion.object)) ||
        (right.is_variable() && right.slot() == exclusion.slot && left == Term::object(exclusion.object));
    if (match) return constant(negated);
  }
  return negated ? negation(result) : result;
}

// A use of a derived predicate becomes the disjunction of its definitions' bodies.
Formula Normaliser::inlined(const AtomPattern& use, bool negated) const {
  List<Formula> bodies;
  for (const DerivedPredicate& definition : domain_.derived) {
    if (definition.predicate != use.predicate) continue;
    Normaliser inner(domain_, slots_, arena_, stop_);
    const auto parameters = static_cast<std::size_t>(definition.parameter_count);
    List<Formula> parts;
    for (std::size_t i = 0; i < definition.slots.size(); ++i) {
      const auto slot = static_cast<std::int32_t>(i);
      if (i >= parameters) {  // a quantified variable of the body: a fresh one here
        inner.fixed_.push_back({slot, Term::variable(static_cast<std::int32_t>(slots_.size()))});
        slots_.push_back(definition.slots[i]);
        continue;
      }
      inner.fixed_.push_back({slot, use.arguments[i]});
      const TypeSet declared =
          domain_.predicate_schemas[static_cast<std::size_t>(use.predicate)].parameters[i];
      const bool narrower = !std::all_of(declared.begin(), declared.end(), [&](TypeId type) {
        return domain_.is_a(type, definition.slots[i]);
      });
      if (!narrower) continue;
      // The definition holds for fewer types than the predicate: (exists (?v - type) (= ?v argument)).
      Formula same;
      same.kind = Formula::Kind::kEqual;
      same.atom.arguments = {Term::variable(static_cast<std::int32_t>(slots_.size())), use.arguments[i]};
      Formula exists;
      exists.kind = negated ? Formula::Kind::kForall : Formula::Kind::kExists;
      exists.slots = arena_.copy(std::array{static_cast<std::int32_t>(slots_.size())});
      slots_.push_back(definition.slots[i]);
      exists.children.push_back(arena_, negated ? negation(same) : same);
      parts.push_back(arena_, exists);
    }
    parts.push_back(arena_, inner.normalise(definition.body, negated));
    bodies.push_back(arena_, junction(!negated, parts));
  }
  return junction(negated, bodies);
}

Formula Normaliser::atom(const Formula& formula, bool negated) const {
  Formula result;
  result.kind = formula.kind;
  result.atom = substitute(formula.atom);
  const bool derived = domain_.is_derived(result.atom.predicate) && !domain_.recursive(result.atom.predicate);
  if (derived) return inlined(result.atom, negated);
  return negated ? negation(result) : result;
}

Formula Normaliser::normalise(const Formula& formula, bool negated) const {
  if (stop_.stop_requested()) return constant(false);
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return constant(!negated);
    case Formula::Kind::kFalse:
      return constant(negated);
    case Formula::Kind::kAtom:
      return atom(formula, negated);
    case Formula::Kind::kEqual:
      return equality(formula, negated);
    case Formula::Kind::kNot:
      return normalise(formula.children.front(), !negated);
    case Formula::Kind::kAnd:
    case Formula::Kind::kOr: {
      const bool conjunction = (formula.kind == Formula::Kind::kAnd) != negated;
      const auto decides = conjunction ? Formula::Kind::kFalse : Formula::Kind::kTrue;
      List<Formula> children;
      for (const Formula& child : formula.children) {
        if (children.push_back(arena_, normalise(child, negated)).kind == decides)
          return constant(!conjunction);
      }
      return junction(conjunction, children);
    }
    case Formula::Kind::kForall:
    case Formula::Kind::kExists: {
      Formula result;
      result.kind = (formula.kind == Formula::Kind::kForall) != negated ? Formula::Kind::kForall
                                                                        : Formula::Kind::kExists;
      result.slots = arena_.copy(formula.slots);
      for (std::int32_t& slot : result.slots)
        slot = substitute(Term::variable(slot)).slot();  // where inlined
      result.children.push_back(arena_, normalise(formula.children.front(), negated));
      // Over no objects the quantifier still decides, so only "forall true" and "exists false" fold.
      const auto inner = result.children.front().kind;
      if (inner == Formula::Kind::kTrue && result.kind == Formula::Kind::kForall) return constant(true);
      if (inner == Formula::Kind::kFalse && result.kind == Formula::Kind::kExists) return constant(false);
      return result;
    }
  }
  return formula;
}

std::vector<Formula> alternatives(const Formula& formula, std::size_t most, Arena& arena) {
  if (formula.kind == Formula::Kind::kOr) {
    std::vector<Formula> result;
    for (const Formula& child : formula.children) {
      for (const Formula& inner : alternatives(child, most, arena)) result.push_back(inner);
      if (result.size() > most) return {formula};
    }
    return result;
  }
  const auto has_choice = [](const Formula& f) {
    return f.kind == Formula::Kind::kOr || f.kind == Formula::Kind::kAnd;
  };
  if (formula.kind != Formula::Kind::kAnd ||
      std::none_of(formula.children.begin(), formula.children.end(), has_choice)) {
    return {formula};
  }
  std::vector<List<Formula>> products(1);
  for (const Formula& child : formula.children) {
    std::vector<Formula> options = alternatives(child, most, arena);
    if (options.size() * products.size() > most) options = {child};
    if (options.size() == 1) {
      for (List<Formula>& product : products) product.push_back(arena, options[0]);
      continue;
    }
    std::vector<List<Formula>> larger;
    for (const List<Formula>& product : products) {
      for (const Formula& option : options) {
        List<Formula>& copy = larger.emplace_back();
        for (const Formula& part : product) copy.push_back(arena, part);
        copy.push_back(arena, option);
      }
    }
    products = std::move(larger);
  }
  std::vector<Formula> result;
  for (const List<Formula>& product : products) {
    result.emplace_back().kind = Formula::Kind::kAnd;
    result.back().children = product;
  }
  return result;
}

}  // namespace goalnet::planner
