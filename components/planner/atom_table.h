// A set of ground atoms with dense numbers: predicate and arguments ↔ 0, 1, 2, ...
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "components/planner/arena.h"
#include "components/planner/chunks.h"
#include "components/planner/formula.h"
#include "components/planner/hash_index.h"

namespace goalnet::planner {

struct AtomRef {
  PredicateId predicate;
  std::span<const ObjectId> arguments;
};

// clear() keeps the memory, so that a reused table stops allocating.
class AtomTable {
 public:
  static constexpr std::int32_t kNone = HashIndex::kNone;

  AtomTable() = default;
  AtomTable(AtomTable&&) = default;
  AtomTable& operator=(AtomTable&&) = default;
  AtomTable(const AtomTable& other) { *this = other; }
  AtomTable& operator=(const AtomTable& other) {
    if (this == &other) return *this;
    clear();
    for (const Entry& atom : other.atoms_) add(atom.predicate, atom.arguments, atom.count);
    return *this;
  }

  void clear() {
    atoms_.clear();
    arguments_.clear();
    index_.clear();
  }

  std::int32_t find(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    return index_.find(hash(predicate, arguments, count),
                       [&](std::int32_t atom) { return same(atom, predicate, arguments, count); });
  }
  bool contains(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    return find(predicate, arguments, count) != kNone;
  }

  // Returns the atom's number; `is_new` tells whether it was added now.
  std::int32_t add(PredicateId predicate, const ObjectId* arguments, std::size_t count,
                   bool* is_new = nullptr) {
    const std::int32_t next = size();
    const std::int32_t atom = index_.find_or_add(
        hash(predicate, arguments, count), next,
        [&](std::int32_t other) { return same(other, predicate, arguments, count); },
        [this](std::int32_t other) {
          const auto mine = this->arguments(other);
          return hash(this->predicate(other), mine.data(), mine.size());
        });
    if (is_new != nullptr) *is_new = atom == next;
    if (atom != next) return atom;
    atoms_.push_back(
        {arguments_.copy(std::span(arguments, count)).data(), predicate, static_cast<std::uint32_t>(count)});
    return atom;
  }

  std::int32_t size() const { return static_cast<std::int32_t>(atoms_.size()); }
  PredicateId predicate(std::int32_t atom) const { return entry(atom).predicate; }
  std::span<const ObjectId> arguments(std::int32_t atom) const {
    return {entry(atom).arguments, entry(atom).count};
  }
  AtomRef operator[](std::int32_t atom) const { return {predicate(atom), arguments(atom)}; }

  // visit(predicate) for every atom in turn, as long as that answers true.
  template <class Visit>
  bool each_predicate(const Visit& visit) const {
    return atoms_.each([&](const Entry& atom) { return visit(atom.predicate); });
  }

 private:
  struct Entry {
    const ObjectId* arguments;
    PredicateId predicate;
    std::uint32_t count;
  };
  const Entry& entry(std::int32_t atom) const { return atoms_[static_cast<std::size_t>(atom)]; }
  static std::uint64_t hash(PredicateId predicate, const ObjectId* arguments, std::size_t count) {
    std::uint64_t h = static_cast<std::uint64_t>(predicate) * 0x9E3779B97F4A7C15ULL;
    for (std::size_t i = 0; i < count; ++i) {
      h = (h ^ static_cast<std::uint32_t>(arguments[i])) * 0xD6E8FEB86659FD93ULL;
      h ^= h >> 32;
    }
    return h;
  }
  bool same(std::int32_t atom, PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    const Entry& mine = entry(atom);
    if (mine.predicate != predicate || mine.count != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (mine.arguments[i] != arguments[i]) return false;
    }
    return true;
  }

  Chunks<Entry> atoms_;
  Arena arguments_;
  HashIndex index_;
};

}  // namespace goalnet::planner
