// `goalnet tell` as people type it, against a whole robot in another process's place: the loop of `goalnet
// run`.
#include <gmock/gmock-matchers.h>
#include <signal.h>

#include <atomic>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "components/ros/node.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "std_msgs/msg/String.h"
#include "tests/support/process.h"
#include "tools/goalnet/lockstep_loop.h"

namespace goalnet::tools {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;
using testing_support::Process;
using testing_support::ProcessResult;

constexpr const char* kDomain = "92";

// Up until it goes away or leave() is called.
class Robot {
 public:
  Robot() {
    setenv("ROS_DOMAIN_ID", kDomain, 1);
    thread_ = std::jthread([this](const std::stop_token& stop) {
      auto loop = LockstepLoop::create({}, {});
      ASSERT_TRUE(loop) << loop.error().message;
      ASSERT_TRUE((*loop)->settle());
      ready_ = true;
      while (!stop.stop_requested()) {
        (*loop)->step();
        if (slow_) std::this_thread::sleep_for(2ms);
      }
    });
    while (!ready_) std::this_thread::sleep_for(10ms);
  }
  void slow_down() { slow_ = true; }  // so that something lasts a while
  void leave() {
    thread_.request_stop();
    thread_.join();
  }

 private:
  std::atomic<bool> ready_{false}, slow_{false};
  std::jthread thread_;
};

ProcessResult tell(std::vector<std::string> words, const std::chrono::seconds limit = 120s) {
  words.insert(words.begin(), "tell");
  return testing_support::run_goalnet(words, std::atoi(kDomain), {}, limit);
}

std::unique_ptr<Process> telling(const std::string& instruction) {
  return std::make_unique<Process>(
      std::vector<std::string>{testing_support::program("goalnet"), "tell", instruction},
      std::map<std::string, std::string>{{"ROS_DOMAIN_ID", kDomain}});
}

TEST(Tell, CarriesOutRefusesAndCancels) {
  Robot robot;
  const ProcessResult done = tell({"--json", "turn", "on", "the", "tap"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const auto json = nlohmann::json::parse(done.out);
  EXPECT_EQ(json.at("instruction"), "turn on the tap");
  EXPECT_EQ(json.at("outcome"), "done");
  EXPECT_THAT(json.at("facts_added"), Contains("(state SinkKnob TapIsOn)"));
  EXPECT_THAT(json.at("actions"), Contains("turn-on SinkKnob"));
  EXPECT_THAT(json.at("steps").at(0).at("positive"), Contains("(state SinkKnob TapIsOn)"));

  const ProcessResult refused = tell({"sing me the moon"});
  EXPECT_THAT(refused.exit_code, testing::AnyOf(10, 11)) << refused.out;
  EXPECT_THAT(refused.out, HasSubstr("0 actions"));

  // What was most likely meant is offered; "yes" takes the offer, once.
  const ProcessResult asked = tell({"why is the tap still on?"});
  EXPECT_EQ(asked.exit_code, 10) << asked.out;
  EXPECT_THAT(asked.out, HasSubstr("did you mean \"turn off the tap\"?"));
  const ProcessResult yes = tell({"--json", "yes, please"});
  EXPECT_EQ(yes.exit_code, 0) << yes.out;
  EXPECT_THAT(nlohmann::json::parse(yes.out).at("facts_removed"), Contains("(state SinkKnob TapIsOn)"));
  EXPECT_EQ(tell({"yes"}).exit_code, 10);

  robot.slow_down();
  const auto cancelled = telling("put the kettle on the stove");
  ASSERT_TRUE(cancelled->wait_for_text("✓ moveto Kettle", 60s));
  const ProcessResult busy = tell({"open the microwave"});
  EXPECT_EQ(busy.exit_code, 14) << busy.out << busy.err;
  cancelled->signal(SIGINT);
  const ProcessResult end = cancelled->wait(20s);
  EXPECT_EQ(end.exit_code, 22) << end.out << end.err;
  EXPECT_THAT(end.out, HasSubstr("cancelled"));

  const auto left = telling("turn on the tap");
  ASSERT_TRUE(left->wait_for_text("plan  ", 60s));
  robot.leave();
  const Robot again;  // up at once, but it knows nothing of what the first one was told
  const ProcessResult lost = left->wait(20s);
  EXPECT_EQ(lost.exit_code, 32) << lost.out << lost.err;
  EXPECT_THAT(lost.err, HasSubstr("went away"));
}

TEST(Tell, ResetEndsAFault) {
  Robot robot;
  const ProcessResult idle = tell({"--reset"});
  EXPECT_EQ(idle.exit_code, 0) << idle.err;
  EXPECT_THAT(idle.out, HasSubstr("in no fault"));

  const auto context = ros::Context::create().value();
  ros::EventLoop loop;
  ros::NodeOptions options;
  options.name = "person";
  const auto node = ros::Node::create(*context, loop, std::move(options)).value();
  const auto command = node->advertise<std_msgs::msg::String>("/executor_command");
  bool fault = false;
  const auto status = node->subscribe<goalnet_msgs::msg::ExecutorStatus>(
      "/executor_status", ros::Qos::latched(), [&](const auto& message) { fault = message.state() == 3; });
  ASSERT_TRUE(command->wait_for_subscribers(1, 30s));
  std_msgs::msg::String stop;
  stop.data("emergency_stop");
  command->publish(stop);
  ASSERT_TRUE(loop.run_for(30s, [&] { return fault; }));

  const ProcessResult reset = tell({"--reset"});
  EXPECT_EQ(reset.exit_code, 0) << reset.err;
  EXPECT_THAT(reset.out, testing::AllOf(HasSubstr("has left its fault"), HasSubstr("emergency stop")));
  EXPECT_TRUE(loop.run_for(30s, [&] { return !fault; }));
  EXPECT_EQ(tell({"turn on the tap"}).exit_code, 0) << "it works again";
}

TEST(Tell, SaysWhatIsWrongBeforeAnythingMoves) {
  const ProcessResult nobody = tell({"--wait", "1", "--namespace", "/robot7", "open the fridge"});
  EXPECT_EQ(nobody.exit_code, 32);
  EXPECT_THAT(nobody.err, HasSubstr("/robot7/follow_instruction"));
  EXPECT_THAT(nobody.err, HasSubstr("goalnet launch robot"));
  EXPECT_EQ(tell({""}).exit_code, 13);
  EXPECT_EQ(tell({"--namespace", "b ad", "x"}).exit_code, 13);
  EXPECT_EQ(tell({"--wait", "-1", "x"}).exit_code, 13);
  EXPECT_EQ(tell({}).exit_code, 13);
  EXPECT_EQ(tell({"--reset", "x"}).exit_code, 13);
  EXPECT_EQ(tell({"--wait", "1", "--namespace", "/robot7", "--reset"}).exit_code, 32);
}

}  // namespace
}  // namespace goalnet::tools
