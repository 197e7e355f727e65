#include "components/goalnet/sym_state.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace goalnet::inference {
namespace {

constexpr const char* kRelations[] = {"Near",          "On",  "In", "Grasping", "state", "IsGraspable",
                                      "IsSqueezeable", "Held"};
constexpr std::string_view kGoalsOnly = "Held";

}  // namespace

void SymState::add(SymFact fact) {
  const auto at = std::lower_bound(facts_.begin(), facts_.end(), fact);
  if (at == facts_.end() || *at != fact) facts_.insert(at, fact);
}

void SymState::remove(SymFact fact) {
  const auto at = std::lower_bound(facts_.begin(), facts_.end(), fact);
  if (at != facts_.end() && *at == fact) facts_.erase(at);
}

SymState to_sym_state(const FactSet& facts, Symbols& symbols) {
  SymState state;
  state.facts_.reserve(facts.size());
  for (const Predicate& fact : facts) {
    const auto relation = std::find(std::begin(kRelations), std::end(kRelations), fact.relation);
    if (relation == std::end(kRelations) || fact.relation == kGoalsOnly) continue;
    const Symbol subject = symbols.intern(fact.subject);
    const Symbol object = fact.object.empty() ? Symbol{symbol::kNone} : symbols.intern(fact.object);
    if (subject == symbol::kNone || (object == symbol::kNone && !fact.object.empty())) continue;
    state.facts_.push_back(
        sym_fact(static_cast<Relation>(relation - std::begin(kRelations)), subject, object));
  }
  std::sort(state.facts_.begin(), state.facts_.end());
  state.facts_.erase(std::unique(state.facts_.begin(), state.facts_.end()), state.facts_.end());
  return state;
}

Predicate to_predicate(SymFact fact, const Symbols& symbols) {
  Predicate predicate;
  predicate.relation = kRelations[static_cast<std::size_t>(relation_of(fact))];
  predicate.subject = symbols.name(subject_of(fact));
  if (object_of(fact) != symbol::kNone) predicate.object = symbols.name(object_of(fact));
  return predicate;
}

FactSet to_fact_set(const SymState& state, const Symbols& symbols) {
  std::vector<Predicate> facts;
  facts.reserve(state.facts().size());
  for (const SymFact fact : state.facts()) facts.push_back(to_predicate(fact, symbols));
  return FactSet(std::move(facts));
}

SymDelta delta(const SymState& before, const SymState& after) {
  SymDelta result;
  const auto &a = before.facts(), &b = after.facts();
  // Properties sort last; they never change and are not scored.
  const auto end_a = std::lower_bound(a.begin(), a.end(), sym_fact(Relation::kIsGraspable, 0));
  const auto end_b = std::lower_bound(b.begin(), b.end(), sym_fact(Relation::kIsGraspable, 0));
  std::set_difference(b.begin(), end_b, a.begin(), end_a, std::back_inserter(result.added));
  std::set_difference(a.begin(), end_a, b.begin(), end_b, std::back_inserter(result.removed));
  return result;
}

}  // namespace goalnet::inference
