// What the parser makes of conditions and effects: plain trees, close to the text.
#pragma once

#include <cstdint>
#include <vector>

namespace goalnet::planner {

using ObjectId = std::int32_t;     // constants of the domain come first, then objects of the problem
using PredicateId = std::int32_t;
using TypeId = std::int32_t;       // 0 is "object", the root
using TypeSet = std::vector<TypeId>;  // "(either a b)": any of them; never empty

// An object, or a variable by its slot. Parameters of an action have the first slots, quantified variables the
// following ones, so that one array of objects binds them all.
struct Term {
  std::int32_t value = 0;

  static Term object(ObjectId id) { return {id}; }
  static Term variable(std::int32_t slot) { return {~slot}; }
  bool is_variable() const { return value < 0; }
  std::int32_t slot() const { return ~value; }
  ObjectId resolve(const ObjectId* binding) const { return value < 0 ? binding[~value] : value; }
  bool operator==(const Term&) const = default;
};

struct AtomPattern {
  PredicateId predicate = 0;
  std::vector<Term> arguments;
  bool operator==(const AtomPattern&) const = default;
};

struct Formula {
  enum class Kind : std::uint8_t { kTrue, kFalse, kAtom, kEqual, kNot, kAnd, kOr, kForall, kExists };
  Kind kind = Kind::kTrue;
  AtomPattern atom;                 // kAtom; kEqual uses its two arguments
  std::vector<Formula> children;    // kNot, kForall, kExists: one; kAnd, kOr: any number
  std::vector<std::int32_t> slots;  // kForall, kExists: the variables bound here
};

struct Effect {
  enum class Kind : std::uint8_t { kAdd, kDelete, kAnd, kForall, kWhen };
  Kind kind = Kind::kAnd;
  AtomPattern atom;                 // kAdd, kDelete
  Formula condition;                // kWhen
  std::vector<Effect> children;     // kAnd: any number; kForall, kWhen: one
  std::vector<std::int32_t> slots;  // kForall
};

}  // namespace goalnet::planner
