// Every way an instruction can end: each outcome code is produced here.
#include <gmock/gmock-matchers.h>

#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::coordinator {
namespace {

using testing::HasSubstr;

const FactSet kMugOnCounter = facts({"(On Mug_1 Counter_1)"});

struct Outcomes : testing::Test {
  void start(CoordinatorParams params = {}) {
    play.emplace(params);
    play->world_now(kMugOnCounter);
    ASSERT_TRUE(play->instruct("put the mug in the sink"));
  }
  void start_acting(CoordinatorParams params = {}) {
    start(params);
    play->infer(goal({"(On Mug_1 Sink)"}));
    play->plan(kMugToSink);
    ASSERT_EQ(play->port.orders.size(), 1u);
  }
  void expect_end(Outcome outcome, const std::string& part_of_message) {
    ASSERT_TRUE(play->report().finished) << to_string(play->report().stage);
    EXPECT_EQ(play->report().outcome, outcome) << play->report().message;
    EXPECT_THAT(play->report().message, HasSubstr(part_of_message));
    EXPECT_FALSE(play->coordinator.busy());
    EXPECT_EQ(std::count_if(play->port.reports.begin(), play->port.reports.end(),
                            [this](const Report& r) { return r.finished && r.id == play->report().id; }),
              1);
  }
  std::optional<Play> play;
};

TEST_F(Outcomes, Done) {
  start();
  play->infer({});
  expect_end(Outcome::kDone, "nothing needs to be done");
}

TEST_F(Outcomes, NotUnderstood) {
  start();
  play->answer_goal({play->id(), 0, {}, false, Outcome::kNotUnderstood, "\"flurb\" means nothing here"});
  expect_end(Outcome::kNotUnderstood, "flurb");
}

TEST_F(Outcomes, UnknownObject) {
  start();
  play->infer(goal({"(On Mug_7 Sink)"}));
  play->coordinator.on_plan({play->id(), 0, {}, Outcome::kUnknownObject, "no Mug_7; nearest: Mug_1"},
                            play->now);
  expect_end(Outcome::kUnknownObject, "nearest: Mug_1");
}

TEST_F(Outcomes, NoPlan) {
  start();
  play->infer(goal({"(On Sink Mug_1)"}));
  play->coordinator.on_plan({play->id(), 0, {}, Outcome::kNoPlan, "cannot be reached"}, play->now);
  expect_end(Outcome::kNoPlan, "cannot be reached");
}

TEST_F(Outcomes, InvalidRequest) {
  play.emplace();
  const auto refused = play->instruct("  ");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().outcome, Outcome::kInvalidRequest);
  expect_end(Outcome::kInvalidRequest, "empty");
}

TEST_F(Outcomes, BusyLeavesTheRunningInstructionAlone) {
  start_acting();
  const auto refused = play->instruct("open the fridge");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().outcome, Outcome::kBusy);
  const std::size_t reports = play->port.reports.size();
  EXPECT_EQ(play->port.reports[reports - 2].outcome, Outcome::kBusy);
  EXPECT_EQ(play->port.reports[reports - 2].instruction, "open the fridge");
  EXPECT_EQ(play->port.reports[reports - 1].id, 1u)
      << "the latched status shows the running instruction again";
  play->act();
  play->act();
  play->infer({});
  expect_end(Outcome::kDone, "");
}

TEST_F(Outcomes, QueuedInstructionsRunInOrder) {
  CoordinatorParams params;
  params.when_busy = WhenBusy::kQueue;
  params.queue_length = 1;
  start(params);
  ASSERT_TRUE(play->instruct("second"));
  const auto third = play->instruct("third");
  ASSERT_FALSE(third);
  EXPECT_EQ(third.error().outcome, Outcome::kBusy);
  play->infer({});
  play->pass(0.1);
  EXPECT_EQ(play->report().instruction, "second");
  EXPECT_EQ(play->report().id, 2u);
  EXPECT_EQ(play->report().stage, Stage::kInferring);
}

TEST_F(Outcomes, AWaitingInstructionCanBeCancelledAlone) {
  CoordinatorParams params;
  params.when_busy = WhenBusy::kQueue;
  start(params);
  const std::uint64_t second = play->instruct("second").value();
  const std::uint64_t third = play->instruct("third").value();
  EXPECT_TRUE(play->coordinator.cancel_one(second, play->now));
  EXPECT_FALSE(play->coordinator.cancel_one(second, play->now)) << "it is gone";
  EXPECT_EQ(play->id(), 1u) << "the running one goes on";
  play->infer({});
  EXPECT_EQ(play->id(), third);
  EXPECT_TRUE(play->coordinator.cancel_one(third, play->now));
  expect_end(Outcome::kCancelled, "cancelled");
}

TEST_F(Outcomes, TimeLimitOfAnAction) {
  start_acting();
  for (int i = 0; i < 200 && !play->report().finished; ++i) {
    const ActionOrder order = play->port.orders.back();
    play->coordinator.on_action({order.id, order.step, order.index, false, 0.1, Outcome::kDone, ""},
                                play->now);
    play->pass(1.0);
    if (!play->port.cancels.empty()) play->finish_action(Outcome::kCancelled);
  }
  expect_end(Outcome::kTimeLimit, "grasp Mug_1");
}

TEST_F(Outcomes, TimeLimitOfTheInstruction) {
  CoordinatorParams params;
  params.instruction_timeout = 3.0;
  start(params);
  play->pass(3.2);
  expect_end(Outcome::kTimeLimit, "instruction");
}

TEST_F(Outcomes, StepLimit) {
  CoordinatorParams params;
  params.max_steps = 1;
  start_acting(params);
  play->act();
  play->act();
  expect_end(Outcome::kStepLimit, "after 1 steps");
}

TEST_F(Outcomes, GoingInCirclesEnds) {
  play.emplace();
  play->world_now(kMugOnCounter);
  ASSERT_TRUE(play->instruct("juggle the mug"));
  const auto once = [&] {
    play->infer(goal({"(Grasping Robot Mug_1)"}));
    if (play->report().finished) return;
    play->plan({kMugToSink[0]});
    play->act();
    play->infer(goal({"(On Mug_1 Counter_1)"}));
    play->plan({{"keep-on", {"Mug_1", "Counter_1"}}});
    play->act();
  };
  once();
  once();
  expect_end(Outcome::kStepLimit, "no progress: step 2 asks for the same in the same world as step 0");
}

TEST_F(Outcomes, CancelledBeforeAnythingMoves) {
  start();
  play->coordinator.cancel(play->now);
  expect_end(Outcome::kCancelled, "cancelled");
}

TEST_F(Outcomes, CancelledInMotionWaitsForTheRobotToStop) {
  start_acting();
  play->coordinator.cancel(play->now);
  EXPECT_FALSE(play->report().finished);
  EXPECT_EQ(play->report().stage, Stage::kStopping);
  ASSERT_EQ(play->port.cancels.size(), 1u);
  play->coordinator.cancel(play->now);
  EXPECT_EQ(play->port.cancels.size(), 1u) << "cancelling twice changes nothing";
  play->finish_action(Outcome::kCancelled);
  expect_end(Outcome::kCancelled, "cancelled");
}

TEST_F(Outcomes, CancelIsNotHeldUpByASilentManipulation) {
  start_acting();
  play->coordinator.cancel(play->now);
  play->pass(5.2);
  expect_end(Outcome::kCancelled, "did not confirm");
}

TEST_F(Outcomes, MotionFailedAfterRepeatedFailures) {
  start_acting();
  for (int i = 0; i < 3; ++i) {
    play->act(Outcome::kMotionFailed, "no path to the mug");
    if (i < 2) play->plan(kMugToSink);
  }
  expect_end(Outcome::kMotionFailed, "no path to the mug (3 times)");
}

TEST_F(Outcomes, MotionFailedWhenTheWorldNeverAgrees) {
  start();
  play->infer(goal({"(On Mug_1 Sink)"}));
  for (int i = 0; i < 11; ++i) play->plan({kMugToSink[1]});  // never applicable
  expect_end(Outcome::kMotionFailed, "gave up after 10 new plans");
}

TEST_F(Outcomes, WorldStaleFromTheStart) {
  play.emplace();
  ASSERT_TRUE(play->instruct("take the mug"));
  play->silence(9.0);
  EXPECT_FALSE(play->report().finished);
  play->silence(1.5);
  expect_end(Outcome::kWorldStale, "world model");
}

TEST_F(Outcomes, WorldStaleBecauseTheClocksDiffer) {
  play.emplace();
  play->now = 100 * kSecond;
  ASSERT_TRUE(play->coordinator.instruct("put the mug in the sink", 0, play->now));
  for (int i = 0; i < 120; ++i) {
    play->now += kSecond / 10;
    play->coordinator.on_world({{}, kMugOnCounter}, play->now - 7 * kSecond, play->now);
    play->coordinator.tick(play->now);
  }
  expect_end(Outcome::kWorldStale, "7.0 s old; do the clocks");
}

TEST_F(Outcomes, WorldStaleInMotionStopsTheRobot) {
  start_acting();
  play->silence(2.2);
  EXPECT_EQ(play->port.cancels.size(), 1u);
  play->finish_action(Outcome::kCancelled);
  expect_end(Outcome::kWorldStale, "world model");
}

TEST_F(Outcomes, WorldStaleWhenTheSimulatorStartsAgain) {
  start_acting();
  play->now = kSecond / 2;  // its clock begins anew
  play->world_now(kMugOnCounter);
  EXPECT_EQ(play->port.cancels.size(), 1u);
  play->finish_action(Outcome::kCancelled);
  expect_end(Outcome::kWorldStale, "time jumped back");
  ASSERT_TRUE(play->instruct("put the mug in the sink"));
  EXPECT_EQ(play->report().stage, Stage::kInferring) << "the new world counts";
}

TEST_F(Outcomes, AWorldFromBeforeTheInstructionDoesNotCount) {
  play.emplace();
  play->world_now(kMugOnCounter);
  ASSERT_TRUE(play->coordinator.instruct("put the mug in the sink", 0, play->now));
  EXPECT_EQ(play->report().stage, Stage::kWaiting);
  play->silence(10.5);
  expect_end(Outcome::kWorldStale, "world model");
}

TEST_F(Outcomes, ComponentLostGoalnet) {
  start();
  play->pass(10.2);
  expect_end(Outcome::kComponentLost, "goalnet");
}

TEST_F(Outcomes, ComponentLostPlanner) {
  start();
  play->infer(goal({"(On Mug_1 Sink)"}));
  play->pass(20.2);
  expect_end(Outcome::kComponentLost, "planner");
}

// Of a coordinator that was killed while the robot moved, or of one of ours that did not stop in time.
TEST_F(Outcomes, AnActionThatNobodyWatchesIsStopped) {
  play.emplace();
  const ActionReport running{41, 2, 5, false, 0.5, Outcome::kDone, ""};
  play->coordinator.on_action(running, play->now);
  ASSERT_EQ(play->port.cancels.size(), 1u);
  EXPECT_EQ(play->port.cancels[0].id, 41u);
  EXPECT_EQ(play->port.cancels[0].step, 2u);
  EXPECT_EQ(play->port.cancels[0].index, 5u);
  auto other = running;
  other.finished = true;
  play->coordinator.on_action(other, play->now);
  other = running;
  other.id = 0;  // somebody asked manipulation by hand
  play->coordinator.on_action(other, play->now);
  EXPECT_EQ(play->port.cancels.size(), 1u);
}

TEST_F(Outcomes, ComponentLostManipulation) {
  start_acting();
  play->pass(15.2);
  EXPECT_EQ(play->report().stage, Stage::kStopping);
  play->pass(5.2);
  expect_end(Outcome::kComponentLost, "manipulation went silent during \"grasp Mug_1\"");
}

TEST_F(Outcomes, EmergencyStopIsNotRetried) {
  start_acting();
  play->finish_action(Outcome::kEmergencyStop, "emergency stop");
  expect_end(Outcome::kEmergencyStop, "emergency stop");
}

TEST_F(Outcomes, WhatDoesNotFitIsNotTriedAgain) {
  start_acting();
  play->finish_action(Outcome::kNoPlan, "it does not fit");
  expect_end(Outcome::kNoPlan, "it does not fit");
}

TEST_F(Outcomes, InternalErrorIsNotRetried) {
  start_acting();
  play->finish_action(Outcome::kInternal, "bug");
  expect_end(Outcome::kInternal, "bug");
}

}  // namespace
}  // namespace goalnet::coordinator
