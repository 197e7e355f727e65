// A growing array in pieces of equal size: growing it never copies what is there, so that it never takes long
// and never needs twice the memory; nor does freeing it (arena.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

#include "components/planner/arena.h"

namespace goalnet::planner {

template <class T>
class Chunks {
  template <class Owner, class Element>
  class IteratorOf {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Element*;
    using reference = Element&;
    IteratorOf() = default;
    IteratorOf(Owner* owner, std::size_t at) : owner_(owner), at_(at) {}
    Element& operator*() const { return (*owner_)[at_]; }
    Element* operator->() const { return &(*owner_)[at_]; }
    IteratorOf& operator++() {
      ++at_;
      return *this;
    }
    IteratorOf operator++(int) { return {owner_, at_++}; }
    bool operator==(const IteratorOf&) const = default;

   private:
    Owner* owner_ = nullptr;
    std::size_t at_ = 0;
  };

 public:
  using value_type = T;
  Chunks() = default;
  Chunks(Chunks&& other) noexcept
      : memory_(std::move(other.memory_)),
        pieces_(std::exchange(other.pieces_, {})),
        size_(std::exchange(other.size_, 0)) {}
  Chunks& operator=(Chunks&& other) noexcept {
    memory_ = std::move(other.memory_);
    pieces_ = std::exchange(other.pieces_, {});
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  Chunks(const Chunks& other) { *this = other; }
  Chunks& operator=(const Chunks& other) {
    if (this == &other) return *this;
    clear();
    for (const T& value : other) push_back(value);
    return *this;
  }

  T& operator[](std::size_t i) { return pieces_[i >> kShift][i & kMask]; }
  const T& operator[](std::size_t i) const { return pieces_[i >> kShift][i & kMask]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& back() { return (*this)[size_ - 1]; }
  auto begin() { return IteratorOf<Chunks, T>(this, 0); }
  auto end() { return IteratorOf<Chunks, T>(this, size_); }
  auto begin() const { return IteratorOf<const Chunks, const T>(this, 0); }
  auto end() const { return IteratorOf<const Chunks, const T>(this, size_); }

  // visit(element) for every one, as long as that answers true: quicker than iterators.
  template <class Visit>
  bool each(const Visit& visit) const {
    for (std::size_t i = 0; i < size_; i += kMask + 1) {
      const T* const piece = pieces_[i >> kShift];
      const T* const end = piece + std::min(size_ - i, kMask + 1);
      for (const T* element = piece; element != end; ++element) {
        if (!visit(*element)) return false;
      }
    }
    return true;
  }

  T& push_back(const T& value) {
    if (size_ == pieces_.size() << kShift) pieces_.push_back(memory_.allocate<T>(kMask + 1));
    T* const place = &pieces_[size_ >> kShift][size_ & kMask];
    ++size_;
    return *new (place) T(value);
  }
  void pop_back() { --size_; }
  // Keeps one piece, so that a reused array stops allocating and a huge one does not stay.
  void clear() {
    size_ = 0;
    if (pieces_.size() <= 1) return;
    pieces_.clear();
    memory_.clear();
  }
  std::size_t bytes() const { return (pieces_.size() << kShift) * sizeof(T); }

 private:
  static constexpr std::size_t shift_for(std::size_t bytes) {
    std::size_t shift = 4;
    while (shift < 9 && bytes << (shift + 1) <= (1u << 14)) ++shift;
    return shift;
  }
  static constexpr std::size_t kShift = shift_for(sizeof(T)), kMask = (std::size_t{1} << kShift) - 1;
  Arena memory_;
  std::vector<T*> pieces_;
  std::size_t size_ = 0;
};

// Rows of words, all of one length, kept in the same way.
class Rows {
 public:
  void restart(std::size_t words) {
    std::size_t shift = 0;
    while (words << (shift + 1) <= kPieceWords) ++shift;
    if (words != words_ || shift != shift_ || pieces_.size() > 1) {
      pieces_.clear();
      memory_.clear();
    }
    words_ = words;
    shift_ = shift;
    size_ = 0;
  }
  const std::uint64_t* operator[](std::size_t i) const {
    return pieces_[i >> shift_] + (i & ((std::size_t{1} << shift_) - 1)) * words_;
  }
  void push_back(const std::uint64_t* row) {
    if (size_ >> shift_ == pieces_.size())
      pieces_.push_back(memory_.allocate<std::uint64_t>(words_ << shift_));
    std::copy_n(row, words_, pieces_[size_ >> shift_] + (size_ & ((std::size_t{1} << shift_) - 1)) * words_);
    ++size_;
  }
  std::size_t bytes() const { return pieces_.size() * (words_ << shift_) * sizeof(std::uint64_t); }

 private:
  static constexpr std::size_t kPieceWords = 1u << 12;
  Arena memory_;
  std::vector<std::uint64_t*> pieces_;
  std::size_t words_ = 1, shift_ = 0, size_ = 0;
};

// A priority queue on top of it: the largest element first, as std::push_heap has it.
template <class T>
class ChunkedHeap {
 public:
  bool empty() const { return items_.empty(); }
  void clear() { items_.clear(); }
  std::size_t bytes() const { return items_.bytes(); }

  void push(T value) {
    items_.push_back(value);
    std::size_t at = items_.size() - 1;
    for (; at > 0 && items_[(at - 1) / 2] < value; at = (at - 1) / 2) items_[at] = items_[(at - 1) / 2];
    items_[at] = value;
  }
  T pop() {
    const T top = items_[0];
    const T last = items_.back();
    items_.pop_back();
    const std::size_t size = items_.size();
    std::size_t at = 0;
    while (2 * at + 1 < size) {
      std::size_t child = 2 * at + 1;
      if (child + 1 < size && items_[child] < items_[child + 1]) ++child;
      if (!(last < items_[child])) break;
      items_[at] = items_[child];
      at = child;
    }
    if (size > 0) items_[at] = last;
    return top;
  }

 private:
  Chunks<T> items_;
};

}  // namespace goalnet::planner
