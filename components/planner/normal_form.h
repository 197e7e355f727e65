// Conditions in negation normal form: 'not' only before atoms and equalities, derived predicates replaced by
// their definitions where these are not recursive, constants folded.
#pragma once

#include <stop_token>
#include <utility>
#include <vector>

#include "components/planner/domain.h"

namespace goalnet::planner {

class Normaliser {
 public:
  // `slots` are the variables' types; inlined definitions add more. `fixed` replaces some variables (case
  // splits). What comes out lies in `arena`. Once `stop` asks, it means nothing.
  Normaliser(const Domain& domain, std::vector<TypeSet>& slots, Arena& arena, std::stop_token stop = {})
      : domain_(domain), slots_(slots), arena_(arena), stop_(std::move(stop)) {}

  void fix(std::int32_t slot, ObjectId object) { fixed_.push_back({slot, Term::object(object)}); }
  // Declares that the variable is none of these constants: equalities with them are false.
  void exclude(std::int32_t slot, ObjectId object) { excluded_.push_back({slot, object}); }

  Formula normalise(const Formula& formula, bool negated = false) const;
  AtomPattern substitute(const AtomPattern& atom) const;

 private:
  struct Replacement {
    std::int32_t slot;
    Term term;
  };
  struct Exclusion {
    std::int32_t slot;
    ObjectId object;
  };

  Term substitute(Term term) const;
  Formula atom(const Formula& formula, bool negated) const;
  Formula equality(const Formula& formula, bool negated) const;
  Formula negation(const Formula& inner) const;
  Formula junction(bool conjunction, const List<Formula>& children) const;
  Formula inlined(const AtomPattern& use, bool negated) const;

  const Domain& domain_;
  std::vector<TypeSet>& slots_;
  Arena& arena_;
  std::stop_token stop_;
  std::vector<Replacement> fixed_;
  std::vector<Exclusion> excluded_;
};

// The alternatives of a formula: disjuncts at the top, multiplied out while they stay few.
std::vector<Formula> alternatives(const Formula& formula, std::size_t most, Arena& arena);

}  // namespace goalnet::planner
