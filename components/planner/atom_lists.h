// Ground atoms that are found by predicate and by any one of their arguments; for joins over facts that
// become known little by little. What is added while a list is visited is not met there. Internal to the
// planner.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/atom_table.h"
#include "components/planner/growing.h"

namespace goalnet::planner {

class AtomLists {
 public:
  struct List {
    std::int32_t first = -1;  // in links_
    std::int32_t size = 0;
  };

  // For atoms of the predicates for which `covered` is not 0.
  void restart(std::vector<std::uint8_t> covered) {
    covered_ = std::move(covered);
    atoms_.clear();
    keys_.clear();
    lists_.clear();
    links_.clear();
  }
  bool covers(PredicateId predicate) const { return covered_[static_cast<std::size_t>(predicate)] != 0; }
  std::int32_t size() const { return atoms_.size(); }
  AtomRef operator[](std::int32_t atom) const { return atoms_[atom]; }
  bool contains(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    return atoms_.contains(predicate, arguments, count);
  }

  void add(PredicateId predicate, const ObjectId* arguments, std::size_t count) {
    bool is_new = false;
    const std::int32_t atom = atoms_.add(predicate, arguments, count, &is_new);
    if (!is_new) return;
    enlist(atom, key(predicate, kAll), 0);
    for (std::size_t i = 0; i < count; ++i) enlist(atom, key(predicate, i), arguments[i]);
  }

  List with(PredicateId predicate) const { return find(key(predicate, kAll), 0); }
  List with(PredicateId predicate, std::size_t position, ObjectId object) const {
    return find(key(predicate, position), object);
  }
  // visit(atom) for each, newest first, as long as that answers true; false where it did not.
  template <class Visit>
  bool each(const List& list, const Visit& visit) const {
    for (std::int32_t link = list.first; link >= 0; link = links_[static_cast<std::size_t>(link)].next) {
      if (!visit(atoms_[links_[static_cast<std::size_t>(link)].atom])) return false;
    }
    return true;
  }

 private:
  struct Link {
    std::int32_t atom, next;
  };
  static constexpr std::size_t kAll = 16;  // in place of a position
  static PredicateId key(PredicateId predicate, std::size_t position) {
    return predicate * static_cast<PredicateId>(kAll + 1) + static_cast<PredicateId>(position);
  }
  List find(PredicateId key, ObjectId object) const {
    const std::int32_t list = keys_.find(key, &object, 1);
    return list == AtomTable::kNone ? List{} : lists_[static_cast<std::size_t>(list)];
  }
  void enlist(std::int32_t atom, PredicateId key, ObjectId object) {
    bool is_new = false;
    const auto number = static_cast<std::size_t>(keys_.add(key, &object, 1, &is_new));
    if (is_new) lists_.push_back({});
    List& list = lists_[number];
    links_.push_back({atom, list.first});
    list.first = static_cast<std::int32_t>(links_.size() - 1);
    ++list.size;
  }

  std::vector<std::uint8_t> covered_;
  AtomTable atoms_;
  AtomTable keys_;  // key and object → number of the list
  Growing<List> lists_;
  Growing<Link> links_;
};

}  // namespace goalnet::planner
