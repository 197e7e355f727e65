// cycle() never allocates, locks, waits, asks the time, writes or makes any system call, whatever happens in
// it.
#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>
#include <mutex>

#include "tests/unit/executor/realtime_guard.h"
#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

using test::first_forbidden_call;
using test::runs_without_system_calls;

// The guards themselves must catch what they are there for.
TEST(RealtimeGuard, CatchesWhatIsForbidden) {
  EXPECT_TRUE(runs_without_system_calls([] {}));
  EXPECT_FALSE(runs_without_system_calls([] { static_cast<void>(getppid()); }));
  if (!test::watches_heap_and_locks()) GTEST_SKIP() << "the sanitizer has its own malloc and locks";
  std::mutex mutex;
  EXPECT_EQ(first_forbidden_call([] {}), "");
  EXPECT_EQ(first_forbidden_call([] { std::vector<int>(100).data()[3] = 1; }), "malloc");
  EXPECT_EQ(first_forbidden_call([&] { std::lock_guard lock(mutex); }), "pthread_mutex_lock");
  EXPECT_EQ(first_forbidden_call([] { static_cast<void>(write(-1, "x", 1)); }), "write");
  timespec now;
  EXPECT_EQ(first_forbidden_call([&] { clock_gettime(CLOCK_MONOTONIC, &now); }), "clock_gettime");
}

// Everything that can happen to the loop, in one scene: `between` cycles the other thread acts, `watched`
// runs cycles.
void live_through_everything(const std::function<void(const std::function<void()>&)>& watched) {
  ExecutorParams params = test::three_joints();
  params.joints[0].tracking_tolerance = 0.5;
  params.joints[0].goal_tolerance = 0.01;
  auto executor = TrajectoryExecutor::create(params).value();
  JointSample measured, command;
  std::int64_t time = 0;
  const auto cycles = [&](int count) {
    watched([&] {
      for (int n = 0; n < count; ++n) {
        measured.position = command.position;
        executor->cycle(time += test::kPeriodNs, measured, command);
      }
    });
  };
  const auto submit = [&](double goal, double tolerance = 0.0) {
    JointTrajectory trajectory{time, {"a", "c"}, {}};
    trajectory.points = {{0, {command.position[0] + tolerance, command.position[2]}, {}},
                         {1'000'000'000, {goal, -goal}, {}}};
    EXPECT_TRUE(executor->submit(trajectory));
  };
  cycles(10);
  submit(0.5);
  cycles(500);
  submit(-0.5, 0.01);  // splice into the running one
  cycles(300);
  submit(0.2, 0.3);  // refused: starts elsewhere
  cycles(100);
  executor->stop();
  cycles(10);
  submit(0.2);  // refused: stopping
  cycles(700);
  submit(0.9);
  cycles(1500);  // to the end
  EXPECT_EQ(executor->status().outcome, Outcome::kDone);
  submit(0.1);
  cycles(300);
  watched([&] {  // a joint that is blocked
    for (int n = 0; n < 1000; ++n) {
      measured.position[0] = command.position[0] + 1.0;
      executor->cycle(time += test::kPeriodNs, measured, command);
    }
  });
  EXPECT_EQ(executor->status().outcome, Outcome::kMotionFailed);
  submit(0.3);
  cycles(300);
  watched([&] {  // measurements that are not numbers
    for (int n = 0; n < 1000; ++n) {
      measured.position[0] = std::nan("");
      executor->cycle(time += test::kPeriodNs, measured, command);
    }
  });
  EXPECT_EQ(executor->status().state, ExecutorState::kFault);
  measured.position = command.position;
  executor->reset();
  cycles(10);
  submit(-0.3);
  cycles(300);
  executor->emergency_stop();
  cycles(500);
  EXPECT_EQ(executor->status().state, ExecutorState::kFault);
  executor->reset();
  cycles(10);
  EXPECT_EQ(executor->status().state, ExecutorState::kIdle);
}

TEST(Realtime, CycleNeverAllocatesOrLocks) {
  if (!test::watches_heap_and_locks()) GTEST_SKIP() << "the sanitizer has its own malloc and locks";
  live_through_everything(
      [](const std::function<void()>& cycles) { EXPECT_EQ(first_forbidden_call(cycles), ""); });
}

TEST(Realtime, CycleNeverMakesASystemCall) {
  live_through_everything([](const std::function<void()>& cycles) {
    EXPECT_TRUE(runs_without_system_calls(cycles));  // in a child process, which the kernel watches
    cycles();                                        // and in this one, to go on
  });
}

}  // namespace
}  // namespace goalnet::executor
