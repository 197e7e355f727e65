// A cancel, or a component deactivated, while the robot moves: it comes to rest, the instruction ends with a
// typed outcome, and once the component is active again everything works.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/ros/managed_component.h"
#include "tests/faults/loop_fixture.h"

namespace goalnet::tools {
namespace {

const Goal kTapOn{{{"state", "SinkKnob", "TapIsOn"}}, {}, 1.0};

class Deactivation : public LoopFixture {
 protected:
  void run_until_it_moves() {
    loop_->pursue(kTapOn);
    while (!last_.finished && speed() < 0.2) loop_->step();
    ASSERT_FALSE(last_.finished) << last_.message;
    go_on(0.3);
    ASSERT_GT(speed(), 0.2);
  }
  void expect_at_rest() { LoopFixture::expect_at_rest(0.01); }
  void expect_it_works_again() {
    last_ = {};
    loop_->pursue(kTapOn);
    run_to_the_end();
    EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  }
};

TEST_F(Deactivation, ACancelSlowsTheRobotDownWithinATenthOfASecond) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  // No longer speeding up: a stop without steps in acceleration first has to take that away.
  double earlier = 0.0;
  while (!last_.finished && speed() > earlier) {
    earlier = speed();
    go_on(0.05);
  }
  ASSERT_FALSE(last_.finished);
  const double before = speed(), asked = loop_->sim_time();
  ASSERT_GT(before, 0.2);
  loop_->cancel("enough");
  go_on(0.1);
  EXPECT_LT(speed(), before);
  EXPECT_TRUE(last_.stage == coordinator::Stage::kStopping || last_.finished);
  double now = speed();
  while (!last_.finished) {
    loop_->step();
    EXPECT_LT(speed(), now + 0.02) << "slower and slower";
    now = speed();
  }
  EXPECT_EQ(last_.outcome, Outcome::kCancelled);
  EXPECT_LT(loop_->sim_time() - asked, 3.0);
  EXPECT_LT(speed(), 0.02) << "it stands when the instruction has ended";
  expect_it_works_again();
}

TEST_F(Deactivation, OfManipulation) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  auto& manipulation = loop_->component("manipulation");
  ASSERT_TRUE(manipulation.deactivate());
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kCancelled) << last_.message;
  EXPECT_THAT(last_.message, testing::HasSubstr("manipulation was deactivated"));
  expect_at_rest();
  ASSERT_TRUE(manipulation.activate());
  expect_it_works_again();
}

TEST_F(Deactivation, OfTheExecutor) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  auto& executor = loop_->component("executor");
  ASSERT_TRUE(executor.deactivate());
  EXPECT_FALSE(executor.cleanup()) << "not before it stands";
  EXPECT_EQ(executor.state(), ros::LifecycleState::kInactive);
  expect_at_rest();
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kComponentLost) << last_.message;
  ASSERT_TRUE(executor.cleanup());
  go_on(0.5);
  EXPECT_LT(speed(), 0.01) << "it holds without any executor";
  ASSERT_TRUE(executor.configure());
  ASSERT_TRUE(executor.activate());
  expect_it_works_again();
}

TEST_F(Deactivation, OfTheCoordinator) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  auto& coordinator = loop_->component("coordinator");
  ASSERT_TRUE(coordinator.deactivate());
  loop_->step();
  EXPECT_TRUE(last_.finished) << "told before it fell silent";
  EXPECT_EQ(last_.outcome, Outcome::kCancelled);
  expect_at_rest();
  ASSERT_TRUE(coordinator.activate());
  expect_it_works_again();
}

TEST_F(Deactivation, OfTheWorldModel) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  auto& world_model = loop_->component("world_model");
  ASSERT_TRUE(world_model.deactivate());
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kWorldStale) << last_.message;
  expect_at_rest();
  ASSERT_TRUE(world_model.activate());
  expect_it_works_again();
}

TEST_F(Deactivation, OfThePlanner) {
  auto& planner = loop_->component("planner");
  ASSERT_TRUE(planner.deactivate());
  loop_->pursue(kTapOn);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kComponentLost) << last_.message;
  ASSERT_TRUE(planner.activate());
  expect_it_works_again();
}

TEST_F(Deactivation, OfTheSimulatorStopsTimeAndTheRunGoesOnAfterwards) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_moves());
  auto& simulator = loop_->component("simulator");
  ASSERT_TRUE(simulator.deactivate());
  loop_->step();  // what was said before
  const double time = loop_->sim_time();
  for (int i = 0; i < 10; ++i) loop_->step();
  EXPECT_EQ(loop_->sim_time(), time);
  ASSERT_TRUE(simulator.activate());
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
}

}  // namespace
}  // namespace goalnet::tools
