// The ground form of a problem: only the atoms and actions that the goal can need.
//
// A literal is 2 * atom + (negative ? 1 : 0). A condition is a literal, or ~i for the i-th junction: a
// disjunction or conjunction that could not be written as a list of literals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/atom_table.h"
#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/derivation.h"
#include "components/planner/growing.h"

namespace goalnet::planner {

using Literal = std::int32_t;
using ConditionId = std::int32_t;

inline Literal opposite(Literal literal) { return literal ^ 1; }

struct GroundEffect {
  Literal literal = 0;
  std::uint32_t condition_begin = 0, condition_end = 0;  // in GroundTask::conditions
  bool conditional() const { return condition_begin != condition_end; }
};

struct GroundAction {
  std::int32_t schema = 0;
  std::uint32_t binding = 0;  // first of its parameters in GroundTask::bindings
  std::uint32_t precondition_begin = 0, precondition_end = 0;  // in GroundTask::conditions
  std::uint32_t effect_begin = 0, effect_end = 0;              // in GroundTask::effects; deletions first
  std::int64_t cost = 1;
};

struct Junction {
  bool conjunction = false;
  std::uint32_t begin = 0, end = 0;  // in GroundTask::junction_children
};

// head follows where the conditions hold; see GroundTask::axioms.
struct GroundAxiom {
  Literal head = 0;                                      // positive, of a derived atom
  std::uint32_t condition_begin = 0, condition_end = 0;  // in GroundTask::conditions
};

struct GroundTask {
  AtomTable atoms;
  Growing<std::uint8_t> initial;  // by atom
  Growing<std::uint8_t> changes;  // by atom: some action changes it
  Growing<std::uint8_t> needed;   // by literal
  Growing<GroundAction> actions;
  Growing<ObjectId> bindings;
  Growing<GroundEffect> effects;
  Growing<ConditionId> conditions;
  Growing<Junction> junctions;
  Growing<ConditionId> junction_children;
  Growing<ConditionId> goal;
  bool goal_impossible = false;  // found false while grounding
  // What defines derived atoms that depend on themselves ("above" follows from "above"), by layer: within a
  // layer they only support each other, and what they need not to hold belongs to a layer below. In every
  // state exactly those derived atoms hold that the axioms yield, layer by layer, starting from none.
  Growing<GroundAxiom> axioms;
  Growing<std::int32_t> derived;  // by atom: 0, or its layer plus one; empty where there are no axioms
  Derivation derivation;

  void clear();

  std::span<const ConditionId> preconditions(const GroundAction& action) const {
    return {conditions.data() + action.precondition_begin,
            action.precondition_end - action.precondition_begin};
  }
  std::span<const GroundEffect> effects_of(const GroundAction& action) const {
    return {effects.data() + action.effect_begin, action.effect_end - action.effect_begin};
  }
  std::span<const ConditionId> conditions_of(const GroundEffect& effect) const {
    return {conditions.data() + effect.condition_begin, effect.condition_end - effect.condition_begin};
  }
  std::span<const ConditionId> children(const Junction& junction) const {
    return {junction_children.data() + junction.begin, junction.end - junction.begin};
  }
  std::span<const ConditionId> conditions_of(const GroundAxiom& axiom) const {
    return {conditions.data() + axiom.condition_begin, axiom.condition_end - axiom.condition_begin};
  }
  std::size_t words() const { return (initial.size() + 63) / 64; }
};

// A state is words() words, one bit per atom.
using Word = std::uint64_t;

inline bool literal_holds(const Word* state, Literal literal) {
  const auto atom = static_cast<std::uint32_t>(literal >> 1);
  return (((state[atom >> 6] >> (atom & 63u)) ^ static_cast<Word>(literal & 1)) & 1u) != 0;
}

bool junction_holds(const GroundTask& task, const Word* state, std::int32_t junction);

inline bool condition_holds(const GroundTask& task, const Word* state, ConditionId condition) {
  return condition >= 0 ? literal_holds(state, condition) : junction_holds(task, state, ~condition);
}

inline bool all_hold(const GroundTask& task, const Word* state, std::span<const ConditionId> conditions) {
  for (const ConditionId condition : conditions) {
    if (!condition_holds(task, state, condition)) return false;
  }
  return true;
}

inline bool action_applies(const GroundTask& task, const Word* state, const GroundAction& action) {
  return all_hold(task, state, task.preconditions(action));
}

inline void make_true(Word* state, Literal literal) {
  const auto atom = static_cast<std::uint32_t>(literal >> 1);
  const Word bit = Word{1} << (atom & 63u);
  if ((literal & 1) != 0) {
    state[atom >> 6] &= ~bit;
  } else {
    state[atom >> 6] |= bit;
  }
}

// next = the state after the action; conditions are judged on `state`. The two must not overlap.
void apply_action(const GroundTask& task, const Word* state, const GroundAction& action, Word* next);

// Stopped, it is not whole.
void initial_state(const GroundTask& task, Budget& budget, std::vector<Word>* state);

}  // namespace goalnet::planner
