// A set of ground atoms with dense numbers: predicate and arguments ↔ 0, 1, 2, ...
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

  void clear() {
    predicates_.clear();
    arguments_.clear();
    offsets_.assign(1, 0);
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
    predicates_.push_back(predicate);
    arguments_.insert(arguments_.end(), arguments, arguments + count);
    offsets_.push_back(static_cast<std::uint32_t>(arguments_.size()));
    return atom;
  }

  std::int32_t size() const { return static_cast<std::int32_t>(predicates_.size()); }
  PredicateId predicate(std::int32_t atom) const { return predicates_[static_cast<std::size_t>(atom)]; }
  std::span<const ObjectId> arguments(std::int32_t atom) const {
    const auto i = static_cast<std::size_t>(atom);
    return {arguments_.data() + offsets_[i], offsets_[i + 1] - offsets_[i]};
  }
  AtomRef operator[](std::int32_t atom) const { return {predicate(atom), arguments(atom)}; }

 private:
  static std::uint64_t hash(PredicateId predicate, const ObjectId* arguments, std::size_t count) {
    std::uint64_t h = static_cast<std::uint64_t>(predicate) * 0x9E3779B97F4A7C15ULL;
    for (std::size_t i = 0; i < count; ++i) {
      h = (h ^ static_cast<std::uint32_t>(arguments[i])) * 0xD6E8FEB86659FD93ULL;
      h ^= h >> 32;
    }
    return h;
  }
  bool same(std::int32_t atom, PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    const auto i = static_cast<std::size_t>(atom);
    if (predicates_[i] != predicate || offsets_[i + 1] - offsets_[i] != count) return false;
    const ObjectId* mine = arguments_.data() + offsets_[i];
    for (std::size_t k = 0; k < count; ++k) {
      if (mine[k] != arguments[k]) return false;
    }
    return true;
  }

  std::vector<PredicateId> predicates_;
  std::vector<std::uint32_t> offsets_ = {0};
  std::vector<ObjectId> arguments_;
  HashIndex index_;
};

}  // namespace goalnet::planner
