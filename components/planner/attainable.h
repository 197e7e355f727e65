// Which facts can ever come true or become false: a look ahead before an action is ground.
//
// Grounding backwards asks for everything that could help, also for actions that can never run: to let go of
// a shelf, one would have to hold it, and nobody can take it. A literal is attainable if it holds at first,
// or if some action produces it whose own conditions are attainable. That is asked a few levels deep, and
// what is not decided then counts as attainable; so "no" is certain, and actions that need such a literal can
// be left out without losing a plan. Internal to the planner.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/atom_table.h"
#include "components/planner/binder.h"
#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/problem_index.h"

namespace goalnet::planner {

class Attainable {
 public:
  explicit Attainable(const CompiledDomain& compiled);

  void restart(ProblemIndex& index, Budget& budget);

  // False only where one of the literals holds in no state that can be reached. Means nothing once the budget
  // has stopped.
  bool can_hold(std::span<const LiteralPattern> literals, const ObjectId* binding);

 private:
  enum : std::uint8_t { kPerhaps, kNo };
  static constexpr std::size_t kDeepest = 4;  // levels of actions looked back
  static constexpr int kMostTried = 256;      // ways to bind the producers of one literal

  bool ask(const AtomPattern& atom, bool negative, const ObjectId* binding, std::size_t depth);
  bool can_hold(std::span<const LiteralPattern> literals, const ObjectId* binding, std::size_t depth);
  bool produced(std::size_t kind, AtomRef atom, std::size_t depth);

  const CompiledDomain& compiled_;
  ProblemIndex* index_ = nullptr;
  std::vector<std::uint8_t> doubtful_;  // by 2 * predicate + negative: whether asking can be worth while
  std::vector<Binder> binders_;         // by depth
  AtomTable asked_;                     // `predicate` is 2 * predicate + negative
  std::vector<std::uint8_t> answers_;
};

}  // namespace goalnet::planner
