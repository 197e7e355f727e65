// The newest value, from one thread to another: neither side ever waits, older values are dropped.
#pragma once

#include <array>
#include <cstdint>

#include "executor/hardware_memory.h"

namespace goalnet::executor {

// Three slots: the writer owns one, the reader owns one, the third lies in the middle. Publishing and taking
// are each one exchange of the middle, so a slot has exactly one owner at any time and a value is never torn.
// write() from one thread only, read() from one thread only. T is copied; make it plain data.
template <class T, class Memory = HardwareMemory>
class TripleBuffer {
 public:
  // Writer. Wait-free.
  void write(const T& value) {
    slots_[back_].write(value);
    // release: the slot's content goes with its index; acquire: the reader is done with the slot we get back.
    back_ = static_cast<std::uint8_t>(
        middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex);
  }

  // Reader. Copies the newest value into `value`; returns false, leaving it alone, if nothing new was
  // written.
  bool read(T& value) {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = static_cast<std::uint8_t>(middle_.exchange(front_, std::memory_order_acq_rel) & kIndex);
    value = slots_[front_].read();
    return true;
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<typename Memory::template Cell<T>, 3> slots_{};
  alignas(kCacheLine) typename Memory::template Atomic<std::uint8_t> middle_{1};
  alignas(kCacheLine) std::uint8_t back_ = 0;   // the writer's
  alignas(kCacheLine) std::uint8_t front_ = 2;  // the reader's
};

}  // namespace goalnet::executor
