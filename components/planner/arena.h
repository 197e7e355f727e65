// Memory that is given out piece by piece and freed all at once: what lies in it is never destroyed one by
// one, and large blocks are given back by another thread (pages.h), so that freeing a hundred megabytes takes
// no time. That is what lets reading, compiling and searching be cancelled at any time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "components/planner/pages.h"

namespace goalnet::planner {

// Elements of equal type in a row, owned by somebody else.
template <class T>
struct Array : std::span<T> {
  using std::span<T>::span;
  Array() = default;
  Array(std::span<T> other) : std::span<T>(other) {}
  friend bool operator==(const Array& a, const Array& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  friend bool operator<(const Array& a, const Array& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

// Not thread-safe. Moving it moves the memory; what points into it stays valid.
class Arena {
 public:
  Arena() = default;
  Arena(Arena&& other) noexcept { swap(other); }
  Arena& operator=(Arena&& other) noexcept {
    Arena(std::move(other)).swap(*this);
    return *this;
  }
  ~Arena() { release(0); }

  // Throws std::bad_alloc. The memory is not initialised.
  void* allocate(std::size_t bytes, std::size_t alignment) {
    const auto start = (reinterpret_cast<std::uintptr_t>(next_) + alignment - 1) & ~(alignment - 1);
    if (next_ == nullptr || start + bytes > reinterpret_cast<std::uintptr_t>(end_))
      return more(bytes, alignment);
    next_ = reinterpret_cast<std::byte*>(start + bytes);
    return reinterpret_cast<void*>(start);
  }
  template <class T>
  T* allocate(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    return static_cast<T*>(allocate(count * sizeof(T), alignof(T)));
  }
  template <class T>
  Array<T> allocate_array(std::size_t count) {
    T* const first = allocate<T>(count);
    std::uninitialized_value_construct_n(first, count);
    return {first, count};
  }
  template <class T>
  T* make(const T& value) {
    return new (allocate<T>(1)) T(value);
  }
  template <class Range, class T = typename Range::value_type>
  Array<T> copy(const Range& values) {
    T* const first = allocate<T>(values.size());
    std::uninitialized_copy(values.begin(), values.end(), first);
    return {first, values.size()};
  }
  std::string_view copy_text(std::string_view text) {
    char* const first = allocate<char>(text.size());
    if (!text.empty()) std::memcpy(first, text.data(), text.size());
    return {first, text.size()};
  }
  // Forgets all; keeps the first block, so that a reused arena stops allocating and a huge one does not stay.
  void clear() {
    release(1);
    next_ = blocks_.empty() ? nullptr : blocks_[0].memory;
    end_ = blocks_.empty() ? nullptr : next_ + blocks_[0].bytes;
  }

 private:
  struct Block {
    std::byte* memory;
    std::size_t bytes;
    bool mapped;
  };
  void* more(std::size_t bytes, std::size_t alignment);
  void release(std::size_t keep);
  void swap(Arena& other) noexcept {
    std::swap(blocks_, other.blocks_);
    std::swap(next_, other.next_);
    std::swap(end_, other.end_);
  }

  std::vector<Block> blocks_;
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
};

// A list in an arena, which grows without moving what is there. Copies share their elements: once copied, a
// list is not to be extended.
template <class T>
class List {
  struct Cell;

 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;
    Iterator() = default;
    explicit Iterator(const Cell* cell) : cell_(cell) {}
    const T& operator*() const { return cell_->value; }
    const T* operator->() const { return &cell_->value; }
    Iterator& operator++() {
      cell_ = cell_->next;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator old = *this;
      cell_ = cell_->next;
      return old;
    }
    bool operator==(const Iterator&) const = default;

   private:
    const Cell* cell_ = nullptr;
  };

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return Iterator(); }
  const T& front() const { return first_->value; }
  T& push_back(Arena& arena, const T& value) {
    Cell* const cell = arena.make(Cell{value, nullptr});
    (size_ == 0 ? first_ : last_->next) = cell;
    last_ = cell;
    ++size_;
    return cell->value;
  }

 private:
  struct Cell {
    T value;
    Cell* next;
  };
  Cell* first_ = nullptr;
  Cell* last_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace goalnet::planner
