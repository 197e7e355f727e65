// Lock-free exchanges that look right and are wrong, each in one way: the model check must reject every one.
#pragma once

#include <array>
#include <cstdint>

#include "executor/hardware_memory.h"

namespace goalnet::executor::wrong {

// Hands the slot over without release/acquire: the index may arrive before the content.
template <class T, class Memory>
class RelaxedTripleBuffer {
 public:
  void write(const T& value) {
    slots_[back_].write(value);
    back_ = middle_.exchange(back_ | 4, std::memory_order_relaxed) & 3;
  }
  bool read(T& value) {
    if ((middle_.load(std::memory_order_relaxed) & 4) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_relaxed) & 3;
    value = slots_[front_].read();
    return true;
  }

 private:
  std::array<typename Memory::template Cell<T>, 3> slots_{};
  typename Memory::template Atomic<int> middle_{1};
  int back_ = 0, front_ = 2;
};

// Loads and stores the middle in two steps: between them both sides can come to own the same slot.
template <class T, class Memory>
class TwoStepTripleBuffer {
 public:
  void write(const T& value) {
    slots_[back_].write(value);
    const int middle = middle_.load(std::memory_order_acquire);
    middle_.store(back_ | 4, std::memory_order_release);
    back_ = middle & 3;
  }
  bool read(T& value) {
    const int middle = middle_.load(std::memory_order_acquire);
    if ((middle & 4) == 0) return false;
    middle_.store(front_, std::memory_order_release);
    front_ = middle & 3;
    value = slots_[front_].read();
    return true;
  }

 private:
  std::array<typename Memory::template Cell<T>, 3> slots_{};
  typename Memory::template Atomic<int> middle_{1};
  int back_ = 0, front_ = 2;
};

// Two slots are too few: the writer comes round to the slot that is being read.
template <class T, class Memory>
class DoubleBuffer {
 public:
  void write(const T& value) {
    const int next = 1 - newest_.load(std::memory_order_relaxed) % 2;
    slots_[next].write(value);
    newest_.store(next + 2, std::memory_order_release);
  }
  bool read(T& value) {
    const int newest = newest_.load(std::memory_order_acquire);
    if (newest < 2 || newest == seen_) return false;
    seen_ = newest;
    value = slots_[newest % 2].read();
    return true;
  }

 private:
  std::array<typename Memory::template Cell<T>, 2> slots_{};
  typename Memory::template Atomic<int> newest_{0};
  int seen_ = -1;
};

enum class RingSlip { kPublishesFirst, kRelaxedPublish, kRelaxedRelease, kNeverFull, kFreesFirst };

template <class T, std::uint32_t Capacity, RingSlip slip, class Memory>
class Ring {
 public:
  bool push(const T& value) {
    const std::uint32_t pushed = pushed_.load(std::memory_order_relaxed);
    const std::uint32_t popped = popped_.load(std::memory_order_acquire);
    if (slip != RingSlip::kNeverFull && pushed - popped == Capacity) return false;
    if (slip == RingSlip::kPublishesFirst) pushed_.store(pushed + 1, std::memory_order_release);
    slots_[pushed % Capacity].write(value);
    if (slip != RingSlip::kPublishesFirst)
      pushed_.store(pushed + 1, slip == RingSlip::kRelaxedPublish ? std::memory_order_relaxed
                                                                  : std::memory_order_release);
    return true;
  }
  bool pop(T& value) {
    const std::uint32_t popped = popped_.load(std::memory_order_relaxed);
    if (popped == pushed_.load(std::memory_order_acquire)) return false;
    if (slip == RingSlip::kFreesFirst) popped_.store(popped + 1, std::memory_order_release);
    value = slots_[popped % Capacity].read();
    if (slip != RingSlip::kFreesFirst)
      popped_.store(popped + 1, slip == RingSlip::kRelaxedRelease ? std::memory_order_relaxed
                                                                  : std::memory_order_release);
    return true;
  }

 private:
  std::array<typename Memory::template Cell<T>, Capacity> slots_{};
  typename Memory::template Atomic<std::uint32_t> pushed_{0}, popped_{0};
};

}  // namespace goalnet::executor::wrong
