#include "components/manipulation/path_planner.h"

#include <gtest/gtest.h>

namespace goalnet::manipulation {
namespace {

// A square of 2 x 2 with a wall at x = 1 that is open above y = 1.5.
PathQuery walled() {
  PathQuery q;
  q.start = (JointVector(2) << 0.2, 0.5).finished();
  q.goal = (JointVector(2) << 1.8, 0.5).finished();
  q.lower = JointVector::Zero(2);
  q.upper = JointVector::Constant(2, 2.0);
  q.scale = JointVector::Ones(2);
  q.is_free = [](const JointVector& v) { return v[0] < 0.95 || v[0] > 1.05 || v[1] > 1.5; };
  return q;
}

TEST(PathPlanner, FindsTheWayRoundAWall) {
  const auto query = walled();
  const auto path = plan_path(query, {});
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_TRUE(path->front().isApprox(query.start));
  EXPECT_TRUE(path->back().isApprox(query.goal));
  for (std::size_t i = 1; i < path->size(); ++i) {
    for (int k = 0; k <= 100; ++k) {
      EXPECT_TRUE(query.is_free((*path)[i - 1] + ((*path)[i] - (*path)[i - 1]) * (k / 100.0)));
    }
  }
}

TEST(PathPlanner, StraightWhereNothingIsInTheWay) {
  auto query = walled();
  query.is_free = [](const JointVector&) { return true; };
  const auto path = plan_path(query, {});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->size(), 2u);
}

TEST(PathPlanner, SaysWhyThereIsNoPath) {
  auto query = walled();
  query.is_free = [](const JointVector& v) { return v[0] < 0.95 || v[0] > 1.05; };
  PlannerLimits limits;
  limits.iterations = 200;
  auto path = plan_path(query, limits);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().outcome, Outcome::kMotionFailed);
  EXPECT_NE(path.error().message.find("200 iterations"), std::string::npos);
  query.goal[0] = 1.0;
  path = plan_path(query, limits);
  ASSERT_FALSE(path);
  EXPECT_NE(path.error().message.find("end in a collision"), std::string::npos);
  query.start[0] = 1.0;
  EXPECT_NE(plan_path(query, limits).error().message.find("starts in a collision"), std::string::npos);
}

TEST(PathPlanner, StopsWhenTold) {
  auto query = walled();
  query.is_free = [](const JointVector& v) { return v[0] < 0.95 || v[0] > 1.05; };
  int asked = 0;
  query.stopped = [&] { return ++asked > 10; };
  PlannerLimits limits;
  limits.iterations = 1'000'000;
  const auto path = plan_path(query, limits);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().outcome, Outcome::kCancelled);
  EXPECT_LT(asked, 20);
}

}  // namespace
}  // namespace goalnet::manipulation
