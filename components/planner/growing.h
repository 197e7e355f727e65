// An array in one piece for lists that may become huge. Growing it never copies for long and freeing it never
// takes long: up to a megabyte it lies on the heap, above that in pages of its own (pages.h), which are moved
// to a larger range of addresses by their tables and not by their contents.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "components/planner/pages.h"

namespace goalnet::planner {

// The names are std::vector's. All that grows throws std::bad_alloc. Not thread-safe.
template <class T>
class Growing {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;
  Growing() = default;
  Growing(Growing&& other) noexcept { swap(other); }
  Growing& operator=(Growing&& other) noexcept {
    Growing(std::move(other)).swap(*this);
    return *this;
  }
  Growing(const Growing& other) { append(std::span(other.first_, other.size_)); }
  Growing& operator=(const Growing& other) {
    if (this == &other) return *this;
    clear();
    append(std::span(other.first_, other.size_));
    return *this;
  }
  ~Growing() { release(); }

  T& operator[](std::size_t i) { return first_[i]; }
  const T& operator[](std::size_t i) const { return first_[i]; }
  T* data() { return first_; }
  const T* data() const { return first_; }
  T* begin() { return first_; }
  T* end() { return first_ + size_; }
  const T* begin() const { return first_; }
  const T* end() const { return first_ + size_; }
  T& back() { return first_[size_ - 1]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  void push_back(const T& value) {
    const T copy = value;  // it may be one of ours
    if (size_ == capacity_) grow(size_ + 1);
    new (first_ + size_++) T(copy);
  }
  // Must not be elements of this array.
  void append(std::span<const T> values) {
    if (values.size() > capacity_ - size_) grow(size_ + values.size());
    std::uninitialized_copy(values.begin(), values.end(), first_ + size_);
    size_ += values.size();
  }
  void truncate(std::size_t size) { size_ = std::min(size, size_); }
  // What is new is undetermined until it is written: touching all of a huge array at once would take long.
  void resize_for_overwrite(std::size_t size) {
    if (size > capacity_) grow(size);
    size_ = size;
  }
  void assign(std::size_t size, const T& value) {
    assign(size, value, [] { return false; });
  }
  // Asks `stop()` now and then; false when told to stop, which leaves what is not yet written undetermined.
  template <class Stop>
  bool assign(std::size_t size, const T& value, Stop stop) {
    constexpr std::size_t kPiece = 1 << 16;
    const T copy = value;  // it may be one of ours
    clear();
    resize_for_overwrite(size);
    for (std::size_t done = 0; done < size; done += kPiece) {
      if (stop()) return false;
      std::uninitialized_fill_n(first_ + done, std::min(kPiece, size - done), copy);
    }
    return true;
  }
  // Keeps what lies on the heap, so that a reused array stops allocating and a huge one does not stay.
  void clear() {
    size_ = 0;
    if (mapped()) release();
  }
  void swap(Growing& other) noexcept {
    std::swap(first_, other.first_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  bool mapped() const { return capacity_ * sizeof(T) > Pages::kHeapMost; }
  void grow(std::size_t least) {
    if (least > std::size_t(-1) / 4 / sizeof(T)) throw std::bad_alloc();
    const std::size_t bytes = std::max({least * sizeof(T), 2 * capacity_ * sizeof(T), 16 * sizeof(T)});
    const std::size_t old = capacity_ * sizeof(T);
    void* place = nullptr;
    if (bytes <= Pages::kHeapMost) {
      place = std::realloc(static_cast<void*>(first_), bytes);
      if (place == nullptr) throw std::bad_alloc();
      capacity_ = bytes / sizeof(T);
    } else {
      const std::size_t whole = Pages::whole(bytes);
      place = mapped() ? Pages::move(first_, Pages::whole(old), whole) : Pages::map(whole);
      if (place == nullptr) throw std::bad_alloc();
      if (!mapped()) {
        if (size_ > 0) std::memcpy(place, static_cast<const void*>(first_), size_ * sizeof(T));
        std::free(static_cast<void*>(first_));
      }
      capacity_ = whole / sizeof(T);
    }
    first_ = static_cast<T*>(place);
  }
  void release() {
    if (mapped()) {
      Pages::unmap(first_, Pages::whole(capacity_ * sizeof(T)));
    } else {
      std::free(static_cast<void*>(first_));
    }
    first_ = nullptr;
    size_ = capacity_ = 0;
  }

  T* first_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace goalnet::planner
