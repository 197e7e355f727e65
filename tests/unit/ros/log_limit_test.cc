// A flood of one kind of line is cut short, and counted.
#include "components/ros/log_limit.h"

#include <gmock/gmock-matchers.h>

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;

TEST(LogLimit, WritesTheFirstFewOfASecondAndCountsTheRest) {
  LogLimit limit;
  const LogLimit::Time start{100s};
  std::vector<std::string> written;
  for (int i = 0; i < 320; ++i) {
    if (const auto more = limit.pass(start + i * 1ms)) written.push_back(*more);
  }
  EXPECT_THAT(written, testing::ElementsAre("", "", ""));
  EXPECT_EQ(limit.left_out(), 317u);
  EXPECT_EQ(limit.pass(start + 1s), " (317 more in the last 1.0 s)");
  EXPECT_EQ(limit.pass(start + 1100ms), "") << "told once";
  EXPECT_EQ(limit.pass(start + 10s), "") << "nothing was left out";
}

TEST(LogLimit, AFloodGoesOnAndIsToldEverySecond) {
  LogLimit limit;
  std::vector<std::string> written;
  for (int i = 0; i < 10'000; ++i) {
    if (const auto more = limit.pass(LogLimit::Time{100s} + i * 1ms); more && !more->empty())
      written.push_back(*more);
  }
  EXPECT_EQ(written.size(), 9u);
  EXPECT_THAT(written, testing::Each(" (997 more in the last 1.0 s)"));
}

}  // namespace
}  // namespace goalnet::ros
