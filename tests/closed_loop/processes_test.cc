// Each component in a process of its own, in any start order: the same classes, the same topics, real time.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <memory>
#include <random>

#include "components/messages/conversions.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "tests/support/process.h"

namespace goalnet {
namespace {

using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;
using testing_support::Process;

constexpr int kDomain = 86;
constexpr std::chrono::seconds kLimit{90};

class Processes : public testing::Test {
 protected:
  void start(const std::string& component) {
    std::vector<std::string> words = {testing_support::program("goalnet"), "component", component,
                                      "--ros-args"};
    if (component != "simulator") words.insert(words.end(), {"-p", "use_sim_time:=true"});
    running_[component] = std::make_unique<Process>(
        words, std::map<std::string, std::string>{{"ROS_DOMAIN_ID", std::to_string(kDomain)}});
  }
  void start_all(unsigned order) {
    std::vector<std::string> names = {"simulator", "executor",     "world_model", "goalnet",
                                      "planner",   "manipulation", "coordinator"};
    std::shuffle(names.begin(), names.end(), std::minstd_rand(order));
    for (const std::string& name : names) start(name);
  }
  void SetUp() override {
    ros::ContextOptions options;
    options.domain_id = kDomain;
    context_ = ros::Context::create(options).value();
    ros::NodeOptions node_options;
    node_options.name = "person";
    node_ = ros::Node::create(*context_, loop_, std::move(node_options)).value();
    goal_ = node_->advertise<GoalPredicates>("/goal");
    status_ =
        node_->subscribe<InstructionStatus>("/instruction_status", ros::Qos::latched().keep_last(1000),
                                            [this](const InstructionStatus& status) { last_ = status; });
    world_ = node_->subscribe<goalnet_msgs::msg::WorldState>(
        "/world_state", ros::Qos::latched(),
        [this](const goalnet_msgs::msg::WorldState&) { world_seen_ = true; });
  }
  void TearDown() override {
    for (auto& [name, process] : running_) process->signal(SIGINT);
    for (auto& [name, process] : running_) {
      EXPECT_EQ(process->wait(kLimit).exit_code, 0) << name << ": " << process->err();
    }
  }
  void ask_for_the_tap() {
    ASSERT_TRUE(goal_->wait_for_subscribers(1, kLimit));
    ASSERT_TRUE(loop_.run_for(kLimit, [this] { return world_seen_; }));
    GoalPredicates wanted;
    messages::fill(wanted, Goal{{{"state", "SinkKnob", "TapIsOn"}}, {}, 1.0});
    goal_->publish(wanted);
  }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_;
  std::shared_ptr<ros::Publisher<GoalPredicates>> goal_;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_;
  InstructionStatus last_;
  bool world_seen_ = false;
  std::map<std::string, std::unique_ptr<Process>> running_;
};

TEST_F(Processes, TurnOnTheTapInAnyStartOrder) {
  start_all(1);
  ask_for_the_tap();
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return last_.finished(); })) << last_.stage();
  EXPECT_EQ(last_.outcome(), 0) << last_.message();
}

TEST_F(Processes, ALostPlannerIsNamed) {
  start_all(2);
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return world_seen_; }));
  running_.at("planner")->signal(SIGKILL);
  static_cast<void>(running_.at("planner")->wait(kLimit));
  running_.erase("planner");
  ask_for_the_tap();
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return last_.finished(); }));
  EXPECT_EQ(last_.outcome(), 32);
  EXPECT_THAT(last_.message(), testing::HasSubstr("planner"));
}

TEST_F(Processes, ALostWorldModelStopsTheRobot) {
  start_all(3);
  ask_for_the_tap();
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return last_.stage() == "acting"; }));
  running_.at("world_model")->signal(SIGKILL);
  static_cast<void>(running_.at("world_model")->wait(kLimit));
  running_.erase("world_model");
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return last_.finished(); }));
  EXPECT_EQ(last_.outcome(), 31) << last_.message();
}

}  // namespace
}  // namespace goalnet
