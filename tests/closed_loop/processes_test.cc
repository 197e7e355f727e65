// Each component in a process of its own, in any start order, in namespaces, lost and started again: the same
// classes, the same topics, real time.
#include <gmock/gmock-matchers.h>
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "components/messages/conversions.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/CancelInstruction.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"
#include "tests/support/process.h"

namespace goalnet {
namespace {

using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;
using testing::HasSubstr;
using testing_support::Process;

constexpr int kDomain = 86;
constexpr std::chrono::seconds kLimit{90};
constexpr std::chrono::seconds kEnd{600};  // counted from a process's start
const std::map<std::string, std::string> kEnvironment{{"ROS_DOMAIN_ID", std::to_string(kDomain)}};

// A person beside one robot: asks, and sees what it does.
struct Person {
  Person(ros::Node& node, ros::EventLoop& the_loop, const std::string& space) : loop(the_loop) {
    goal = node.advertise<GoalPredicates>(space + "/goal");
    status =
        node.subscribe<InstructionStatus>(space + "/instruction_status", ros::Qos::latched().keep_last(1000),
                                          [this](const InstructionStatus& message) { last = message; });
    world = node.subscribe<goalnet_msgs::msg::WorldState>(
        space + "/world_state", ros::Qos::latched(), [this](const goalnet_msgs::msg::WorldState& message) {
          facts = messages::from_message(message)->facts;
        });
    joints = node.subscribe<sensor_msgs::msg::JointState>(
        space + "/joint_states", ros::Qos::standard(), [this](const sensor_msgs::msg::JointState& message) {
          speed = 0.0;
          for (const double velocity : message.velocity()) speed = std::max(speed, std::abs(velocity));
        });
  }
  void wait_until_the_world_is_known() {
    ASSERT_TRUE(goal->wait_for_subscribers(1, kLimit));
    ASSERT_TRUE(loop.run_for(kLimit, [this] { return facts.has_value(); }));
  }
  void ask_for(const Predicate& wanted) {
    ASSERT_NO_FATAL_FAILURE(wait_until_the_world_is_known());
    GoalPredicates message;
    messages::fill(message, Goal{{wanted}, {}, 1.0});
    last = {};
    goal->publish(message);
  }
  bool finished() const { return last.finished(); }
  // The outcome, once it has come.
  int outcome() {
    EXPECT_TRUE(loop.run_for(kLimit, [this] { return finished(); })) << last.stage();
    return finished() ? last.outcome() : -1;
  }
  bool moving() const { return speed > 0.1; }
  bool comes_to_rest() {
    return loop.run_for(std::chrono::seconds(20), [this] { return speed < 1e-3; });
  }

  ros::EventLoop& loop;
  std::shared_ptr<ros::Publisher<GoalPredicates>> goal;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joints;
  InstructionStatus last;
  std::optional<FactSet> facts;
  double speed = 0.0;  // of the fastest joint [rad/s or m/s]
};

const Predicate kTapOn{"state", "SinkKnob", "TapIsOn"};

class Processes : public testing::Test {
 protected:
  void start(const std::string& component, const std::string& space = "") {
    std::vector<std::string> words = {testing_support::program("goalnet"), "component", component,
                                      "--ros-args"};
    if (component != "simulator") words.insert(words.end(), {"-p", "use_sim_time:=true"});
    // What is lost is to be noticed soon.
    if (component == "coordinator")
      words.insert(words.end(), {"-p", "action_silence_timeout:=4.0", "-p", "cancel_timeout:=1.0", "-p",
                                 "planning_timeout:=5.0"});
    // Long enough to lose components in one and the same motion.
    if (component == "coordinator" && slow_)
      words.insert(words.end(), {"-p", "action_silence_timeout:=60.0", "-p", "cancel_timeout:=20.0"});
    if (component == "manipulation" && slow_) words.insert(words.end(), {"-p", "speed:=0.08"});
    // Sixteen processes on two cores: a simulator that gets no time for a moment is no fault.
    if (component == "executor") words.insert(words.end(), {"-p", "measurement_timeout:=2.0"});
    if (!space.empty()) words.insert(words.end(), {"-r", "__ns:=" + space});
    running_[space + "/" + component] = std::make_unique<Process>(words, kEnvironment);
  }
  void start_all(unsigned order, const std::string& space = "") {
    std::vector<std::string> names = {"simulator", "executor",     "world_model", "goalnet",
                                      "planner",   "manipulation", "coordinator"};
    std::shuffle(names.begin(), names.end(), std::minstd_rand(order));
    for (const std::string& name : names) start(name, space);
  }
  void lose(const std::string& component) {
    running_.at("/" + component)->signal(SIGKILL);
    static_cast<void>(running_.at("/" + component)->wait(kEnd));
    running_.erase("/" + component);
  }
  // What is published before all have found the new one never reaches it.
  void replace(const std::string& component) {
    start(component);
    ASSERT_TRUE(running_.at("/" + component)->wait_for_text("is up", kLimit));
    loop_.run_for(std::chrono::seconds(1));
  }
  static auto newcomer() {
    ros::ContextOptions options;
    options.domain_id = kDomain;
    return ros::Context::create(options).value();
  }
  std::unique_ptr<ros::Node> person_node(ros::Context& context) {
    ros::NodeOptions options;
    options.name = "person";
    return ros::Node::create(context, loop_, std::move(options)).value();
  }
  void SetUp() override {
    context_ = newcomer();
    node_ = person_node(*context_);
  }
  void TearDown() override {
    for (auto& [name, process] : running_) process->signal(SIGINT);
    for (auto& [name, process] : running_) {
      EXPECT_EQ(process->wait(kEnd).exit_code, 0) << name << ": " << process->err();
    }
  }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_;
  std::map<std::string, std::unique_ptr<Process>> running_;
  bool slow_ = false;
};

TEST_F(Processes, TwoRobotsOnOneNetworkInAnyStartOrder) {
  Person first(*node_, loop_, "/robot1"), second(*node_, loop_, "/robot2");
  start_all(1, "/robot1");
  ASSERT_NO_FATAL_FAILURE(first.wait_until_the_world_is_known());
  // The second by the launcher and the file that is shipped; its time is another one.
  running_["/robot2"] = std::make_unique<Process>(
      std::vector<std::string>{testing_support::program("goalnet"), "launch", "robot",
                               "measurement_timeout:=2.0", "namespace:=/robot2"},
      kEnvironment);
  ASSERT_NO_FATAL_FAILURE(second.wait_until_the_world_is_known());
  ASSERT_NO_FATAL_FAILURE(first.ask_for(kTapOn));
  EXPECT_EQ(first.outcome(), 0) << first.last.message();
  // The end of the instruction may arrive here before the world that it was judged by.
  EXPECT_TRUE(loop_.run_for(kLimit, [&] { return first.facts->contains(kTapOn); }));
  EXPECT_FALSE(second.facts->contains(kTapOn)) << "nobody asked the second robot";
  ASSERT_NO_FATAL_FAILURE(second.ask_for(kTapOn));
  EXPECT_EQ(second.outcome(), 0) << second.last.message();
}

TEST_F(Processes, ALostPlannerIsNamedAndReplaced) {
  Person person(*node_, loop_, "");
  start_all(2);
  ASSERT_NO_FATAL_FAILURE(person.wait_until_the_world_is_known());
  lose("planner");
  ASSERT_NO_FATAL_FAILURE(person.ask_for(kTapOn));
  EXPECT_EQ(person.outcome(), 32);
  EXPECT_THAT(person.last.message(), HasSubstr("planner"));
  ASSERT_NO_FATAL_FAILURE(replace("planner"));
  lose("coordinator");  // idle, too
  ASSERT_NO_FATAL_FAILURE(replace("coordinator"));
  // Who was here before counts the dead coordinator as a listener until its lease ends; a newcomer finds only
  // the living one.
  const auto context = newcomer();
  const auto node = person_node(*context);
  Person later(*node, loop_, "");
  ASSERT_NO_FATAL_FAILURE(later.ask_for(kTapOn));
  EXPECT_EQ(later.outcome(), 0) << later.last.message();
}

TEST_F(Processes, WhatIsKilledInMotionEndsInAFaultAndTheRobotRests) {
  Person person(*node_, loop_, "");
  start_all(3);
  const std::pair<const char*, int> kVictims[] = {
      {"manipulation", 32}, {"executor", 32}, {"world_model", 31}};
  for (const auto& [victim, outcome] : kVictims) {
    ASSERT_NO_FATAL_FAILURE(person.ask_for(kTapOn));
    ASSERT_TRUE(loop_.run_for(kLimit, [&] { return person.moving() || person.finished(); })) << victim;
    ASSERT_FALSE(person.finished()) << victim << ": " << person.last.message();
    lose(victim);
    EXPECT_EQ(person.outcome(), outcome) << victim << ": " << person.last.message();
    EXPECT_TRUE(person.comes_to_rest()) << victim;
    ASSERT_NO_FATAL_FAILURE(replace(victim));
  }
  ASSERT_NO_FATAL_FAILURE(person.ask_for(kTapOn));
  EXPECT_EQ(person.outcome(), 0) << person.last.message();
}

// A person who was told of an end, or of nothing at all, may go near the robot.
TEST_F(Processes, WhatMovesForNobodyIsStoppedByWhoIsStartedAgain) {
  constexpr double kMoves = 0.02;
  slow_ = true;
  Person person(*node_, loop_, "");
  int stopped = 0;
  const auto actions = node_->subscribe<goalnet_msgs::msg::ActionStatus>(
      "/action_status", ros::Qos::standard(), [&](const goalnet_msgs::msg::ActionStatus& status) {
        const bool finished = status.state() == goalnet_msgs::msg::ActionStatus_Constants::FINISHED;
        if (finished && status.outcome() == 22) ++stopped;
      });
  const auto cancel = node_->advertise<goalnet_msgs::msg::CancelInstruction>("/cancel_instruction");
  start_all(4);
  ASSERT_NO_FATAL_FAILURE(person.ask_for(kTapOn));
  ASSERT_TRUE(loop_.run_for(kLimit, [&] { return person.speed > kMoves || person.finished(); }));
  lose("coordinator");
  ASSERT_GT(person.speed, kMoves);
  ASSERT_NO_FATAL_FAILURE(replace("coordinator"));
  EXPECT_TRUE(loop_.run_for(std::chrono::seconds(5), [&] { return stopped == 1; }));
  EXPECT_LT(person.speed, kMoves);

  ASSERT_NO_FATAL_FAILURE(person.ask_for(kTapOn));
  ASSERT_TRUE(loop_.run_for(kLimit, [&] { return person.speed > kMoves || person.finished(); }));
  lose("manipulation");
  ASSERT_NO_FATAL_FAILURE(replace("manipulation"));
  ASSERT_GT(person.speed, kMoves) << "the executor follows what it was sent";
  cancel->publish({});  // whatever runs
  EXPECT_EQ(person.outcome(), 22) << person.last.message();
  EXPECT_LT(person.speed, kMoves) << "it stands when that is told";
}

}  // namespace
}  // namespace goalnet
