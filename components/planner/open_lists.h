// What lazy searches still have to look at: several lists of successors not yet made, from which they take in
// turn, those of preferred actions more often after progress (Richter and Helmert, ICAPS 2009).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "components/planner/chunks.h"

namespace goalnet::planner {

struct OpenEntry {          // a successor not yet made
  std::int64_t key;         // least first: an estimate of the parent, or what is made of one
  std::int64_t serial;      // then first in, first out
  std::int32_t parent = 0;  // state
  std::int32_t action = 0;  // ground action; -1: the parent itself is to be looked at
  bool operator<(const OpenEntry& other) const {
    return key != other.key ? key > other.key : serial > other.serial;
  }
};

template <std::size_t kLists>
class OpenLists {
 public:
  void clear() {
    for (List& list : lists_) {
      list.heap.clear();
      list.priority = 0;
    }
    serial_ = 0;
  }
  void push(std::size_t list, std::int64_t key, std::int32_t parent, std::int32_t action) {
    lists_[list].heap.push({key, serial_++, parent, action});
  }
  // That list has the next thousand turns more than the others.
  void favour(std::size_t list) { lists_[list].priority -= 1000; }
  // The least entry of the list whose turn it is; false if all are empty.
  bool pop(OpenEntry* entry) {
    List* next = nullptr;
    for (List& list : lists_) {
      if (!list.heap.empty() && (next == nullptr || list.priority < next->priority)) next = &list;
    }
    if (next == nullptr) return false;
    ++next->priority;
    *entry = next->heap.pop();
    return true;
  }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const List& list : lists_) sum += list.heap.bytes();
    return sum;
  }

 private:
  struct List {
    ChunkedHeap<OpenEntry> heap;
    std::int64_t priority = 0;
  };
  std::array<List, kLists> lists_;
  std::int64_t serial_ = 0;
};

}  // namespace goalnet::planner
