// Large ranges of memory straight from the system, such that who takes and frees them can be stopped at any
// time: they consist of small pages, which the system hands out one by one when they are first written (a
// huge page may take it 5 ms and more), and they are given back by a thread of their own, because that takes
// the system about 0.1 ms per MB.
#pragma once

#include <cstddef>

namespace goalnet::planner {

// All sizes in bytes and multiples of kUnit, at which all ranges begin: so the system can move them by their
// tables. Null where it has no more. Thread-safe.
struct Pages {
  static constexpr std::size_t kUnit = 2u << 20;
  static constexpr std::size_t kHeapMost = kUnit / 2;  // what is no larger is better off on the heap
  static std::size_t whole(std::size_t bytes) { return (bytes + kUnit - 1) / kUnit * kUnit; }
  // Zeros.
  static void* map(std::size_t bytes);
  // To a range of `bytes`, more than before; the contents go along without being copied.
  static void* move(void* pages, std::size_t before, std::size_t bytes);
  // Returns at once. At most some 256 MB wait to be given back while new ranges are asked for.
  static void unmap(void* pages, std::size_t bytes);
};

}  // namespace goalnet::planner
