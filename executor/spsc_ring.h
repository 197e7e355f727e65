// A queue of fixed size from one thread to another: neither side ever waits, nothing is lost unless push()
// says so.
#pragma once

#include <array>
#include <cstdint>

#include "executor/hardware_memory.h"

namespace goalnet::executor {

// push() from one thread only, pop() from one thread only. Capacity must be a power of two, so that the
// running counts may wrap around.
template <class T, std::uint32_t Capacity, class Memory = HardwareMemory>
class SpscRing {
  static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0);

 public:
  // Producer. Wait-free. False if the ring is full.
  bool push(const T& value) {
    const std::uint32_t pushed = pushed_.load(std::memory_order_relaxed);
    // acquire: the consumer has finished copying out of the slot that is written next.
    if (pushed - popped_.load(std::memory_order_acquire) == Capacity) return false;
    slots_[pushed % Capacity].write(value);
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
  }

  // Consumer. Wait-free. False if the ring is empty.
  bool pop(T& value) {
    const std::uint32_t popped = popped_.load(std::memory_order_relaxed);
    if (popped == pushed_.load(std::memory_order_acquire)) return false;
    value = slots_[popped % Capacity].read();
    popped_.store(popped + 1, std::memory_order_release);
    return true;
  }

 private:
  std::array<typename Memory::template Cell<T>, Capacity> slots_{};
  alignas(kCacheLine) typename Memory::template Atomic<std::uint32_t> pushed_{0};
  alignas(kCacheLine) typename Memory::template Atomic<std::uint32_t> popped_{0};
};

}  // namespace goalnet::executor
