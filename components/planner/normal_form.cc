#include "components/planner/normal_form.h"

#include <algorithm>

namespace goalnet::planner {
namespace {

Formula constant(bool value) {
  Formula formula;
  formula.kind = value ? Formula::Kind::kTrue : Formula::Kind::kFalse;
  return formula;
}

Formula negation(Formula inner) {
  Formula formula;
  formula.kind = Formula::Kind::kNot;
  formula.children.push_back(std::move(inner));
  return formula;
}

}  // namespace

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

Formula Normaliser::junction(bool conjunction, std::vector<Formula> children) const {
  const auto kind = conjunction ? Formula::Kind::kAnd : Formula::Kind::kOr;
  const auto neutral = conjunction ? Formula::Kind::kTrue : Formula::Kind::kFalse;
  const auto absorbing = conjunction ? Formula::Kind::kFalse : Formula::Kind::kTrue;
  const bool nested =
      std::any_of(children.begin(), children.end(), [&](const Formula& c) { return c.kind == kind; });
  if (std::any_of(children.begin(), children.end(), [&](const Formula& c) { return c.kind == absorbing; })) {
    return constant(!conjunction);
  }
  std::erase_if(children, [&](const Formula& c) { return c.kind == neutral; });
  Formula result;
  result.kind = kind;
  if (!nested) {
    result.children = std::move(children);
  } else {
    for (Formula& child : children) {
      if (child.kind == kind) {
        for (Formula& inner : child.children) result.children.push_back(std::move(inner));
      } else {
        result.children.push_back(std::move(child));
      }
    }
  }
  if (result.children.empty()) return constant(conjunction);
  if (result.children.size() == 1) {
    Formula only = std::move(result.children[0]);
    return only;
  }
  return result;
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
  return negated ? negation(std::move(result)) : result;
}

// A use of a derived predicate becomes the disjunction of its definitions' bodies.
Formula Normaliser::inlined(const AtomPattern& use, bool negated) const {
  std::vector<Formula> bodies;
  for (const DerivedPredicate& definition : domain_.derived) {
    if (definition.predicate != use.predicate) continue;
    Normaliser inner(domain_, slots_, stop_);
    const auto parameters = static_cast<std::size_t>(definition.parameter_count);
    std::vector<Formula> parts;
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
      exists.slots = {static_cast<std::int32_t>(slots_.size())};
      slots_.push_back(definition.slots[i]);
      exists.children.push_back(negated ? negation(std::move(same)) : std::move(same));
      parts.push_back(std::move(exists));
    }
    parts.push_back(inner.normalise(definition.body, negated));
    bodies.push_back(junction(!negated, std::move(parts)));
  }
  return junction(negated, std::move(bodies));
}

Formula Normaliser::atom(const Formula& formula, bool negated) const {
  Formula result;
  result.kind = formula.kind;
  result.atom = substitute(formula.atom);
  const bool derived = domain_.is_derived(result.atom.predicate) && !domain_.recursive(result.atom.predicate);
  if (derived) return inlined(result.atom, negated);
  return negated ? negation(std::move(result)) : result;
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
      return normalise(formula.children[0], !negated);
    case Formula::Kind::kAnd:
    case Formula::Kind::kOr: {
      const bool conjunction = (formula.kind == Formula::Kind::kAnd) != negated;
      const auto decides = conjunction ? Formula::Kind::kFalse : Formula::Kind::kTrue;
      std::vector<Formula> children;
      children.reserve(formula.children.size());
      for (const Formula& child : formula.children) {
        children.push_back(normalise(child, negated));
        if (children.back().kind == decides) return constant(!conjunction);
      }
      return junction(conjunction, std::move(children));
    }
    case Formula::Kind::kForall:
    case Formula::Kind::kExists: {
      Formula result;
      result.kind = (formula.kind == Formula::Kind::kForall) != negated ? Formula::Kind::kForall
                                                                        : Formula::Kind::kExists;
      for (const std::int32_t slot : formula.slots) {
        result.slots.push_back(substitute(Term::variable(slot)).slot());  // renamed where inlined
      }
      result.children.push_back(normalise(formula.children[0], negated));
      // Over no objects the quantifier still decides, so only "forall true" and "exists false" fold.
      const auto inner = result.children[0].kind;
      if (inner == Formula::Kind::kTrue && result.kind == Formula::Kind::kForall) return constant(true);
      if (inner == Formula::Kind::kFalse && result.kind == Formula::Kind::kExists) return constant(false);
      return result;
    }
  }
  return formula;
}

std::vector<Formula> alternatives(const Formula& formula, std::size_t most) {
  if (formula.kind == Formula::Kind::kOr) {
    std::vector<Formula> result;
    for (const Formula& child : formula.children) {
      for (Formula& inner : alternatives(child, most)) result.push_back(std::move(inner));
    }
    if (result.size() <= most) return result;
    return {formula};
  }
  if (formula.kind != Formula::Kind::kAnd) return {formula};
  std::vector<Formula> result(1);
  result[0].kind = Formula::Kind::kAnd;
  for (const Formula& child : formula.children) {
    std::vector<Formula> options = alternatives(child, most);
    if (options.size() * result.size() > most) options = {child};
    std::vector<Formula> product;
    for (const Formula& left : result) {
      for (const Formula& option : options) {
        product.push_back(left);
        product.back().children.push_back(option);
      }
    }
    result = std::move(product);
  }
  return result;
}

}  // namespace goalnet::planner
