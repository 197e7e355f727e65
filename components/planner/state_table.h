// Every state that a search has met, stored once: dense numbers, flat memory. States are compared by a key that may be
// a symmetric variant of the state itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "components/planner/ground_task.h"

namespace goalnet::planner {

class StateTable {
 public:
  void restart(std::size_t words, bool separate_keys) {
    words_ = words;
    separate_keys_ = separate_keys;
    states_.clear();
    keys_.clear();
    count_ = 0;
    if (slots_.size() > kKeptSlots) slots_ = {};
    std::fill(slots_.begin(), slots_.end(), -1);
  }

  // The number of the state with this key, adding it if new.
  std::int32_t add(const Word* state, const Word* key, bool* is_new) {
    if (2 * (static_cast<std::size_t>(count_) + 1) > slots_.size()) grow();
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(key) & mask;
    while (slots_[slot] >= 0) {
      if (std::equal(key, key + words_, key_of(slots_[slot]))) {
        *is_new = false;
        return slots_[slot];
      }
      slot = (slot + 1) & mask;
    }
    slots_[slot] = count_;
    states_.insert(states_.end(), state, state + words_);
    if (separate_keys_) keys_.insert(keys_.end(), key, key + words_);
    *is_new = true;
    return count_++;
  }

  const Word* state(std::int32_t id) const { return states_.data() + static_cast<std::size_t>(id) * words_; }
  // Another state with the key of `old`, which from now on the key leads to. Returns its number.
  std::int32_t add_variant(const Word* state, std::int32_t old) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(key_of(old)) & mask;
    while (slots_[slot] != old) slot = (slot + 1) & mask;
    slots_[slot] = count_;
    states_.insert(states_.end(), state, state + words_);
    if (separate_keys_) {
      const std::size_t begin = static_cast<std::size_t>(old) * words_;
      for (std::size_t i = 0; i < words_; ++i) keys_.push_back(Word{keys_[begin + i]});
    }
    return count_++;
  }
  std::int32_t size() const { return count_; }
  std::int64_t bytes() const {
    return static_cast<std::int64_t>((states_.capacity() + keys_.capacity()) * sizeof(Word) + slots_.capacity() * 4);
  }

 private:
  static constexpr std::size_t kKeptSlots = 1u << 12;  // clearing more would cost a quick query more than it takes

  const Word* key_of(std::int32_t id) const {
    return (separate_keys_ ? keys_.data() : states_.data()) + static_cast<std::size_t>(id) * words_;
  }
  std::size_t hash(const Word* key) const {
    Word h = 0x9E3779B97F4A7C15ULL;
    for (std::size_t i = 0; i < words_; ++i) {
      h = (h ^ key[i]) * 0xD6E8FEB86659FD93ULL;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
  void grow() {
    slots_.assign(slots_.empty() ? 64 : slots_.size() * 2, -1);
    const std::size_t mask = slots_.size() - 1;
    for (std::int32_t id = 0; id < count_; ++id) {
      std::size_t slot = hash(key_of(id)) & mask;
      while (slots_[slot] >= 0) slot = (slot + 1) & mask;
      slots_[slot] = id;
    }
  }

  std::size_t words_ = 1;
  bool separate_keys_ = false;
  std::vector<Word> states_, keys_;
  std::vector<std::int32_t> slots_;
  std::int32_t count_ = 0;
};

}  // namespace goalnet::planner
