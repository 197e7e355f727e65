// Sensors that fall silent or come late: what is not seen is not believed, and the robot does not go on
// blindly.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "sim/simulator_node.h"
#include "tests/faults/loop_fixture.h"

namespace goalnet::tools {
namespace {

class SensorFault : public LoopFixture {
 protected:
  sim::SensorFaults& faults() {
    return dynamic_cast<sim::SimulatorNode&>(loop_->component("simulator")).sensor_faults();
  }
  void run_until_it_carries_the_mug() {
    loop_->pursue(kMugInSink);
    ASSERT_TRUE(run_until_action("moveto Sink"));
    go_on(0.5);
    ASSERT_FALSE(last_.finished) << last_.message;
  }
  void expect_it_works_again() {
    last_ = {};
    loop_->pursue(kMugInSink);
    run_to_the_end();
    EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
    EXPECT_TRUE(holds("On Mug_1 Sink"));
  }
};

TEST_F(SensorFault, NoObjectIsSeenAnyMore) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_carries_the_mug());
  const double start = loop_->sim_time();
  faults().poses_lost = true;
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kWorldStale) << last_.message;
  EXPECT_LT(loop_->sim_time() - start, 6.0) << "noticed soon";
  expect_at_rest();
  EXPECT_FALSE(loop_->world().held().empty()) << "the mug is still in the hand";
  faults().poses_lost = false;
  expect_it_works_again();
}

TEST_F(SensorFault, NoObjectIsSeenForAMoment) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_carries_the_mug());
  faults().poses_lost = true;
  go_on(0.3);
  faults().poses_lost = false;
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
}

// The robot is stopped by the executor itself, at once, and stays so until somebody has looked.
TEST_F(SensorFault, TheJointsAreNotMeasuredAnyMore) {
  ASSERT_NO_FATAL_FAILURE(run_until_it_carries_the_mug());
  const double start = loop_->sim_time();
  faults().joints_lost = true;
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kWorldStale) << last_.message;
  EXPECT_LT(loop_->sim_time() - start, 6.0);
  expect_at_rest();
  EXPECT_FALSE(loop_->world().held().empty());
  faults().joints_lost = false;
  last_ = {};
  loop_->pursue(kMugInSink);
  run_to_the_end();
  EXPECT_NE(last_.outcome, Outcome::kDone);
  EXPECT_THAT(last_.message, testing::HasSubstr("reset")) << "it says what has to be done first";
  expect_at_rest();
}

// A slow camera: everything is done all the same.
TEST_F(SensorFault, ObjectsAreSeenLate) {
  faults().poses_late = 0.3;
  loop_->pursue(kMugInSink);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
}

TEST_F(SensorFault, ObjectsAreSeenMuchTooLate) {
  faults().poses_late = 3.0;
  go_on(3.5);
  loop_->pursue(kMugInSink);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kWorldStale) << last_.message;
  expect_at_rest();
}

}  // namespace
}  // namespace goalnet::tools
