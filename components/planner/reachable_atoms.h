// Every atom that actions can ever make true, when nothing they make true becomes false again: forwards from
// the initial state, joining what is known so far. Grounding (grounder.h) asks for it where going backwards
// alone finds too much: reactions with a dozen parameters, of which hardly any combination can ever occur.
// Internal to the planner.
#pragma once

#include <cstdint>

#include "components/planner/atom_lists.h"
#include "components/planner/binder.h"
#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/problem_index.h"

namespace goalnet::planner {

class ReachableAtoms {
 public:
  explicit ReachableAtoms(const CompiledDomain& compiled) : compiled_(compiled), binder_(compiled) {}

  // What is reachable, or more: conditions that are no conjunctions of literals, and literals that must not
  // hold, are taken to be met. Null where more than `most_firings` actions are carried out for it or the
  // budget has stopped.
  const AtomLists* compute(ProblemIndex& index, std::int64_t most_firings, Budget& budget);

 private:
  static constexpr std::size_t kAllEffects = ~std::size_t{0};

  struct Trigger {  // a condition that a new atom may fulfil
    std::int32_t schema;
    std::size_t effect;  // or kAllEffects: it is part of the precondition
    const AtomPattern* atom;
  };

  bool asks_for_atoms(const Condition& condition) const;
  void find_triggers();
  void fire(const CompiledSchema& schema, std::size_t effect);
  void produce(const CompiledEffect& effect);

  const CompiledDomain& compiled_;
  Binder binder_;
  AtomLists atoms_;
  std::vector<std::vector<Trigger>> triggers_;  // by predicate; found when first needed
  std::int64_t firings_ = 0, most_firings_ = 0;
};

}  // namespace goalnet::planner
