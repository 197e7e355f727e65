// A world state as sorted numbers: small, cheap to copy and to compare.
#pragma once

#include <cstdint>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/symbols.h"

namespace goalnet::inference {

// kHeld stands in goals only ("on the tray"): no state here has it, for the benchmark's rules know no tray.
enum class Relation : std::uint32_t {
  kNear,
  kOn,
  kIn,
  kGrasping,
  kState,
  kIsGraspable,
  kIsSqueezeable,
  kHeld
};

// Relation, subject and object in one number, ordered by them.
using SymFact = std::uint32_t;

constexpr SymFact sym_fact(Relation relation, Symbol subject, Symbol object = symbol::kNone) {
  return static_cast<SymFact>(relation) << 28 | static_cast<SymFact>(subject) << 14 | object;
}
constexpr Relation relation_of(SymFact fact) { return static_cast<Relation>(fact >> 28); }
constexpr Symbol subject_of(SymFact fact) { return static_cast<Symbol>(fact >> 14 & 0x3fffu); }
constexpr Symbol object_of(SymFact fact) { return static_cast<Symbol>(fact & 0x3fffu); }

class SymState {
 public:
  bool has(SymFact fact) const {
    // Halved without branches: which way to go is anyone's guess, a processor's too.
    const SymFact* at = facts_.data();
    for (std::size_t left = facts_.size(); left > 1;) {
      const std::size_t half = left / 2;
      at += half & (std::size_t{0} - static_cast<std::size_t>(at[half - 1] < fact));
      left -= half;
    }
    return !facts_.empty() && *at == fact;
  }
  bool has(Relation relation, Symbol subject, Symbol object = symbol::kNone) const {
    return has(sym_fact(relation, subject, object));
  }
  void add(SymFact fact);
  void remove(SymFact fact);
  template <class Test>
  void remove_if(Test test) {
    std::erase_if(facts_, test);
  }
  const std::vector<SymFact>& facts() const { return facts_; }
  bool operator==(const SymState&) const = default;

  bool holds(Symbol object) const { return has(Relation::kGrasping, symbol::kRobot, object); }
  bool near(Symbol object) const { return has(Relation::kNear, symbol::kRobot, object); }
  bool is(Symbol object, Symbol value) const { return has(Relation::kState, object, value); }

 private:
  friend SymState to_sym_state(const FactSet& facts, Symbols& symbols);
  std::vector<SymFact> facts_;  // sorted, unique
};

// Facts of unknown relations (Held, ...) and of names past the table's end are left out.
SymState to_sym_state(const FactSet& facts, Symbols& symbols);
Predicate to_predicate(SymFact fact, const Symbols& symbols);
FactSet to_fact_set(const SymState& state, const Symbols& symbols);

// What `after` has and `before` lacks, and the other way round. Properties (IsGraspable, ...) count for
// nothing.
struct SymDelta {
  std::vector<SymFact> added, removed;  // sorted
  bool empty() const { return added.empty() && removed.empty(); }
  bool operator==(const SymDelta&) const = default;
};
SymDelta delta(const SymState& before, const SymState& after);

}  // namespace goalnet::inference
