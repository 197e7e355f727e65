// Other programs on the same domain while a run is on: a second instruction, an emergency stop.
#include <gmock/gmock-matchers.h>

#include <nlohmann/json.hpp>

#include "components/ros/node.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "std_msgs/msg/String.h"
#include "tests/support/process.h"

namespace goalnet {
namespace {

using goalnet_msgs::msg::InstructionStatus;
using testing_support::Process;
using testing_support::ProcessResult;

constexpr int kDomain = 83;
constexpr std::chrono::seconds kLimit{60};

// A ROS 2 node that listens in and talks.
class Intruder : public testing::Test {
 protected:
  void SetUp() override {
    ros::ContextOptions options;
    options.domain_id = kDomain;
    context_ = ros::Context::create(options).value();
    ros::NodeOptions node_options;
    node_options.name = "intruder";
    node_ = ros::Node::create(*context_, loop_, std::move(node_options)).value();
    status_ = node_->subscribe<InstructionStatus>(
        "/instruction_status", ros::Qos::latched().keep_last(1000),
        [this](const InstructionStatus& status) { seen_.push_back(status); });
    instruction_ = node_->advertise<std_msgs::msg::String>("/instruction");
    command_ = node_->advertise<std_msgs::msg::String>("/executor_command");
    // A matched reader and writer of the run, so that nothing said is lost.
    run_.emplace(std::vector<std::string>{testing_support::program("goalnet"), "run", "--json", "--goal",
                                          "(In Mug_1 Microwave)"},
                 std::map<std::string, std::string>{{"ROS_DOMAIN_ID", std::to_string(kDomain)}});
    ASSERT_TRUE(loop_.run_for(kLimit, [this] { return !seen_.empty() && seen_.back().stage() == "acting"; }));
  }
  void say(const std::shared_ptr<ros::Publisher<std_msgs::msg::String>>& publisher, const std::string& text) {
    ASSERT_TRUE(publisher->wait_for_subscribers(1, kLimit));
    std_msgs::msg::String message;
    message.data(text);
    publisher->publish(message);
  }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status_;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> instruction_, command_;
  std::vector<InstructionStatus> seen_;
  std::optional<Process> run_;
};

TEST_F(Intruder, ASecondInstructionIsRefusedAndTheFirstGoesOn) {
  say(instruction_, "open the fridge");
  ASSERT_TRUE(loop_.run_for(kLimit, [this] { return !seen_.empty() && seen_.back().finished(); }));
  const auto refused =
      std::find_if(seen_.begin(), seen_.end(), [](const InstructionStatus& s) { return s.outcome() == 14; });
  ASSERT_NE(refused, seen_.end());
  EXPECT_EQ(refused->instruction(), "open the fridge");
  EXPECT_NE(refused->instruction_id(), seen_.front().instruction_id());
  const ProcessResult result = run_->wait(kLimit);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(Intruder, AnEmergencyStopEndsTheRun) {
  say(command_, "emergency_stop");
  const ProcessResult result = run_->wait(kLimit);
  EXPECT_EQ(result.exit_code, 33) << result.out << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["outcome"], "emergency_stop");
}

}  // namespace
}  // namespace goalnet
