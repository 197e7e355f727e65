// The loop when all goes well, and when the world differs from the plan.
#include <gmock/gmock-matchers.h>

#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::coordinator {
namespace {

using testing::HasSubstr;

const FactSet kStart = facts({"(On Mug_1 Counter_1)", "(Near Robot Counter_1)"});

TEST(Loop, InfersPlansActsAndObservesUntilNothingIsLeft) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.instruct("put the mug in the sink"));
  EXPECT_EQ(play.report().stage, Stage::kInferring);
  play.infer(goal({"(Grasping Robot Mug_1)"}));
  EXPECT_EQ(play.report().stage, Stage::kPlanning);
  EXPECT_TRUE(play.port.plan_requests.empty()) << "goalnet's answer reaches the planner by itself";
  play.plan({kMugToSink[0]});
  play.act();
  EXPECT_EQ(play.step(), 1u);
  play.infer(goal({"(On Mug_1 Sink)"}));
  play.plan({kMugToSink[1]});
  play.act();
  EXPECT_EQ(play.step(), 2u);
  play.infer({});
  EXPECT_TRUE(play.report().finished);
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
  EXPECT_EQ(play.report().actions, kMugToSink);
  EXPECT_EQ(play.report().facts_added, facts({"(On Mug_1 Sink)"}));
  EXPECT_EQ(play.report().facts_removed, facts({"(On Mug_1 Counter_1)"}));
  EXPECT_FALSE(play.coordinator.busy());
}

TEST(Loop, AGivenGoalSkipsInference) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(On Mug_1 Sink)"})));
  EXPECT_TRUE(play.port.goal_requests.empty());
  EXPECT_EQ(play.port.plan_requests.size(), 1u);
  play.plan(kMugToSink);
  play.act();
  play.act();
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
  EXPECT_TRUE(play.report().finished);
}

TEST(Loop, ADoneActionCountsOnlyWhenTheWorldShowsIt) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(Grasping Robot Mug_1)"})));
  play.plan({kMugToSink[0]});
  play.finish_action(Outcome::kDone);  // the mug slipped: the world stays as it was
  play.pass(5.0);
  EXPECT_EQ(play.port.plan_requests.size(), 1u) << "the world gets time to show it";
  play.pass(2.0);
  EXPECT_EQ(play.port.plan_requests.size(), 2u);
  EXPECT_THAT(play.coordinator.last_difference(), HasSubstr("(Grasping Robot Mug_1)"));
  EXPECT_EQ(play.report().message, play.coordinator.last_difference()) << "people see why";
  play.plan({kMugToSink[0]});
  EXPECT_EQ(play.port.orders.back().index, 1u) << "a repeated action is a new order";
  play.act();
  EXPECT_TRUE(play.report().finished);
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
}

TEST(Loop, AnEffectMayComeLate) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(Grasping Robot Mug_1)"})));
  play.plan({kMugToSink[0]});
  play.finish_action(Outcome::kDone);
  play.pass(3.0);
  play.world = facts({"(Grasping Robot Mug_1)"});
  play.pass(0.1);
  EXPECT_TRUE(play.report().finished);
  EXPECT_EQ(play.port.orders.size(), 1u);
}

TEST(Loop, EffectsAreReadOnlyFromTheWorldAfterTheAction) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(Grasping Robot Mug_1)"})));
  play.plan({kMugToSink[0]});
  const TimeNs before = play.now;
  play.now += kSecond;
  play.finish_action(Outcome::kDone);
  // Observed before the action ended, delivered after it.
  play.coordinator.on_world({{}, facts({"(Grasping Robot Mug_1)"})}, before, play.now);
  EXPECT_FALSE(play.report().finished);
  play.world_now(facts({"(Grasping Robot Mug_1)"}));
  EXPECT_TRUE(play.report().finished);
}

TEST(Loop, AViolatedPreconditionLeadsToANewPlan) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(On Mug_1 Sink)"})));
  play.plan({kMugToSink[1]});  // made for another world: the mug is not held
  EXPECT_TRUE(play.port.orders.empty()) << "nothing moves";
  EXPECT_EQ(play.port.plan_requests.size(), 2u);
  EXPECT_THAT(play.coordinator.last_difference(), HasSubstr("does not hold Mug_1"));
}

TEST(Loop, AFailedActionIsPlannedAgainFromAFreshWorld) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(On Mug_1 Sink)"})));
  play.plan(kMugToSink);
  play.now += kSecond;
  play.finish_action(Outcome::kMotionFailed, "no path");
  EXPECT_EQ(play.port.plan_requests.size(), 1u) << "not before the world is seen again";
  play.pass(0.1);
  EXPECT_EQ(play.port.plan_requests.size(), 2u);
  play.plan(kMugToSink);
  play.act();
  play.act();
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
  EXPECT_EQ(play.report().actions, kMugToSink) << "only what was carried out";
}

TEST(Loop, MovingMayLeaveTheRobotNearOtherThings) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(Near Robot Mug_1)", "(Near Robot Sink)"})));
  play.plan({{"moveto", {"Mug_1"}}, {"moveto", {"Sink"}}});
  play.finish_action(Outcome::kDone);
  play.world = facts({"(Near Robot Counter_1)", "(Near Robot Mug_1)"});
  play.pass(0.1);
  play.act();
  EXPECT_TRUE(play.report().finished) << "both places were visited, one after the other";
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
}

TEST(Loop, APlanThatOvertakesItsGoalIsKept) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.instruct("take the mug"));
  play.plan({kMugToSink[0]});
  EXPECT_TRUE(play.port.orders.empty());
  play.infer(goal({"(Grasping Robot Mug_1)"}));
  EXPECT_EQ(play.port.orders.size(), 1u);
}

TEST(Loop, AnswersToOtherInstructionsAreIgnored) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.instruct("take the mug"));
  play.answer_goal({play.id() + 1, 0, goal({"(Grasping Robot Mug_1)"}), false, Outcome::kDone, ""});
  play.answer_goal({play.id(), 1, goal({"(Grasping Robot Mug_1)"}), false, Outcome::kDone, ""});
  EXPECT_EQ(play.report().stage, Stage::kInferring);
  play.infer(goal({"(Grasping Robot Mug_1)"}));
  play.coordinator.on_plan({play.id(), 7, {kMugToSink[0]}, Outcome::kDone, ""}, play.now);
  EXPECT_EQ(play.report().stage, Stage::kPlanning);
}

TEST(Loop, RequestsNobodyReactedToAreSentAgain) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.instruct("take the mug"));
  play.pass(2.5);
  EXPECT_EQ(play.port.goal_requests.size(), 3u);
  play.infer(goal({"(Grasping Robot Mug_1)"}));
  play.pass(1.5);
  EXPECT_EQ(play.port.plan_requests.size(), 1u);
  play.plan({kMugToSink[0]});
  play.pass(1.5);
  EXPECT_EQ(play.port.orders.size(), 2u);
  const ActionOrder order = play.port.orders.back();
  EXPECT_EQ(order.index, play.port.orders.front().index) << "the same order again";
  play.coordinator.on_action({order.id, order.step, order.index, false, 0.1, Outcome::kDone, ""}, play.now);
  play.pass(3.0);
  EXPECT_EQ(play.port.orders.size(), 2u) << "manipulation is at it";
}

TEST(Loop, ProgressGrowsWithTheActions) {
  Play play;
  play.world_now(kStart);
  ASSERT_TRUE(play.pursue(goal({"(On Mug_1 Sink)"})));
  play.plan(kMugToSink);
  const ActionOrder order = play.port.orders.back();
  play.coordinator.on_action({order.id, order.step, order.index, false, 0.5, Outcome::kDone, ""}, play.now);
  EXPECT_DOUBLE_EQ(play.report().progress, 0.25);
  play.act();
  EXPECT_DOUBLE_EQ(play.report().progress, 0.5);
}

TEST(Loop, AskingForWhatHoldsAlreadyEndsAfterOneRepetition) {
  Play play;
  play.world_now(facts({"(On Mug_1 Sink)"}));
  ASSERT_TRUE(play.instruct("put the mug in the sink"));
  play.infer(goal({"(On Mug_1 Sink)"}));
  play.plan({});
  play.infer(goal({"(On Mug_1 Sink)"}));
  EXPECT_TRUE(play.report().finished);
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
}

}  // namespace
}  // namespace goalnet::coordinator
