// Binds the variables of an action schema in every way that the problem's static facts allow: a join of the
// facts that no action changes, smallest relation first, so that no combination of objects is tried that they
// exclude. Internal to the planner.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/atom_lists.h"
#include "components/planner/atom_table.h"
#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/problem_index.h"

namespace goalnet::planner {

class Binder {
 public:
  explicit Binder(const CompiledDomain& compiled);

  void restart(ProblemIndex& index, Budget& budget) {
    index_ = &index;
    budget_ = &budget;
    reachable_ = nullptr;
  }
  // From now on atoms that an action changes must be among these, where they cover the predicate; null: any.
  void limit_to(const AtomLists* reachable) { reachable_ = reachable; }

  // By slot; -1 = open.
  std::vector<ObjectId>& values() { return values_; }
  const ObjectId* data() const { return values_.data(); }
  void reserve(std::size_t slots) {
    if (slots > values_.size()) values_.resize(slots, -1);
  }

  // Opens all variables but those that this case of the action fixes; false where such an object is not
  // present.
  bool begin(const CompiledSchema& schema);
  // False, with some variables bound, where the pattern cannot be this atom.
  bool unify(const CompiledSchema& schema, const AtomPattern& pattern, AtomRef atom);
  // Binds what is open of the parameters (if `parameters`) and of the effect's own variables in every way
  // that the static parts of both conditions allow, and calls visit() for each, until that returns false.
  // Returns false then, or once the budget has stopped it. On return the variables are as before.
  template <class Visit>
  bool each(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters, const Visit& visit);
  // Whether one of the atom's variables is not bound.
  bool any_open(const AtomPattern& atom) const;
  // Equalities and static literals; all variables are bound.
  bool static_part_holds(const Condition& condition) const;

 private:
  bool is_open(Term term) const {
    return term.is_variable() && values_[static_cast<std::size_t>(term.slot())] < 0;
  }
  bool bind(const CompiledSchema& schema, std::int32_t slot, ObjectId object);
  // Whether an equality or a static literal that is already decided says no.
  bool refused(const Condition& condition) const;
  std::int32_t first_open(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters) const;
  const EqualityPattern* decisive_equality(const Condition& condition) const;
  // A relation with open variables, and the atoms that fit what is bound.
  struct Join {
    const AtomPattern* atom = nullptr;  // null: none
    std::size_t size = 0;
    bool fluent = false;
    std::span<const std::int32_t> facts;  // in Problem::initial; of a static relation
    AtomLists::List reachable;            // of one that actions change
  };
  // Of the condition's relations with open variables, the one with the fewest candidates, if fewer than there
  // are.
  void choose_join(const Condition& condition, Join* best) const;
  void choose_reachable(const Condition& condition, Join* best) const;
  bool is_reachable(const AtomPattern& atom) const;

  ProblemIndex* index_ = nullptr;
  Budget* budget_ = nullptr;
  const AtomLists* reachable_ = nullptr;
  std::vector<ObjectId> values_;
};

template <class Visit>
bool Binder::each(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters,
                  const Visit& visit) {
  if (refused(schema.precondition) || (effect != nullptr && refused(effect->condition))) return true;
  const std::int32_t open = first_open(schema, effect, parameters);
  if (open < 0) return visit();
  if (budget_->poll()) return false;
  const std::array<const Condition*, 2> conditions = {&schema.precondition,
                                                      effect == nullptr ? nullptr : &effect->condition};
  Join join;
  for (const Condition* condition : conditions) {
    if (condition == nullptr) continue;
    if (const EqualityPattern* equality = decisive_equality(*condition)) {
      const bool left_open = is_open(equality->left);
      const std::int32_t slot = (left_open ? equality->left : equality->right).slot();
      const ObjectId value = (left_open ? equality->right : equality->left).resolve(data());
      const bool go_on = !bind(schema, slot, value) || each(schema, effect, parameters, visit);
      values_[static_cast<std::size_t>(slot)] = -1;
      return go_on;
    }
  }
  for (const Condition* condition : conditions) {
    if (condition != nullptr) choose_join(*condition, &join);
  }
  if (join.atom != nullptr) {
    const auto try_atom = [&](AtomRef atom) {
      std::array<std::int32_t, 16> opened{};
      std::size_t count = 0;
      for (const Term term : join.atom->arguments) {
        if (is_open(term)) opened[count++] = term.slot();
      }
      const bool go_on = !unify(schema, *join.atom, atom) || each(schema, effect, parameters, visit);
      for (std::size_t i = 0; i < count; ++i) values_[static_cast<std::size_t>(opened[i])] = -1;
      return go_on;
    };
    if (join.fluent) return reachable_->each(join.reachable, try_atom);
    return std::all_of(join.facts.begin(), join.facts.end(),
                       [&](std::int32_t fact) { return try_atom(index_->problem().initial[fact]); });
  }
  bool go_on = true;
  for (const ObjectId object : index_->objects(schema.slot_sets[static_cast<std::size_t>(open)])) {
    values_[static_cast<std::size_t>(open)] = object;
    go_on = each(schema, effect, parameters, visit);
    if (!go_on) break;
  }
  values_[static_cast<std::size_t>(open)] = -1;
  return go_on;
}

}  // namespace goalnet::planner
