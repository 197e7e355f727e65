#include "components/planner/nonrecursive.h"

#include <vector>

namespace goalnet::planner {
namespace {

void collect(const Formula& formula, std::vector<PredicateId>* used) {
  if (formula.kind == Formula::Kind::kAtom) used->push_back(formula.atom.predicate);
  for (const Formula& child : formula.children) collect(child, used);
}

}  // namespace

bool depends_on_itself(const Domain& domain, PredicateId predicate) {
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(domain.predicates.size()), 0);
  std::vector<PredicateId> open = {predicate};
  while (!open.empty()) {
    const PredicateId current = open.back();
    open.pop_back();
    for (const DerivedPredicate& definition : domain.derived) {
      if (definition.predicate != current) continue;
      std::vector<PredicateId> used;
      collect(definition.body, &used);
      for (const PredicateId next : used) {
        if (next == predicate) return true;
        if (seen[static_cast<std::size_t>(next)] == 0) {
          seen[static_cast<std::size_t>(next)] = 1;
          open.push_back(next);
        }
      }
    }
  }
  return false;
}

}  // namespace goalnet::planner
