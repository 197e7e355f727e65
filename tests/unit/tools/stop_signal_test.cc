#include "tools/goalnet/stop_signal.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <thread>

namespace goalnet::tools {
namespace {

using namespace std::chrono_literals;

bool soon(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(2ms);
  return condition();
}

TEST(StopSignal, CountsInsteadOfEndingTheProcess) {
  std::atomic<int> calls{0};
  StopSignal stop([&calls] { ++calls; });
  EXPECT_FALSE(stop.requested());
  EXPECT_EQ(stop.age(), 0ns);
  raise(SIGINT);
  EXPECT_TRUE(soon([&] { return stop.requested() && calls == 1; }));
  EXPECT_TRUE(soon([&] { return stop.age() > 0ns; }));
}

TEST(StopSignal, CanBeMadeAgain) {
  for (int i = 0; i < 3; ++i) {
    StopSignal stop;
    EXPECT_FALSE(stop.requested());
    raise(SIGTERM);
    EXPECT_TRUE(soon([&] { return stop.requested(); }));
  }
}

TEST(StopSignalDeathTest, TheSecondOneEndsTheProcessAtOnce) {
  EXPECT_EXIT(
      {
        StopSignal stop([] { std::this_thread::sleep_for(1h); });
        raise(SIGINT);
        raise(SIGINT);
      },
      testing::ExitedWithCode(22), "");
}

}  // namespace
}  // namespace goalnet::tools
