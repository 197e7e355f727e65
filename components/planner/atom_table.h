// A set of ground atoms with dense numbers: predicate and arguments ↔ 0, 1, 2, ...
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/formula.h"

namespace goalnet::planner {

struct AtomRef {
  PredicateId predicate;
  std::span<const ObjectId> arguments;
};

// Open addressing over flat arrays. clear() keeps the memory, so that a reused table stops allocating.
class AtomTable {
 public:
  static constexpr std::int32_t kNone = -1;

  void clear() {
    predicates_.clear();
    arguments_.clear();
    offsets_.assign(1, 0);
    ++generation_;
    if (generation_ == 0) {  // wrapped: stale slots could look fresh
      std::fill(slots_.begin(), slots_.end(), Slot{});
      generation_ = 1;
    }
  }

  std::int32_t find(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    if (slots_.empty()) return kNone;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(predicate, arguments, count) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot].generation != generation_) return kNone;
      if (same(slots_[slot].atom, predicate, arguments, count)) return slots_[slot].atom;
    }
  }
  bool contains(PredicateId predicate, const ObjectId* arguments, std::size_t count) const {
    return find(predicate, arguments, count) != kNone;
  }

  // Returns the atom's number; `is_new` tells whether it was added now.
  std::int32_t add(PredicateId predicate, const ObjectId* arguments, std::size_t count, bool* is_new = nullptr) {
    if (2 * (predicates_.size() + 1) > slots_.size()) grow();
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(predicate, arguments, count) & mask;
    while (slots_[slot].generation == generation_) {
      if (same(slots_[slot].atom, predicate, arguments, count)) {
        if (is_new != nullptr) *is_new = false;
        return slots_[slot].atom;
      }
      slot = (slot + 1) & mask;
    }
    const auto atom = static_cast<std::int32_t>(predicates_.size());
    slots_[slot] = {generation_, atom};
    predicates_.push_back(predicate);
    arguments_.insert(arguments_.end(), arguments, arguments + count);
    offsets_.push_back(static_cast<std::uint32_t>(arguments_.size()));
    if (is_new != nullptr) *is_new = true;
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
  struct Slot {
    std::uint32_t generation = 0;
    std::int32_t atom = kNone;
  };

  static std::size_t hash(PredicateId predicate, const ObjectId* arguments, std::size_t count) {
    std::uint64_t h = static_cast<std::uint64_t>(predicate) * 0x9E3779B97F4A7C15ULL;
    for (std::size_t i = 0; i < count; ++i) {
      h = (h ^ static_cast<std::uint32_t>(arguments[i])) * 0xD6E8FEB86659FD93ULL;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
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
  void grow() {
    slots_.assign(slots_.empty() ? 64 : slots_.size() * 2, Slot{});
    generation_ = 1;
    const std::size_t mask = slots_.size() - 1;
    for (std::int32_t atom = 0; atom < size(); ++atom) {
      const auto args = this->arguments(atom);
      std::size_t slot = hash(predicate(atom), args.data(), args.size()) & mask;
      while (slots_[slot].generation == generation_) slot = (slot + 1) & mask;
      slots_[slot] = {generation_, atom};
    }
  }

  std::vector<PredicateId> predicates_;
  std::vector<std::uint32_t> offsets_ = {0};
  std::vector<ObjectId> arguments_;
  std::vector<Slot> slots_;
  std::uint32_t generation_ = 1;
};

}  // namespace goalnet::planner
