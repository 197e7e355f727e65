// From hashes to numbers 0, 1, 2, ... whose keys somebody else keeps. Adding never takes long, however many
// there are: the table is cut into pieces by the first bits of the hash, and a piece that is full is split in
// two (extendible hashing, Fagin et al. 1979), so that who adds can be stopped at any time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "components/planner/arena.h"

namespace goalnet::planner {

class HashIndex {
 public:
  static constexpr std::int32_t kNone = -1;

  HashIndex() = default;
  HashIndex(HashIndex&& other) noexcept { swap(other); }
  HashIndex& operator=(HashIndex&& other) noexcept {
    HashIndex(std::move(other)).swap(*this);
    return *this;
  }

  // Forgets all; a small index keeps its memory, so that a reused one stops allocating.
  void clear() {
    used_ = 0;
    first_.used = 0;
    if (bits_ > 0) {
      bits_ = 0;
      pieces_.clear();
      directory_.clear();
      memory_.clear();
      first_ = {};
    }
    if (++generation_ == 0) {  // wrapped: stale slots could look fresh
      std::fill_n(first_.slots, first_.size, Slot{});
      generation_ = 1;
    }
  }

  // The number with this hash that `same` accepts, or kNone.
  template <class Same>
  std::int32_t find(std::uint64_t hash, const Same& same) const {
    if (used_ == 0) return kNone;
    const Piece& piece = bits_ == 0 ? first_ : pieces_[place(hash)];
    const std::size_t mask = piece.size - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
      const Slot slot = piece.slots[at];
      if (slot.generation != generation_) return kNone;
      if (same(slot.number)) return slot.number;
    }
  }

  // The same, adding the number `next` (the caller's count so far) if there is none. `hash_of` gives the
  // hashes of numbers added before.
  template <class Same, class HashOf>
  std::int32_t find_or_add(std::uint64_t hash, std::int32_t next, const Same& same, const HashOf& hash_of) {
    while (2 * (piece_of(hash).used + 1) > piece_of(hash).size) make_room(hash, hash_of);
    Piece& piece = piece_of(hash);
    const std::size_t mask = piece.size - 1;
    std::size_t at = hash & mask;
    for (; piece.slots[at].generation == generation_; at = (at + 1) & mask) {
      if (same(piece.slots[at].number)) return piece.slots[at].number;
    }
    piece.slots[at] = {generation_, next};
    ++piece.used;
    ++used_;
    return next;
  }

 private:
  struct Slot {
    std::uint32_t generation = 0;  // free unless it is the index's
    std::int32_t number = kNone;
  };
  struct Piece {
    Slot* slots = nullptr;  // open addressing
    std::size_t size = 0;   // a power of two
    std::size_t used = 0;
    unsigned bits = 0;  // of the hash that all in here share
  };
  static constexpr std::size_t kFewestSlots = 64, kMostSlots = std::size_t{1} << 12;
  static constexpr unsigned kMostBits = 20;

  std::size_t place(std::uint64_t hash) const { return directory_[hash >> (64 - bits_)]; }
  Piece& piece_of(std::uint64_t hash) { return bits_ == 0 ? first_ : pieces_[place(hash)]; }

  // In the piece that this hash belongs to.
  template <class HashOf>
  void make_room(std::uint64_t hash, const HashOf& hash_of) {
    Piece& full = piece_of(hash);
    if (full.size < kMostSlots || full.bits == kMostBits) {
      const Piece old = full;
      give_slots(full, old.size == 0 ? kFewestSlots : 2 * old.size);
      for (const Slot& slot : std::span(old.slots, old.size)) {
        if (slot.generation == generation_) put(full, slot, hash_of(slot.number));
      }
      return;
    }
    if (bits_ == 0) {
      pieces_.push_back(std::exchange(first_, Piece{}));
      directory_ = {0};
    }
    const std::size_t at = bits_ == 0 ? 0 : place(hash);
    if (pieces_[at].bits == bits_) {  // one more bit of the hash: every entry of the directory twice
      std::vector<std::uint32_t> twice;
      twice.reserve(2 * directory_.size());
      for (const std::uint32_t piece : directory_) twice.insert(twice.end(), 2, piece);
      directory_ = std::move(twice);
      ++bits_;
    }
    const std::vector<Slot> old(pieces_[at].slots, pieces_[at].slots + pieces_[at].size);
    const auto other = static_cast<std::uint32_t>(pieces_.size());
    pieces_.emplace_back();
    give_slots(pieces_.back(), kMostSlots);
    std::fill_n(pieces_[at].slots, kMostSlots, Slot{});
    const unsigned bits = pieces_.back().bits = ++pieces_[at].bits;
    pieces_[at].used = 0;
    for (std::size_t i = 0; i < directory_.size(); ++i) {
      if (directory_[i] == at && ((i >> (bits_ - bits)) & 1) != 0) directory_[i] = other;
    }
    for (const Slot& slot : old) {
      if (slot.generation != generation_) continue;
      const std::uint64_t its_hash = hash_of(slot.number);
      Piece& piece = pieces_[place(its_hash)];
      put(piece, slot, its_hash);
      ++piece.used;
    }
  }
  void swap(HashIndex& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(first_, other.first_);
    std::swap(pieces_, other.pieces_);
    std::swap(directory_, other.directory_);
    std::swap(bits_, other.bits_);
    std::swap(used_, other.used_);
    std::swap(generation_, other.generation_);
  }
  void give_slots(Piece& piece, std::size_t size) {
    piece.slots = memory_.allocate<Slot>(size);
    piece.size = size;
    std::uninitialized_fill_n(piece.slots, size, Slot{});
  }
  void put(Piece& piece, Slot slot, std::uint64_t hash) {
    const std::size_t mask = piece.size - 1;
    std::size_t at = hash & mask;
    while (piece.slots[at].generation == generation_) at = (at + 1) & mask;
    piece.slots[at] = slot;
  }

  Arena memory_;
  Piece first_;                           // all there is while bits_ is 0
  std::vector<Piece> pieces_;             // after that
  std::vector<std::uint32_t> directory_;  // by the first bits_ bits of the hash: number of the piece
  unsigned bits_ = 0;
  std::size_t used_ = 0;
  std::uint32_t generation_ = 1;
};

}  // namespace goalnet::planner
