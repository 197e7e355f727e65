// The planner as a node: it answers while it searches, and a cancel or a newer goal ends the search; in
// lockstep, too, where the search keeps the event loop busy.
#include "components/planner/planner_node.h"

#include <gmock/gmock-matchers.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "components/messages/conversions.h"
#include "components/ros/service.h"
#include "lifecycle_msgs/srv/ChangeState_service.h"
#include "rcl_interfaces/srv/GetParameters_service.h"
#include "rcl_interfaces/srv/SetParameters_service.h"

namespace goalnet::planner {
namespace {

using namespace std::chrono_literals;
using goalnet_msgs::msg::CancelInstruction;
using goalnet_msgs::msg::GoalPredicates;
using testing::HasSubstr;

// The fifteen puzzle: a plan is found soon, but the proof that none is shorter takes minutes.
constexpr const char* kPuzzle = R"((define (domain puzzle)
  (:requirements :strips)
  (:predicates (Tile ?t ?p) (Empty ?p ?q) (Beside ?p ?q))
  (:action slide :parameters (?t ?from ?to)
    :precondition (and (Tile ?t ?from) (Empty ?to ?to) (Beside ?from ?to))
    :effect (and (Tile ?t ?to) (Empty ?from ?from) (not (Tile ?t ?from)) (not (Empty ?to ?to))))))";

std::string cell(int i) { return "Cell_" + std::to_string(i + 1); }
std::string tile(int i) { return "Tile_" + std::to_string(i + 1); }

WorldState puzzle() {
  WorldState world;
  std::vector<Predicate> facts;
  // 80 moves at least: one of the hardest there are.
  constexpr int kTiles[16] = {15, 14, 8, 12, 10, 11, 9, 13, 2, 6, 5, 1, 3, 7, 4, 0};
  for (int i = 0; i < 16; ++i) {
    world.objects.push_back(cell(i));
    if (i < 15) world.objects.push_back(tile(i));
    if (kTiles[i] == 0) {
      facts.push_back({"Empty", cell(i), cell(i)});
    } else {
      facts.push_back({"Tile", tile(kTiles[i] - 1), cell(i)});
    }
    for (int j = 0; j < 16; ++j) {
      if (std::abs(i % 4 - j % 4) + std::abs(i / 4 - j / 4) == 1)
        facts.push_back({"Beside", cell(i), cell(j)});
    }
  }
  std::sort(world.objects.begin(), world.objects.end());
  world.facts = FactSet(std::move(facts));
  return world;
}

class PlannerNodeTest : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    domain_file_ = std::filesystem::temp_directory_path() / ("puzzle_" + std::to_string(getpid()) + ".pddl");
    std::ofstream(domain_file_) << kPuzzle;
    ros::ContextOptions options;
    options.process_only = true;
    context_ = ros::Context::create(options).value();
    ros::NodeOptions planner;
    planner.name = "planner";
    planner.arguments.console = false;
    planner.arguments = ros::parse_arguments({"--ros-args", "--disable-stdout-logs", "-p", "node_limit:=0",
                                              "-p", GetParam() ? "lockstep:=true" : "lockstep:=false", "-p",
                                              "time_limit:=60.0", "-p", "domain:=" + domain_file_.string()})
                            .value();
    node_ = ros::Node::create(*context_, planner_loop_, std::move(planner)).value();
    planner_ = PlannerNode::create(*node_).value();
    ros::NodeOptions tool;
    tool.name = "tool";
    tool_ = ros::Node::create(*context_, loop_, std::move(tool)).value();
    goal_ = tool_->advertise<GoalPredicates>("goal_predicates");
    world_ = tool_->advertise<goalnet_msgs::msg::WorldState>("world_state", ros::Qos::latched());
    cancel_ = tool_->advertise<CancelInstruction>("cancel_instruction");
    plan_ = tool_->subscribe<goalnet_msgs::msg::Plan>("plan", ros::Qos::standard(),
                                                      [this](const auto& plan) { answers_.push_back(plan); });
    goalnet_msgs::msg::WorldState world;
    messages::fill(world, puzzle());
    world_->publish(world);
    thread_ = std::jthread([this](std::stop_token) { planner_loop_.run(); });
  }
  void TearDown() override {
    planner_loop_.stop();
    if (thread_.joinable()) thread_.join();
    planner_.reset();
    std::filesystem::remove(domain_file_);
  }
  void ask(std::uint64_t id) {
    Goal goal;
    for (int i = 0; i < 15; ++i) goal.positive.push_back({"Tile", tile(i), cell(i)});
    GoalPredicates message;
    message.instruction_id(id);
    messages::fill(message, goal);
    goal_->publish(message);
  }
  void cancel(std::uint64_t id) {
    CancelInstruction message;
    message.instruction_id(id);
    cancel_->publish(message);
  }
  // Time until the next answer [s]; negative: none within the limit.
  double next_answer(std::chrono::nanoseconds limit) {
    const std::size_t count = answers_.size();
    const auto start = std::chrono::steady_clock::now();
    if (!loop_.run_for(limit, [&] { return answers_.size() > count; })) return -1.0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::filesystem::path domain_file_;
  ros::EventLoop loop_, planner_loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_, tool_;
  std::unique_ptr<PlannerNode> planner_;
  std::shared_ptr<ros::Publisher<GoalPredicates>> goal_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::WorldState>> world_;
  std::shared_ptr<ros::Publisher<CancelInstruction>> cancel_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::Plan>> plan_;
  std::vector<goalnet_msgs::msg::Plan> answers_;
  std::jthread thread_;
};

TEST_P(PlannerNodeTest, ACancelEndsTheSearchThatRuns) {
  ask(7);
  EXPECT_LT(next_answer(500ms), 0.0) << "it searches";
  cancel(6);
  EXPECT_LT(next_answer(100ms), 0.0) << "another instruction was meant";
  cancel(7);
  const double seconds = next_answer(10s);
  ASSERT_GE(seconds, 0.0);
  EXPECT_LT(seconds, 0.1);
  EXPECT_EQ(answers_.back().instruction_id(), 7u);
  EXPECT_EQ(answers_.back().outcome(), 22) << answers_.back().message();
}

TEST_P(PlannerNodeTest, ANewerGoalEndsTheSearchThatRuns) {
  ask(7);
  EXPECT_LT(next_answer(300ms), 0.0) << "it searches";
  ask(8);
  const double seconds = next_answer(10s);
  ASSERT_GE(seconds, 0.0);
  EXPECT_LT(seconds, 0.1);
  EXPECT_EQ(answers_.back().instruction_id(), 7u);
  EXPECT_EQ(answers_.back().outcome(), 22);
  EXPECT_THAT(answers_.back().message(), HasSubstr("a newer goal"));
  EXPECT_LT(next_answer(300ms), 0.0) << "now it searches for that";
  cancel(8);
  ASSERT_GE(next_answer(10s), 0.0);
  EXPECT_EQ(answers_.back().instruction_id(), 8u);
}

TEST_P(PlannerNodeTest, ACancelAlsoMeansGoalsThatWait) {
  ask(7);
  ask(8);
  cancel(8);
  cancel(7);
  ASSERT_GE(next_answer(10s), 0.0);
  EXPECT_EQ(answers_.front().instruction_id(), 7u);
  ask(9);
  cancel(9);
  ASSERT_TRUE(loop_.run_for(10s, [&] { return answers_.back().instruction_id() == 9u; }));
  for (const auto& answer : answers_) EXPECT_EQ(answer.outcome(), 22) << answer.instruction_id();
}

TEST_P(PlannerNodeTest, InterruptEndsItFromAnyThread) {
  ask(1);
  EXPECT_LT(next_answer(200ms), 0.0);
  planner_->interrupt();
  const double seconds = next_answer(10s);
  EXPECT_GE(seconds, 0.0);
  EXPECT_LT(seconds, 0.1);
}

// A goal that has just come is never taken for one that a newer goal has replaced.
TEST_P(PlannerNodeTest, GoalsOneAfterTheOtherAreAllPlanned) {
  Goal one_move;
  one_move.positive.push_back({"Tile", tile(3), cell(15)});
  for (std::uint64_t id = 1; id <= 200; ++id) {
    GoalPredicates message;
    message.instruction_id(id);
    messages::fill(message, one_move);
    goal_->publish(message);
    ASSERT_GE(next_answer(10s), 0.0) << id;
    ASSERT_EQ(answers_.back().instruction_id(), id);
    ASSERT_EQ(answers_.back().outcome(), 0) << id << ": " << answers_.back().message();
    ASSERT_EQ(answers_.back().actions().size(), 1u);
  }
}

TEST_P(PlannerNodeTest, OnlyTheNewestOfManyGoalsIsSearchedFor) {
  for (std::uint64_t id = 1; id <= 5; ++id) ask(id);
  ASSERT_TRUE(loop_.run_for(10s, [&] { return answers_.size() == 4; }));
  EXPECT_LT(next_answer(200ms), 0.0) << "it searches for the last";
  cancel(5);
  ASSERT_GE(next_answer(10s), 0.0);
  std::vector<std::uint64_t> ids;
  for (const auto& answer : answers_) {
    ids.push_back(answer.instruction_id());
    EXPECT_EQ(answer.outcome(), 22) << answer.instruction_id();
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_THAT(ids, testing::ElementsAre(1, 2, 3, 4, 5)) << "everybody is answered once";
}

INSTANTIATE_TEST_SUITE_P(Search, PlannerNodeTest, testing::Bool(),
                         [](const auto& chosen) { return chosen.param ? "InTheLoop" : "InItsThread"; });

// A search has its own thread: the event loop goes on meanwhile.
class SearchThread : public PlannerNodeTest {};

TEST_P(SearchThread, ParametersAreAnsweredMeanwhile) {
  ros::Client<rcl_interfaces::srv::GetParameters> get(*tool_, "/planner/get_parameters");
  ros::Client<rcl_interfaces::srv::SetParameters> set(*tool_, "/planner/set_parameters");
  ASSERT_TRUE(get.wait_for_service());
  ASSERT_TRUE(set.wait_for_service());
  ask(1);
  EXPECT_LT(next_answer(200ms), 0.0) << "it searches";
  rcl_interfaces::srv::SetParameters::Request change;
  change.parameters().resize(1);
  change.parameters()[0].name("node_limit");
  change.parameters()[0].value().type(2);
  change.parameters()[0].value().integer_value(77);
  const auto changed = set.call_and_run(change, 5s);
  ASSERT_TRUE(changed) << changed.error().message;
  ASSERT_EQ(changed->results().size(), 1u);
  EXPECT_TRUE(changed->results()[0].successful()) << changed->results()[0].reason();
  rcl_interfaces::srv::GetParameters::Request request;
  request.names({"node_limit"});
  const auto response = get.call_and_run(request, 5s);
  ASSERT_TRUE(response) << response.error().message;
  EXPECT_EQ(response->values().at(0).integer_value(), 77);
  EXPECT_TRUE(answers_.empty()) << "and it still searches";
  cancel(1);
  EXPECT_GE(next_answer(10s), 0.0);
}

TEST_P(SearchThread, DeactivateEndsTheSearchAndActivateBeginsAfresh) {
  ros::Client<lifecycle_msgs::srv::ChangeState> change(*tool_, "/planner/change_state");
  ASSERT_TRUE(change.wait_for_service());
  const auto ask_for = [&](const char* label) {
    lifecycle_msgs::srv::ChangeState::Request request;
    request.transition().label(label);
    const auto response = change.call_and_run(request, 5s);
    return response && response->success();
  };
  ask(1);
  EXPECT_LT(next_answer(200ms), 0.0) << "it searches";
  EXPECT_TRUE(ask_for("deactivate"));
  EXPECT_LT(next_answer(300ms), 0.0) << "it fell silent";
  EXPECT_TRUE(ask_for("activate"));
  ASSERT_TRUE(goal_->wait_for_subscribers());
  ask(2);
  EXPECT_LT(next_answer(300ms), 0.0) << "it searches again";
  cancel(2);
  ASSERT_GE(next_answer(10s), 0.0);
  EXPECT_EQ(answers_.back().instruction_id(), 2u);
}

TEST_P(SearchThread, AGoneNodeLeavesNoSearch) {
  ask(1);
  EXPECT_LT(next_answer(200ms), 0.0) << "it searches";
  planner_loop_.stop();
  thread_.join();
  const auto start = std::chrono::steady_clock::now();
  planner_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, 2s);
  EXPECT_TRUE(answers_.empty());
}

INSTANTIATE_TEST_SUITE_P(Search, SearchThread, testing::Values(false));

}  // namespace
}  // namespace goalnet::planner
