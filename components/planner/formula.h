// What the parser makes of conditions and effects: plain trees, close to the text, in the arena of the domain
// or problem. Copies share what is below them, so nothing is changed once it is built.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "components/planner/arena.h"

namespace goalnet::planner {

using ObjectId = std::int32_t;  // constants of the domain come first, then objects of the problem
using PredicateId = std::int32_t;
using TypeId = std::int32_t;    // 0 is "object", the root
using TypeSet = Array<TypeId>;  // "(either a b)": any of them; never empty

// An object, or a variable by its slot. Parameters of an action have the first slots, quantified variables
// the following ones, so that one array of objects binds them all.
struct Term {
  std::int32_t value = 0;

  static Term object(ObjectId id) { return {id}; }
  static Term variable(std::int32_t slot) { return {~slot}; }
  bool is_variable() const { return value < 0; }
  std::int32_t slot() const { return ~value; }
  ObjectId resolve(const ObjectId* binding) const { return value < 0 ? binding[~value] : value; }
  bool operator==(const Term&) const = default;
};

// The arguments of an atom, in place: patterns are copied by the thousand while a domain is compiled.
class TermList {
 public:
  static constexpr std::size_t kMost = 16;  // the parser refuses predicates with more

  TermList() = default;
  TermList(std::initializer_list<Term> terms) {
    for (const Term term : terms) push_back(term);
  }
  void push_back(Term term) { terms_[size_++] = term; }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Term& operator[](std::size_t i) { return terms_[i]; }
  Term operator[](std::size_t i) const { return terms_[i]; }
  Term* begin() { return terms_.data(); }
  Term* end() { return terms_.data() + size_; }
  const Term* begin() const { return terms_.data(); }
  const Term* end() const { return terms_.data() + size_; }
  bool operator==(const TermList& other) const {
    if (size_ != other.size_) return false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!(terms_[i] == other.terms_[i])) return false;
    }
    return true;
  }

 private:
  std::array<Term, kMost> terms_{};
  std::uint32_t size_ = 0;
};

struct AtomPattern {
  PredicateId predicate = 0;
  TermList arguments;
  bool operator==(const AtomPattern&) const = default;
};

struct Formula {
  enum class Kind : std::uint8_t { kTrue, kFalse, kAtom, kEqual, kNot, kAnd, kOr, kForall, kExists };
  Kind kind = Kind::kTrue;
  AtomPattern atom;           // kAtom; kEqual uses its two arguments
  List<Formula> children;     // kNot, kForall, kExists: one; kAnd, kOr: any number
  Array<std::int32_t> slots;  // kForall, kExists: the variables bound here
};

struct Effect {
  enum class Kind : std::uint8_t { kAdd, kDelete, kAnd, kForall, kWhen };
  Kind kind = Kind::kAnd;
  AtomPattern atom;           // kAdd, kDelete
  Formula condition;          // kWhen
  List<Effect> children;      // kAnd: any number; kForall, kWhen: one
  Array<std::int32_t> slots;  // kForall
};

}  // namespace goalnet::planner
