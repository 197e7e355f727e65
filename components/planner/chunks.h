// A growing array in pieces of equal size: growing it never copies what is there, so that it never takes long
// and never needs twice the memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace goalnet::planner {

template <class T>
class Chunks {
 public:
  T& operator[](std::size_t i) { return pieces_[i >> kShift][i & kMask]; }
  const T& operator[](std::size_t i) const { return pieces_[i >> kShift][i & kMask]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& back() { return (*this)[size_ - 1]; }

  void push_back(T value) {
    if (size_ == pieces_.size() << kShift) pieces_.push_back(std::make_unique<T[]>(std::size_t{1} << kShift));
    (*this)[size_++] = std::move(value);
  }
  void pop_back() { --size_; }
  // Keeps one piece, so that a reused array stops allocating and a huge one does not stay.
  void clear() {
    size_ = 0;
    if (pieces_.size() > 1) pieces_.resize(1);
  }
  std::size_t bytes() const { return (pieces_.size() << kShift) * sizeof(T); }

 private:
  static constexpr std::size_t kShift = 9, kMask = (std::size_t{1} << kShift) - 1;
  std::vector<std::unique_ptr<T[]>> pieces_;
  std::size_t size_ = 0;
};

// Rows of words, all of one length, kept in the same way.
class Rows {
 public:
  void restart(std::size_t words) {
    std::size_t shift = 0;
    while (words << (shift + 1) <= kPieceWords) ++shift;
    if (words != words_ || shift != shift_) pieces_.clear();
    if (pieces_.size() > 1) pieces_.resize(1);
    words_ = words;
    shift_ = shift;
    size_ = 0;
  }
  const std::uint64_t* operator[](std::size_t i) const {
    return pieces_[i >> shift_].get() + (i & ((std::size_t{1} << shift_) - 1)) * words_;
  }
  void push_back(const std::uint64_t* row) {
    if (size_ >> shift_ == pieces_.size()) {
      pieces_.push_back(std::make_unique_for_overwrite<std::uint64_t[]>(words_ << shift_));
    }
    std::copy_n(row, words_,
                pieces_[size_ >> shift_].get() + (size_ & ((std::size_t{1} << shift_) - 1)) * words_);
    ++size_;
  }
  std::size_t bytes() const { return pieces_.size() * (words_ << shift_) * sizeof(std::uint64_t); }

 private:
  static constexpr std::size_t kPieceWords = 1u << 12;
  std::vector<std::unique_ptr<std::uint64_t[]>> pieces_;
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
