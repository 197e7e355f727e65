// The 1 kHz loop: its schedule with a fake clock, and the real thread on the real clock.
#include "executor/cyclic_thread.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace goalnet::executor {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

// Time that passes only when somebody sleeps or works.
struct FakeTime {
  std::int64_t now = 5'000'000'000;
  std::int64_t wake_up_delay = 0;
  TimeSource source() {
    return {[this] { return now; },
            [this](std::int64_t until) { now = std::max(now, until) + wake_up_delay; }};
  }
};

TEST(CyclicThread, KeepsItsGrid) {
  FakeTime time;
  std::vector<std::int64_t> woken;
  time.wake_up_delay = 20'000;
  CyclicThread thread(
      {.period_ns = kPeriod},
      [&](std::int64_t now) {
        woken.push_back(now);
        time.now += 300'000;  // the work
        return woken.size() < 100;
      },
      time.source());
  thread.run_here();
  ASSERT_EQ(woken.size(), 100u);
  for (std::size_t n = 0; n < woken.size(); ++n)  // no drift
    EXPECT_EQ(woken[n], 5'000'000'000 + static_cast<std::int64_t>(n) * kPeriod + 20'000);
  EXPECT_EQ(thread.statistics().cycles, 100u);
  EXPECT_EQ(thread.statistics().overruns, 0u);
  EXPECT_EQ(thread.statistics().skipped, 0u);
  EXPECT_EQ(thread.statistics().worst_lateness_ns, 20'000);
}

// A cycle of 3.4 periods: the missed slots are left out, the next cycle is on the grid, and there is no
// burst.
TEST(CyclicThread, LeavesOutMissedSlots) {
  FakeTime time;
  std::vector<std::int64_t> woken;
  CyclicThread thread(
      {.period_ns = kPeriod},
      [&](std::int64_t now) {
        woken.push_back((now - 5'000'000'000) / 1000);
        if (woken.size() == 3) time.now += 3'400'000;
        return woken.size() < 6;
      },
      time.source());
  thread.run_here();
  EXPECT_THAT(woken, testing::ElementsAre(0, 1000, 2000, 6000, 7000, 8000));
  EXPECT_EQ(thread.statistics().skipped, 3u);
  EXPECT_EQ(thread.statistics().overruns, 0u);  // nothing woke late
}

TEST(CyclicThread, CountsLateWakeUps) {
  FakeTime time;
  int cycles = 0;
  CyclicThread thread(
      {.period_ns = kPeriod},
      [&](std::int64_t) {
        ++cycles;
        time.wake_up_delay = cycles == 4 ? 600'000 : 0;  // the fifth wakes late
        return cycles < 10;
      },
      time.source());
  thread.run_here();
  EXPECT_EQ(thread.statistics().overruns, 1u);
  EXPECT_EQ(thread.statistics().skipped, 0u);
  EXPECT_EQ(thread.statistics().worst_lateness_ns, 600'000);
}

TEST(CyclicThread, RunsAndStopsOnTheRealClock) {
  std::atomic<int> cycles{0};
  CyclicThread thread({.name = "test_rt", .lock_memory = false}, [&](std::int64_t) {
    ++cycles;
    return true;
  });
  const auto start = std::chrono::steady_clock::now();
  thread.start();
  while (cycles < 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  thread.stop();
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(98));
  const int after = cycles;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(cycles, after);
  EXPECT_EQ(thread.statistics().cycles, static_cast<std::uint64_t>(after));
  thread.start();  // and again
  while (cycles < after + 3) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// What the system does not permit ends in one warning, and the loop runs all the same.
TEST(CyclicThread, FallsBackWithOneWarning) {
  std::atomic<int> cycles{0};
  CyclicThread thread({.name = "test_rt", .priority = 1000, .cpu = 100'000, .lock_memory = false},
                      [&](std::int64_t) { return ++cycles < 10; });
  const auto warning = thread.start();
  ASSERT_TRUE(warning.has_value());
  EXPECT_THAT(*warning, testing::HasSubstr("test_rt runs without real-time guarantees"));
  EXPECT_THAT(*warning, testing::HasSubstr("no CPU 100000"));
  EXPECT_THAT(*warning, testing::HasSubstr("no SCHED_FIFO priority 1000"));
  while (cycles < 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace
}  // namespace goalnet::executor
