// Reads conditions and effects straight from the parsed text and applies them to a set of atoms. Slow and
// simple: the validator and world.h use it; the search does not.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "components/planner/atom_table.h"
#include "components/planner/problem.h"

namespace goalnet::planner {

// Atoms that hold now. Numbers of atoms stay valid when they stop holding.
class AtomSet {
 public:
  void assign(const AtomTable& atoms);
  bool contains(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    const std::int32_t atom = table_.find(predicate, arguments, count);
    return atom != AtomTable::kNone && holds_[static_cast<std::size_t>(atom)] != 0;
  }
  void set(PredicateId predicate, const ObjectId* arguments, std::size_t count, bool holds);
  void set(std::int32_t atom, bool holds) { holds_[static_cast<std::size_t>(atom)] = holds ? 1 : 0; }
  const AtomTable& table() const { return table_; }
  bool holds(std::int32_t atom) const { return holds_[static_cast<std::size_t>(atom)] != 0; }

 private:
  AtomTable table_;
  std::vector<std::uint8_t> holds_;
};

struct AtomChange {
  PredicateId predicate;
  std::vector<ObjectId> arguments;
  bool added;
};

// Not thread-safe.
class Interpreter {
 public:
  explicit Interpreter(const Problem& problem);

  // Sets the derived facts that depend on themselves ("above") as the others demand. To be called for a state
  // before it is asked for anything, and again after every change.
  void complete(AtomSet& state) const;

  // `binding` gives the parameters and has room for all slots; `slots` are their types.
  bool holds(const Formula& formula, std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
             const AtomSet& state) const;

  // Everything the effect does to `state`, evaluated on `state`: first deletions, then additions.
  std::vector<AtomChange> changes(const Effect& effect, std::span<const TypeSet> slots,
                                  std::vector<ObjectId>& binding, const AtomSet& state) const;

  // The first part of `formula` that fails, as text: "(state Microwave DoorIsOpen) does not hold". For
  // messages.
  std::string why_not(const Formula& formula, std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
                      const AtomSet& state) const;

  // "(On Mug_1 Sink)"; unbound variables are shown as "?".
  std::string text(const AtomPattern& atom, const std::vector<ObjectId>& binding) const;

  // The action's parameters from names: checks name, count and types. Errors: kInvalidRequest,
  // kUnknownObject.
  Expected<const ActionSchema*> bind(const Action& action, std::vector<ObjectId>& binding) const;

  // Metric cost of one action: 1, or what it adds to total-cost.
  Expected<std::int64_t> cost(const ActionSchema& schema, const std::vector<ObjectId>& binding) const;

 private:
  // Calls visit() for every way to bind the variables from `index` on; stops and returns false when visit()
  // does.
  bool for_each_binding(std::span<const std::int32_t> variables, std::size_t index,
                        std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
                        const std::function<bool()>& visit) const;
  // The value of a quantifier over `inner`, which visit() judges once all variables are bound. Bindings that
  // decide nothing (something under 'exists' does not hold, something under 'forall' does) are left out as
  // early as that shows.
  template <class Visit>
  bool quantified(std::span<const std::int32_t> variables, std::size_t index, const Formula& inner,
                  bool universal, std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
                  const AtomSet& state, const Visit& visit) const;
  // Whether a part of `inner` without open variables (-1) makes all of it true (universal) or false.
  bool decided(const Formula& inner, bool universal, const std::vector<ObjectId>& binding,
               const AtomSet& state) const;
  // What `slot` can be for the facts that never change to allow it, if that is fewer than all of its type.
  const std::vector<ObjectId>* candidates(const Formula& inner, bool universal, std::int32_t slot,
                                          std::size_t most, const std::vector<ObjectId>& binding) const;
  const std::vector<ObjectId>& partners(PredicateId predicate, std::size_t given, ObjectId object,
                                        std::size_t wanted) const;
  bool atom_holds(const AtomPattern& atom, const std::vector<ObjectId>& binding, const AtomSet& state) const;
  void collect(const Effect& effect, std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
               const AtomSet& state, std::vector<AtomChange>* added, std::vector<AtomChange>* deleted) const;

  const std::vector<ObjectId>& objects(const TypeSet& types) const;

  const Problem& problem_;
  std::vector<std::vector<const DerivedPredicate*>> definitions_;  // by predicate, of those without a layer
  // Found when first asked for:
  mutable std::map<TypeSet, std::vector<ObjectId>> objects_;
  mutable std::vector<std::uint8_t> fixed_;  // by predicate: nothing changes it
  // By predicate, place given, place wanted: by the object given, the objects of the facts that have it.
  mutable std::map<std::tuple<PredicateId, std::size_t, std::size_t>, std::vector<std::vector<ObjectId>>>
      partners_;
};

}  // namespace goalnet::planner
