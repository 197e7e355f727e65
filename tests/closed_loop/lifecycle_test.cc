// Every component as a managed node, over the services that ros2 lifecycle and ros2 param use.
#include <gmock/gmock-matchers.h>
#include <malloc.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "components/ros/service.h"
#include "goalnet_msgs/msg/ActionRequest.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/CancelInstruction.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/Plan.h"
#include "goalnet_msgs/msg/StepRequest.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "lifecycle_msgs/srv/ChangeState_service.h"
#include "lifecycle_msgs/srv/GetState_service.h"
#include "rcl_interfaces/msg/Log.h"
#include "rcl_interfaces/srv/DescribeParameters_service.h"
#include "rcl_interfaces/srv/GetParameters_service.h"
#include "rcl_interfaces/srv/ListParameters_service.h"
#include "rcl_interfaces/srv/SetParameters_service.h"
#include "sensor_msgs/msg/JointState.h"
#include "std_msgs/msg/String.h"
#include "tools/goalnet/component_registry.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

std::string name_of(const testing::TestParamInfo<tools::ComponentKind>& info) {
  return std::string(info.param.name);
}

class Lifecycle : public testing::TestWithParam<tools::ComponentKind> {
 protected:
  void SetUp() override {
    ros::ContextOptions options;
    options.process_only = true;
    context_ = ros::Context::create(options).value();
    tool_ = node("tool", {});
  }
  void TearDown() override {
    component_.reset();
    node_.reset();
  }

  std::unique_ptr<ros::Node> node(const std::string& name, const std::vector<std::string>& parameters) {
    std::vector<std::string> words = {"--ros-args"};
    for (const auto& one : parameters) words.insert(words.end(), {"-p", one});
    ros::NodeOptions options;
    options.name = name;
    options.arguments = ros::parse_arguments(words).value();
    options.arguments.console = false;
    return ros::Node::create(*context_, loop_, std::move(options)).value();
  }
  void start(std::vector<std::string> parameters = {}) {
    parameters.push_back("autostart:=false");
    // Ordinary scheduling and nobody's memory locked: a test is no robot.
    if (name() == "executor") parameters.insert(parameters.end(), {"priority:=0", "lock_memory:=false"});
    if (name() == "simulator") parameters.push_back("lockstep:=true");
    node_ = node(name(), parameters);
    auto made = GetParam().create(*node_);
    ASSERT_TRUE(made) << made.error().message;
    component_ = std::move(*made);
    const std::string base = "/" + name();
    change_ = std::make_unique<ros::Client<lifecycle_msgs::srv::ChangeState>>(*tool_, base + "/change_state");
    state_ = std::make_unique<ros::Client<lifecycle_msgs::srv::GetState>>(*tool_, base + "/get_state");
    set_ =
        std::make_unique<ros::Client<rcl_interfaces::srv::SetParameters>>(*tool_, base + "/set_parameters");
  }
  std::string name() const { return std::string(GetParam().name); }

  bool change(int id) {
    lifecycle_msgs::srv::ChangeState::Request request;
    request.transition().id(static_cast<std::uint8_t>(id));
    return change_->call_and_run(request, 10s)->success();
  }
  std::string state() { return state_->call_and_run({}, 10s)->current_state().label(); }
  std::string set(const std::string& parameter, const rcl_interfaces::msg::ParameterValue& value) {
    rcl_interfaces::srv::SetParameters::Request request;
    rcl_interfaces::msg::Parameter one;
    one.name(parameter);
    one.value(value);
    request.parameters({one});
    const auto result = set_->call_and_run(request, 10s)->results().at(0);
    return result.successful() ? "" : result.reason().empty() ? "no reason" : result.reason();
  }
  static rcl_interfaces::msg::ParameterValue text(const std::string& value) {
    rcl_interfaces::msg::ParameterValue message;
    message.type(4);
    message.string_value(value);
    return message;
  }
  // The parameter of each component that names a file.
  std::string file_parameter() const {
    return name() == "goalnet"                              ? "model"
           : name() == "planner" || name() == "coordinator" ? "domain"
                                                            : "robot";
  }
  void run_a_moment() { loop_.run_for(30ms); }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> tool_, node_;
  std::unique_ptr<ros::ManagedComponent> component_;
  std::unique_ptr<ros::Client<lifecycle_msgs::srv::ChangeState>> change_;
  std::unique_ptr<ros::Client<lifecycle_msgs::srv::GetState>> state_;
  std::unique_ptr<ros::Client<rcl_interfaces::srv::SetParameters>> set_;
};

constexpr int kConfigure = 1, kCleanup = 2, kActivate = 3, kDeactivate = 4;

TEST_P(Lifecycle, EveryTransitionTwiceAndNoneThatIsNotAllowed) {
  start();
  EXPECT_EQ(state(), "unconfigured");
  for (int round = 0; round < 2; ++round) {
    for (const int wrong : {kActivate, kDeactivate, kCleanup, 6, 7, 10, 99})
      EXPECT_FALSE(change(wrong)) << wrong;
    ASSERT_TRUE(change(kConfigure));
    EXPECT_EQ(state(), "inactive");
    for (const int wrong : {kConfigure, kDeactivate, 5, 7}) EXPECT_FALSE(change(wrong)) << wrong;
    for (int again = 0; again < 2; ++again) {
      ASSERT_TRUE(change(kActivate));
      EXPECT_EQ(state(), "active");
      for (const int wrong : {kConfigure, kActivate, kCleanup, 5, 6}) EXPECT_FALSE(change(wrong)) << wrong;
      run_a_moment();
      ASSERT_TRUE(change(kDeactivate));
      EXPECT_EQ(state(), "inactive");
    }
    ASSERT_TRUE(change(kCleanup));
    EXPECT_EQ(state(), "unconfigured");
  }
  ASSERT_TRUE(change(kConfigure));
  ASSERT_TRUE(change(kActivate));
  ASSERT_TRUE(change(7)) << "shutdown from active";
  EXPECT_EQ(state(), "finalized");
  for (int id = 0; id < 10; ++id) EXPECT_FALSE(change(id)) << id;
}

TEST_P(Lifecycle, ABadFileFailsConfigureUntilItIsSetRight) {
  start({file_parameter() + ":=/no/such/file"});
  std::vector<std::string> log;
  const auto rosout = tool_->subscribe<rcl_interfaces::msg::Log>(
      "/rosout", ros::Qos::rosout(), [&](const rcl_interfaces::msg::Log& line) {
        if (line.level() == 40 && line.name() == name()) log.push_back(line.msg());
      });
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(change(kConfigure));
    EXPECT_EQ(state(), "unconfigured");
  }
  run_a_moment();
  ASSERT_EQ(log.size(), 2u) << "one message each time";
  EXPECT_THAT(log[0], HasSubstr("configure failed"));
  EXPECT_THAT(log[0], HasSubstr("/no/such/file"));
  const std::string good = file_parameter() == "model"    ? "goalnet"
                           : file_parameter() == "domain" ? "household"
                                                          : "default";
  EXPECT_EQ(set(file_parameter(), text(good)), "");
  EXPECT_TRUE(change(kConfigure));
  EXPECT_THAT(set(file_parameter(), text("another")),
              HasSubstr("while the node is unconfigured; it is inactive"));
  EXPECT_TRUE(change(kActivate));
}

// As `ros2 param list`, `describe` and `dump` see them.
TEST_P(Lifecycle, ParametersAreDescribedInRangeAndRefuseNonsense) {
  start();
  ros::Client<rcl_interfaces::srv::ListParameters> list(*tool_, "/" + name() + "/list_parameters");
  ros::Client<rcl_interfaces::srv::DescribeParameters> describe(*tool_,
                                                                "/" + name() + "/describe_parameters");
  ros::Client<rcl_interfaces::srv::GetParameters> get(*tool_, "/" + name() + "/get_parameters");
  const auto names = list.call_and_run({}, 5s)->result().names();
  const std::set<std::string> listed(names.begin(), names.end());
  EXPECT_TRUE(listed.contains("use_sim_time"));
  EXPECT_TRUE(listed.contains("autostart"));
  for (const auto& row : component_->parameters().rows()) {
    ASSERT_TRUE(listed.contains(row.name)) << row.name;
    rcl_interfaces::srv::DescribeParameters::Request asked;
    asked.names({row.name});
    const auto described = describe.call_and_run(asked, 5s)->descriptors().at(0);
    EXPECT_FALSE(described.description().empty()) << row.name;
    EXPECT_EQ(described.type(), row.default_value.index()) << row.name;
    EXPECT_EQ(described.read_only(), row.settable == ros::Settable::kAtStart) << row.name;
    const bool number = row.default_value.index() == 2 || row.default_value.index() == 3;
    EXPECT_EQ(described.integer_range().size() + described.floating_point_range().size(), number ? 1u : 0u)
        << row.name;
    if (described.read_only()) continue;
    EXPECT_THAT(set(row.name, {}), HasSubstr("is of type")) << row.name << ": not set";
    rcl_interfaces::msg::ParameterValue value;
    value.type(row.default_value.index() == 1 ? 4 : 1);  // a text for a flag, a flag for all else
    EXPECT_THAT(set(row.name, value), HasSubstr("is of type")) << row.name;
    if (!number) continue;
    value.type(static_cast<std::uint8_t>(row.default_value.index()));
    for (const double outside : {row.descriptor.range->from - 1.0, row.descriptor.range->to + 1.0}) {
      value.integer_value(static_cast<std::int64_t>(outside));
      value.double_value(outside);
      EXPECT_THAT(set(row.name, value), HasSubstr("is not within")) << row.name << " " << outside;
    }
  }
  // What was refused changed nothing: a dump, loaded again, is taken as it is.
  for (const auto& row : component_->parameters().rows()) {
    rcl_interfaces::srv::GetParameters::Request asked;
    asked.names({row.name});
    const auto value = get.call_and_run(asked, 5s)->values().at(0);
    if (row.settable != ros::Settable::kAtStart) {
      EXPECT_EQ(set(row.name, value), "") << row.name;
    }
  }
  EXPECT_TRUE(change(kConfigure));
  EXPECT_TRUE(change(kActivate));
}

template <class Message>
void publish(ros::Node& node, const std::string& topic, const ros::Qos& qos = ros::Qos::standard()) {
  node.advertise<Message>(topic, qos)->publish(Message{});
}

TEST_P(Lifecycle, WhileNotActiveNothingIsHeardAndNothingIsSaid) {
  start();
  int said = 0;
  const auto count = [&](const auto&) { ++said; };
  const auto a = tool_->subscribe<goalnet_msgs::msg::InstructionStatus>("instruction_status",
                                                                        ros::Qos::standard(), count);
  const auto b = tool_->subscribe<goalnet_msgs::msg::Plan>("plan", ros::Qos::standard(), count);
  const auto c =
      tool_->subscribe<goalnet_msgs::msg::ActionStatus>("action_status", ros::Qos::standard(), count);
  const auto d =
      tool_->subscribe<goalnet_msgs::msg::ExecutorStatus>("executor_status", ros::Qos::standard(), count);
  const auto e =
      tool_->subscribe<sensor_msgs::msg::JointState>("joint_commands", ros::Qos::standard(), count);
  const auto speak = [&] {
    auto say = tool_->advertise<std_msgs::msg::String>("instruction");
    std_msgs::msg::String words;
    words.data("open the fridge");
    say->publish(words);
    publish<goalnet_msgs::msg::GoalPredicates>(*tool_, "goal");
    publish<goalnet_msgs::msg::GoalPredicates>(*tool_, "goal_predicates");
    publish<goalnet_msgs::msg::StepRequest>(*tool_, "step_request");
    publish<goalnet_msgs::msg::ActionRequest>(*tool_, "action_request");
    publish<goalnet_msgs::msg::CancelInstruction>(*tool_, "cancel_instruction");
    publish<goalnet_msgs::msg::WorldState>(*tool_, "world_state", ros::Qos::latched());
    publish<goalnet_msgs::msg::ObjectPoses>(*tool_, "object_poses");
    publish<sensor_msgs::msg::JointState>(*tool_, "joint_states");
    publish<trajectory_msgs::msg::JointTrajectory>(*tool_, "joint_trajectory");
    run_a_moment();
  };
  speak();
  ASSERT_TRUE(change(kConfigure));
  speak();
  ASSERT_TRUE(change(kActivate));
  ASSERT_TRUE(change(kDeactivate));
  run_a_moment();
  said = 0;
  speak();
  EXPECT_EQ(said, 0);
  ASSERT_TRUE(change(kCleanup));
  speak();
  EXPECT_EQ(said, 0);
  ASSERT_TRUE(change(kConfigure));
  ASSERT_TRUE(change(kActivate)) << "and it still works";
  speak();
}

// Endpoints and memory after many rounds are those after a few.
TEST_P(Lifecycle, ManyRoundsLeaveNothingBehind) {
  start();
  const auto round = [&] {
    ASSERT_TRUE(component_->configure());
    ASSERT_TRUE(component_->activate());
    while (loop_.run_pending()) {
    }
    ASSERT_TRUE(component_->deactivate());
    ASSERT_TRUE(component_->cleanup());
    while (loop_.run_pending()) {
    }
  };
  for (int i = 0; i < 5; ++i) round();
  const std::size_t before = mallinfo2().uordblks;
  constexpr int kRounds = 15;
  for (int i = 0; i < kRounds; ++i) round();
  const std::size_t after = mallinfo2().uordblks;
  const double growth = (static_cast<double>(after) - static_cast<double>(before)) / kRounds;
  RecordProperty("bytes_a_round", static_cast<int>(growth));
  // Models and worlds take megabytes; a forgotten endpoint takes tens of kilobytes.
  EXPECT_LT(growth, 10'000) << "bytes a round";
}

INSTANTIATE_TEST_SUITE_P(Components, Lifecycle,
                         testing::ValuesIn(tools::component_kinds().begin(), tools::component_kinds().end()),
                         name_of);

// Each README shows the table that the component itself has.
TEST_P(Lifecycle, TheReadmeShowsTheTable) {
  const std::string folder = name() == "executor"    ? "executor"
                             : name() == "simulator" ? "sim"
                                                     : "components/" + name();
  std::ifstream file(GOALNET_SOURCE_DIR "/" + folder + "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(readme, HasSubstr(GetParam().parameters(true)))
      << "replace the table in " << folder << "/README.md by that of: goalnet component " << name()
      << " --show-parameters --markdown";
}

}  // namespace
}  // namespace goalnet
