// Every state that a search has met, stored once under a dense number. States are compared by a key that may
// be a symmetric variant of the state itself. Nothing large is ever copied or hashed again at once: states
// lie in pieces, and the hash table is cut into shards that grow one by one, so that a search can be stopped
// at any time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "components/planner/chunks.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class StateTable {
 public:
  void restart(std::size_t words, bool separate_keys) {
    words_ = words;
    separate_keys_ = separate_keys;
    states_.restart(words);
    keys_.restart(words);
    count_ = 0;
    for (Shard& shard : shards_) {
      if (shard.used == 0) continue;
      shard.used = 0;
      if (shard.slots.size() > kKeptSlots) {
        shard.slots = {};
      } else {
        std::fill(shard.slots.begin(), shard.slots.end(), -1);
      }
    }
  }

  // The number of the state with this key, adding it if new.
  std::int32_t add(const Word* state, const Word* key, bool* is_new) {
    const std::size_t h = hash(key);
    Shard& shard = shards_[h & (kShards - 1)];
    if (2 * (shard.used + 1) > shard.slots.size()) grow(shard);
    std::int32_t& slot =
        find(shard, h, [&](std::int32_t id) { return std::equal(key, key + words_, key_of(id)); });
    *is_new = slot < 0;
    if (slot >= 0) return slot;
    ++shard.used;
    slot = count_;
    append(state, key);
    return slot;
  }

  const Word* state(std::int32_t id) const { return states_[static_cast<std::size_t>(id)]; }
  // Another state with the key of `old`, which from now on the key leads to. Returns its number.
  std::int32_t add_variant(const Word* state, std::int32_t old) {
    const std::size_t h = hash(key_of(old));
    find(shards_[h & (kShards - 1)], h, [&](std::int32_t id) { return id == old; }) = count_;
    const std::vector<Word> key(key_of(old), key_of(old) + words_);
    append(state, key.data());
    return count_ - 1;
  }
  std::int32_t size() const { return count_; }
  std::size_t words() const { return words_; }
  std::int64_t bytes() const {
    std::size_t slots = 0;
    for (const Shard& shard : shards_) slots += shard.slots.capacity();
    return static_cast<std::int64_t>(states_.bytes() + keys_.bytes() + slots * 4);
  }

 private:
  struct Shard {
    std::vector<std::int32_t> slots;  // open addressing, -1 = free; a power of two
    std::size_t used = 0;
  };
  static constexpr std::size_t kShards = 64, kShardBits = 6;
  static constexpr std::size_t kKeptSlots =
      1u << 10;  // clearing more would cost a quick query more than it takes

  const Word* key_of(std::int32_t id) const {
    return (separate_keys_ ? keys_ : states_)[static_cast<std::size_t>(id)];
  }
  void append(const Word* state, const Word* key) {
    states_.push_back(state);
    if (separate_keys_) keys_.push_back(key);
    ++count_;
  }
  template <class Same>
  static std::int32_t& find(Shard& shard, std::size_t hash, const Same& same) {
    const std::size_t mask = shard.slots.size() - 1;
    std::size_t slot = (hash >> kShardBits) & mask;
    while (shard.slots[slot] >= 0 && !same(shard.slots[slot])) slot = (slot + 1) & mask;
    return shard.slots[slot];
  }
  std::size_t hash(const Word* key) const {
    Word h = 0x9E3779B97F4A7C15ULL;
    for (std::size_t i = 0; i < words_; ++i) {
      h = (h ^ key[i]) * 0xD6E8FEB86659FD93ULL;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
  void grow(Shard& shard) {
    const std::vector<std::int32_t> old = std::move(shard.slots);
    shard.slots.assign(old.empty() ? 16 : old.size() * 2, -1);
    for (const std::int32_t id : old) {
      if (id >= 0) find(shard, hash(key_of(id)), [](std::int32_t) { return false; }) = id;
    }
  }

  std::size_t words_ = 1;
  bool separate_keys_ = false;
  Rows states_, keys_;
  std::array<Shard, kShards> shards_;
  std::int32_t count_ = 0;
};

}  // namespace goalnet::planner
