// The coordinator as a node, with the components around it played by this test over DDS.
#include "tests/unit/coordinator/node_fixture.h"

namespace goalnet::coordinator {
namespace {

using testing::HasSubstr;

TEST_F(NodeTest, CarriesOutASentence) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  EXPECT_TRUE(coordinator->connected());
  say("take the mug");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(reports.back().outcome, Outcome::kDone) << reports.back().message;
  EXPECT_THAT(carried_out, testing::ElementsAre("moveto Mug_1", "grasp Mug_1"));
  EXPECT_TRUE(reports.back().facts_added.contains(fact("(Grasping Robot Mug_1)")));
  EXPECT_TRUE(reports.back().facts_removed.contains(fact("(On Mug_1 Counter_1)")));
  EXPECT_EQ(reports.back().actions.size(), 2u);
}

TEST_F(NodeTest, CarriesOutAGivenGoal) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  GoalPredicates wanted;
  messages::fill(wanted, goal({"(Grasping Robot Mug_1)"}));
  given_goal->publish(wanted);
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(reports.back().outcome, Outcome::kDone) << reports.back().message;
  EXPECT_EQ(reports.back().instruction, "");
}

TEST_F(NodeTest, RefusesTextThatIsNoText) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  say(" ");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(reports.back().outcome, Outcome::kInvalidRequest);
}

TEST_F(NodeTest, CancelEndsTheInstruction) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  hands_are_stuck = true;
  say("take the mug");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [this] { return !carried_out.empty(); }));
  hands_are_stuck = false;
  coordinator->cancel("enough");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(reports.back().outcome, Outcome::kCancelled);
  EXPECT_EQ(reports.back().message, "enough");
}

TEST_F(NodeTest, TheActionGivesFeedbackAndAResult) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  Follower follower(*others);
  follower.send("take the mug");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [&] { return follower.state.has_value(); }));
  EXPECT_EQ(*follower.state, ros::GoalState::kSucceeded) << follower.result.message();
  EXPECT_EQ(follower.result.outcome(), 0);
  EXPECT_EQ(follower.result.actions().size(), 2u);
  EXPECT_THAT(follower.stages, testing::IsSupersetOf({"inferring", "planning", "acting"}));
}

TEST_F(NodeTest, TheActionCanBeCancelled) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  hands_are_stuck = true;
  Follower follower(*others);
  const ros::GoalId id = follower.send("take the mug");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [this] { return !carried_out.empty(); }));
  hands_are_stuck = false;
  follower.client.cancel(id);
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [&] { return follower.state.has_value(); }));
  EXPECT_EQ(*follower.state, ros::GoalState::kCanceled);
  EXPECT_EQ(follower.result.outcome(), 22);
}

TEST_F(NodeTest, TheActionTakesOneGoalAtATimeAndNoNonsense) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  Follower nonsense(*others);
  nonsense.send("");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [&] { return nonsense.accepted.has_value(); }));
  EXPECT_FALSE(*nonsense.accepted);
  hands_are_stuck = true;
  Follower first(*others), second(*others);
  first.send("take the mug");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [this] { return !carried_out.empty(); }));
  second.send("take the mug");
  ASSERT_TRUE(loop.run_for(std::chrono::seconds(5), [&] { return second.accepted.has_value(); }));
  EXPECT_FALSE(*second.accepted) << "refused while the first runs";
}

TEST_F(NodeTest, LatecomersSeeHowTheLastInstructionEnded) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  say("take the mug");
  ASSERT_TRUE(wait_for_end());
  bool seen = false;
  const auto late = others->subscribe<InstructionStatus>(
      "/instruction_status", ros::Qos::latched(),
      [&seen](const InstructionStatus& message) { seen = message.finished(); });
  EXPECT_TRUE(loop.run_for(std::chrono::seconds(5), [&seen] { return seen; }));
}

TEST_F(NodeTest, ParametersAreChecked) {
  start({"--ros-args", "-p", "when_busy:=sometimes"});
  const auto refused = CoordinatorNode::create(*node);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(refused.error().message, HasSubstr("refuse or queue"));
}

TEST_F(NodeTest, AMissingDomainIsNamed) {
  start({"--ros-args", "-p", "domain:=/no/such/domain.pddl"});
  const auto refused = CoordinatorNode::create(*node);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("/no/such/domain.pddl"));
}

}  // namespace
}  // namespace goalnet::coordinator
