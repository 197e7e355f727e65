// A planning problem: objects, the initial state and the goal, in the numbers of one domain.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/planner/atom_table.h"
#include "components/planner/domain.h"

namespace goalnet::planner {

// Refers to its Domain, which must outlive it. Immutable after construction; may be read from several
// threads.
class Problem {
 public:
  explicit Problem(const Domain& domain) : domain_(&domain) { restart(); }

  const Domain& domain() const { return *domain_; }
  std::string name;
  AtomTable initial;                      // the atoms that hold at first
  AtomTable cost_atoms;                   // function values: `predicate` is the function
  std::vector<std::int64_t> cost_values;  // parallel to cost_atoms
  Formula goal;                           // may contain quantified variables
  std::vector<TypeSet> goal_slots;        // their types
  bool minimise_cost = false;             // (:metric minimize (total-cost)); otherwise the number of actions

  // Every object: constants of the domain first. `present` tells which of them exist in this problem;
  // constants of the domain that a world lacks do not take part.
  std::int32_t object_count() const { return static_cast<std::int32_t>(object_types_.size()); }
  std::string object_name(ObjectId id) const;
  ObjectId find_object(std::string_view name) const;  // SymbolTable::kNone if unknown
  TypeId object_type(ObjectId id) const { return object_types_[static_cast<std::size_t>(id)]; }
  bool present(ObjectId id) const { return present_[static_cast<std::size_t>(id)] != 0; }
  bool object_is_a(ObjectId id, const TypeSet& types) const {
    return present(id) && domain_->is_a(object_type(id), types);
  }
  std::vector<std::string> first_object_names()
      const;  // of those present, as many as did_you_mean() looks at

  // For those who build problems. add_object fails silently on a duplicate: ask find_object first.
  ObjectId add_object(std::string_view object_name, TypeId type);
  void set_present(ObjectId id, bool present) { present_[static_cast<std::size_t>(id)] = present ? 1 : 0; }
  // Where the goal is built.
  Arena& arena() { return arena_; }
  // Forgets everything but the domain; keeps the memory.
  void restart();

 private:
  const Domain* domain_;
  SymbolTable objects_;
  Chunks<TypeId> object_types_;
  Chunks<std::uint8_t> present_;
  Arena arena_;
};

// Parses a PDDL problem for `domain`. Errors as in parse_domain.
Expected<Problem> parse_problem(std::string_view text, std::string_view filename, const Domain& domain,
                                const std::stop_token& stop = {});
Expected<Problem> load_problem(const std::string& path, const Domain& domain,
                               const std::stop_token& stop = {});

}  // namespace goalnet::planner
