#include <gtest/gtest.h>

#include "tools/bench/bench.h"

namespace goalnet::tools {
namespace {

TEST(Summary, UsesNearestRanks) {
  std::vector<double> sample;
  for (int i = 100; i >= 1; --i) sample.push_back(i);
  const auto result = summary(sample, "us");
  EXPECT_EQ(result["count"], 100);
  EXPECT_EQ(result["median_us"], 50.0);
  EXPECT_EQ(result["p90_us"], 90.0);
  EXPECT_EQ(result["p99_us"], 99.0);
  EXPECT_EQ(result["max_us"], 100.0);
  EXPECT_EQ(result["mean_us"], 50.5);
}

TEST(Summary, OfOneAndOfNothing) {
  EXPECT_EQ(summary({7.0}, "ms")["p99_ms"], 7.0);
  const auto nothing = summary({}, "ms");
  EXPECT_EQ(nothing["count"], 0);
  EXPECT_FALSE(nothing.contains("median_ms")) << "nothing was measured";
}

}  // namespace
}  // namespace goalnet::tools
