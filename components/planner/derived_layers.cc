#include "components/planner/derived_layers.h"

#include <algorithm>

namespace goalnet::planner {
namespace {

struct Use {
  PredicateId from, to;
  bool negative;
};

void collect(PredicateId from, const Formula& formula, bool negative, std::vector<Use>* uses) {
  if (formula.kind == Formula::Kind::kAtom) uses->push_back({from, formula.atom.predicate, negative});
  const bool inner = negative != (formula.kind == Formula::Kind::kNot);
  for (const Formula& child : formula.children) collect(from, child, inner, uses);
}

}  // namespace

std::optional<PredicateId> assign_layers(Domain& domain) {
  const auto count = static_cast<std::size_t>(domain.predicates.size());
  domain.layer.assign(count, -1);
  std::vector<Use> uses;
  for (const DerivedPredicate& definition : domain.derived)
    collect(definition.predicate, definition.body, false, &uses);
  const auto at = [](PredicateId predicate) { return static_cast<std::size_t>(predicate); };
  // What each derived predicate leads to, directly or through others.
  std::vector<std::vector<std::uint8_t>> reaches(count);
  for (const DerivedPredicate& definition : domain.derived) {
    auto& mine = reaches[at(definition.predicate)];
    if (!mine.empty()) continue;
    mine.assign(count, 0);
    std::vector<PredicateId> open = {definition.predicate};
    while (!open.empty()) {
      const PredicateId current = open.back();
      open.pop_back();
      for (const Use& use : uses) {
        if (use.from != current || mine[at(use.to)] != 0) continue;
        mine[at(use.to)] = 1;
        open.push_back(use.to);
      }
    }
  }
  const auto leads = [&](PredicateId from, PredicateId to) {
    return !reaches[at(from)].empty() && reaches[at(from)][at(to)] != 0;
  };
  for (const Use& use : uses) {
    if (use.negative && (use.from == use.to || leads(use.to, use.from))) return use.from;
  }
  for (const DerivedPredicate& definition : domain.derived) {
    if (leads(definition.predicate, definition.predicate)) domain.layer[at(definition.predicate)] = 0;
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (PredicateId p = 0; p < domain.predicates.size(); ++p) {
      if (domain.layer[at(p)] < 0) continue;
      for (PredicateId q = 0; q < domain.predicates.size(); ++q) {
        if (domain.layer[at(q)] < 0 || !leads(p, q)) continue;
        const std::int32_t least = domain.layer[at(q)] + (leads(q, p) ? 0 : 1);
        if (domain.layer[at(p)] >= least) continue;
        domain.layer[at(p)] = least;
        grows = true;
      }
    }
  }
  return std::nullopt;
}

}  // namespace goalnet::planner
