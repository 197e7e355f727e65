#include "components/manipulation/tried_ways.h"

#include <gtest/gtest.h>

namespace goalnet::manipulation {
namespace {

Try at(double x, double turn = 0.0, std::size_t arm = 0, const std::string& what = "grasp Mug_1") {
  Pose tool = Pose::Identity();
  tool.translation().x() = x;
  tool.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return {what, arm, tool};
}

// An action that tries one way.
void act(TriedWays& ways, const std::string& action, const Try& one, bool done) {
  ways.begin_action(action);
  ways.add(one);
  ways.end_action(done);
}

TEST(TriedWays, AFailedTryCountsUntilTheInstructionEnds) {
  TriedWays ways;
  ways.begin_action("grasp Mug_1");
  ways.add(at(0.5));
  EXPECT_FALSE(ways.contains(at(0.5))) << "the skill itself knows what it tries now";
  ways.end_action(false);
  EXPECT_TRUE(ways.contains(at(0.5)));
  ways.begin_step();
  EXPECT_TRUE(ways.contains(at(0.5)));
  ways.begin_instruction();
  EXPECT_FALSE(ways.contains(at(0.5)));
}

TEST(TriedWays, MuchTheSameIsTheSame) {
  TriedWays ways;
  act(ways, "grasp Mug_1", at(0.5), false);
  EXPECT_TRUE(ways.contains(at(0.51, 0.1)));
  EXPECT_FALSE(ways.contains(at(0.55)));
  EXPECT_FALSE(ways.contains(at(0.5, 0.6)));
  EXPECT_FALSE(ways.contains(at(0.5, 0.0, 1))) << "the other hand";
  EXPECT_FALSE(ways.contains(at(0.5, 0.0, 0, "keep-on Mug_1 Sink")));
}

TEST(TriedWays, WhatWasDoneCountsOnlyIfItIsAskedForAgainInTheSameStep) {
  TriedWays ways;
  act(ways, "grasp Mug_1", at(0.5), true);
  EXPECT_FALSE(ways.contains(at(0.5)));
  ways.begin_action("grasp Mug_1");
  EXPECT_TRUE(ways.contains(at(0.5)));
  ways.end_action(true);

  TriedWays others;
  act(others, "grasp Mug_1", at(0.5), true);
  others.begin_step();
  others.begin_action("grasp Mug_1");
  EXPECT_FALSE(others.contains(at(0.5)));
}

TEST(TriedWays, TheOldestAreForgotten) {
  TriedWays ways;
  for (int i = 0; i < 1000; ++i) act(ways, "grasp Mug_1", at(0.1 * i), false);
  EXPECT_LE(ways.size(), 64u);
  EXPECT_TRUE(ways.contains(at(99.9)));
  EXPECT_FALSE(ways.contains(at(0.0)));
}

}  // namespace
}  // namespace goalnet::manipulation
