// The memory that lock-free exchanges work on. Tests put a modelled memory in its place (tests/unit/executor/
// memory_model.h), which tries every interleaving and reports data races.
#pragma once

#include <atomic>

namespace goalnet::executor {

struct HardwareMemory {
  template <class T>
  using Atomic = std::atomic<T>;

  // Ordinary memory, written by one thread and then read by another.
  template <class T>
  class Cell {
   public:
    void write(const T& value) { value_ = value; }
    const T& read() const { return value_; }

   private:
    T value_{};
  };
};

// Keeps what two threads write in different cache lines.
inline constexpr std::size_t kCacheLine = 64;

}  // namespace goalnet::executor
