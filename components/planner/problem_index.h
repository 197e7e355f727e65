// Look-ups in one problem that grounding and the one-action search need: objects by type, facts by predicate
// and argument, costs. Built lazily; reused from problem to problem.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/growing.h"
#include "components/planner/problem.h"

namespace goalnet::planner {

class ProblemIndex {
 public:
  explicit ProblemIndex(const CompiledDomain& compiled) : compiled_(compiled) {}

  // The budget is asked here and in all look-ups that build something. Stopped, the answers mean nothing.
  void restart(const Problem& problem, Budget& budget);
  const Problem& problem() const { return *problem_; }

  bool object_fits(ObjectId id, std::int32_t type_set) const {
    return problem_->present(id) &&
           compiled_.allowed[static_cast<std::size_t>(type_set) * type_count_ +
                             static_cast<std::size_t>(problem_->object_type(id))] != 0;
  }
  std::span<const ObjectId> objects(std::int32_t type_set);

  // Initial atoms of a predicate; or of those the ones with `object` at `position` (a superset where facts
  // are few).
  std::span<const std::int32_t> facts(PredicateId predicate);
  std::span<const std::int32_t> facts(PredicateId predicate, std::size_t position, ObjectId object);

  bool holds_initially(const AtomPattern& atom, const ObjectId* binding) const;
  // -1 if the problem gives no value for a function used.
  std::int64_t cost(const CostExpression& expression, const ObjectId* binding) const;

 private:
  struct ByArgument {  // one position of one predicate
    bool built = false;
    Growing<std::uint32_t> begin;  // by object, one more at the end
    Growing<std::int32_t> atoms;
  };
  struct ByPredicate {
    std::uint32_t begin = 0, end = 0;
    std::vector<ByArgument> positions;
  };

  const CompiledDomain& compiled_;
  const Problem* problem_ = nullptr;
  Budget* budget_ = nullptr;
  std::size_t type_count_ = 0;
  std::vector<Growing<ObjectId>> objects_;  // by type set
  std::vector<std::uint8_t> objects_built_;
  std::vector<ByPredicate> predicates_;
  Growing<std::int32_t> atoms_;  // by predicate
};

}  // namespace goalnet::planner
