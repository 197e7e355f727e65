// Most household goals are one action away. This finds such an action without grounding anything, or proves
// that there is none.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/problem_index.h"

namespace goalnet::planner {

struct GoalLiteral {
  const AtomPattern* atom = nullptr;  // without variables
  bool negative = false;
};

// The literals of a conjunction without quantifiers or derived predicates; nothing for any other goal.
bool simple_goal(const Domain& domain, const Formula& goal, std::vector<GoalLiteral>* literals);

// An atom that is wanted both to hold and not to hold, or null.
const AtomPattern* contradiction(const std::vector<GoalLiteral>& goal);

class OneAction {
 public:
  explicit OneAction(const CompiledDomain& compiled);

  struct Found {
    std::int32_t schema;
    std::vector<ObjectId> binding;
  };
  // At least one literal must not hold initially.
  // Stopped, nothing is found.
  std::optional<Found> find(ProblemIndex& index, const std::vector<GoalLiteral>& goal, Budget& budget);

 private:
  bool holds(const GoalLiteral& literal) const;
  bool bind(const CompiledSchema& schema, std::int32_t slot, ObjectId object);
  bool unify(const CompiledSchema& schema, const AtomPattern& pattern, const ObjectId* arguments);
  bool search(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters);
  bool accept(const CompiledSchema& schema);
  bool condition_holds(const CompiledSchema& schema, const Condition& condition);
  bool formula_holds(const CompiledSchema& schema, const Formula& formula);
  bool happens(const CompiledSchema& schema, const CompiledEffect& effect, const GoalLiteral& literal);

  const CompiledDomain& compiled_;
  ProblemIndex* index_ = nullptr;
  Budget* budget_ = nullptr;
  const std::vector<GoalLiteral>* goal_ = nullptr;
  std::vector<ObjectId> binding_, outer_;
};

}  // namespace goalnet::planner
