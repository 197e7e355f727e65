// A small model checker for lock-free code between two threads. It runs the code under every interleaving of
// its accesses to shared memory (with at most a given number of preemptions) and finds
// - wrong results, in any of these interleavings;
// - data races, by vector clocks: two accesses to a Cell, one of them a write, that no release/acquire pair
// orders.
//   A missing memory order is found even though this machine would never show it.
// What it does not model: stale values of relaxed loads. The exchanges under test load with relaxed order
// only what their own thread wrote, or what an acquiring exchange follows.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

namespace goalnet::executor::model {

// Runs two threads one access at a time, in an order that explore() chooses.
class Scheduler {
 public:
  using Clock = std::array<std::uint32_t, 2>;

  static Scheduler*& current() {
    static Scheduler* scheduler = nullptr;
    return scheduler;
  }
  static int& thread() {
    thread_local int index = 0;
    return index;
  }

  // Called before each access to shared memory: may hand over to the other thread.
  void point() {
    const int me = thread();
    ++clock[me][me];
    if (done_[1 - me] || preemptions_ >= limit_) return;
    if (choose() == 0) return;
    ++preemptions_;
    turn_[1 - me].release();
    turn_[me].acquire();
  }

  void report(const std::string& what) {
    if (failure.empty()) failure = what;
  }

  // One run along `path` (0 = go on, 1 = switch), extended by zeros as needed.
  void run(std::vector<int>& path, int preemptions, const std::array<std::function<void()>, 2>& bodies) {
    path_ = &path;
    limit_ = preemptions;
    const int first = choose();  // either thread may begin
    std::array<std::thread, 2> threads;
    for (int t = 0; t < 2; ++t) {
      threads[t] = std::thread([this, t, &bodies] {
        thread() = t;
        turn_[t].acquire();
        bodies[t]();
        done_[t] = true;
        turn_[1 - t].release();
      });
    }
    turn_[first].release();
    for (std::thread& one : threads) one.join();
  }

  std::array<Clock, 2> clock{};
  std::string failure;

 private:
  int choose() {
    if (depth_ == path_->size()) path_->push_back(0);
    return (*path_)[depth_++];
  }

  std::vector<int>* path_ = nullptr;
  std::size_t depth_ = 0;
  int preemptions_ = 0, limit_ = 0;
  std::array<std::binary_semaphore, 2> turn_{std::binary_semaphore{0}, std::binary_semaphore{0}};
  std::array<bool, 2> done_{};
};

inline Scheduler::Clock join(Scheduler::Clock a, const Scheduler::Clock& b) {
  for (int t = 0; t < 2; ++t) a[t] = std::max(a[t], b[t]);
  return a;
}

inline bool acquires(std::memory_order order) {
  return order == std::memory_order_acquire || order == std::memory_order_acq_rel ||
         order == std::memory_order_seq_cst;
}
inline bool releases(std::memory_order order) {
  return order == std::memory_order_release || order == std::memory_order_acq_rel ||
         order == std::memory_order_seq_cst;
}

struct Memory {
  template <class T>
  class Atomic {
   public:
    Atomic(T value = T{}) : value_(value) {}
    T load(std::memory_order order) const {
      Scheduler& s = enter();
      if (acquires(order)) mine(s) = join(mine(s), published_);
      return value_;
    }
    void store(T value, std::memory_order order) {
      Scheduler& s = enter();
      published_ = releases(order) ? mine(s) : Scheduler::Clock{};
      value_ = value;
    }
    T exchange(T value, std::memory_order order) {
      Scheduler& s = enter();
      if (acquires(order)) mine(s) = join(mine(s), published_);
      if (releases(order)) published_ = join(published_, mine(s));
      return std::exchange(value_, value);
    }

   private:
    static Scheduler& enter() {
      Scheduler::current()->point();
      return *Scheduler::current();
    }
    static Scheduler::Clock& mine(Scheduler& s) { return s.clock[Scheduler::thread()]; }
    T value_;
    Scheduler::Clock published_{};  // what a thread learns that acquires this value
  };

  template <class T>
  class Cell {
   public:
    void write(const T& value) {
      const int me = access();
      if (written_[1 - me] > seen(me) || read_[1 - me] > seen(me)) race("write");
      written_[me] = Scheduler::current()->clock[me][me];
      value_ = value;
    }
    const T& read() const {
      const int me = access();
      if (written_[1 - me] > seen(me)) race("read");
      read_[me] = Scheduler::current()->clock[me][me];
      return value_;
    }

   private:
    static int access() {
      Scheduler::current()->point();
      return Scheduler::thread();
    }
    static std::uint32_t seen(int me) { return Scheduler::current()->clock[me][1 - me]; }
    static void race(const char* kind) {
      Scheduler::current()->report(std::string("data race on a ") + kind);
    }
    T value_{};
    std::array<std::uint32_t, 2> written_{};
    mutable std::array<std::uint32_t, 2> read_{};
  };
};

struct Exploration {
  std::size_t interleavings = 0;
  std::string failure;  // of the first interleaving that failed
};

// A fresh pair of threads over fresh shared objects, and a check when both have ended ("" = right).
struct Scenario {
  std::function<void()> first, second;
  std::function<std::string()> check;
};

inline Exploration explore(const std::function<Scenario()>& make, int preemptions) {
  Exploration result;
  std::vector<int> path;
  do {
    Scheduler scheduler;
    Scheduler::current() = &scheduler;
    Scenario scenario = make();
    scheduler.run(path, preemptions, {scenario.first, scenario.second});
    // The main thread comes after both.
    Scheduler::thread() = 0;
    scheduler.clock[0] = join(scheduler.clock[0], scheduler.clock[1]);
    const std::string wrong = scenario.check();
    if (!wrong.empty()) scheduler.report(wrong);
    ++result.interleavings;
    result.failure = scheduler.failure;
    if (!result.failure.empty()) return result;
    // Depth first: the last choice that was 0 becomes 1.
    while (!path.empty() && path.back() == 1) path.pop_back();
    if (!path.empty()) path.back() = 1;
  } while (!path.empty());
  return result;
}

}  // namespace goalnet::executor::model
