// Every component as a process of its own, and on each topic and service that it listens to, found by
// discovery: malformed samples, well-formed nonsense, and a flood. It must live on, answer, say each thing
// once, hold its memory, and the executor's control loop must not notice.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "components/ros/detail/participant.h"
#include "components/ros/node.h"
#include "components/ros/service.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "rcl_interfaces/srv/ListParameters_service.h"
#include "tests/support/endpoint_watcher.h"
#include "tests/support/hostile_payloads.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet {
namespace {

using namespace std::chrono_literals;
using testing_support::Bytes;
using testing_support::Process;
using SteadyClock = std::chrono::steady_clock;

const int kDomain = ros::own_domain();
constexpr int kFloodRate = 10'000;  // [messages/s] on each topic
constexpr double kFloodSeconds = 1.0;

std::vector<std::string> component_names() {
  const auto help = testing_support::run_goalnet({"component", "--help"}, kDomain);
  std::vector<std::string> names;
  std::istringstream lines(help.out);
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("components:")) {
      listed = true;
    } else if (listed && line.starts_with("  ")) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    } else if (listed) {
      break;
    }
  }
  return names;
}

double resident_mib(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096 / (1 << 20);
}

// A participant that writes whatever it likes on whatever somebody reads.
class Attacker {
 public:
  explicit Attacker(int domain) : watcher_(domain), context_(ros::make_context(domain)), random_(7) {}

  // Writers on everything that the node `name` listens to. Graph and clock are DDS's and everybody's.
  // `at_least`: how many there must be; a process that is still starting has fewer for a while.
  void aim_at(const std::string& full_name, std::size_t at_least = 1) {
    std::vector<ros::SeenEndpoint> readers;
    const auto limit = SteadyClock::now() + 30s;
    for (int quiet = 0; quiet < 10;) {  // until nothing new was discovered for a while
      ASSERT_LT(SteadyClock::now(), limit) << full_name << " has only " << readers.size() << " readers";
      std::this_thread::sleep_for(50ms);
      auto now = watcher_.readers_of_others(context_->participant()->gid());
      quiet = now.size() == readers.size() && now.size() >= at_least ? quiet + 1 : 0;
      readers = std::move(now);
    }
    for (const auto& reader : readers) {
      const auto* type = idl::find_type(idl::ros_type_name(reader.type));
      ASSERT_NE(type, nullptr) << reader.topic << " of " << full_name << " has the unknown type "
                               << reader.type;
      if (targets_.contains(reader.topic)) {
        ++targets_[reader.topic].readers;
        continue;
      }
      ros::EndpointOptions options;
      options.dds_topic = reader.topic;
      options.dds_type = reader.type;
      options.qos = ros::Qos::standard();
      options.qos.transient_local = reader.transient_local;
      auto writer = ros::Writer::create(context_->participant(), options).value();
      ASSERT_TRUE(writer->wait_for_matched(1, 5s)) << reader.topic;
      targets_[reader.topic] = {std::move(writer), type, 1};
    }
  }

  void malformed() {
    for (auto& [topic, target] : targets_) {
      int sent = 0;
      for (const Bytes& payload : testing_support::malformed_payloads(*target.type, random_)) {
        target.writer->write_raw(payload);
        if (++sent % 5 == 0)
          std::this_thread::sleep_for(1ms);  // more than the depth of a queue would be overwritten
      }
    }
  }
  void senseless() {
    for (auto& [topic, target] : targets_) {
      if (topic.ends_with("/change_stateRequest")) continue;  // a well-formed one is an order and is obeyed
      for (const Bytes& payload : testing_support::senseless_payloads(*target.type)) {
        target.writer->write_raw(payload);
        std::this_thread::sleep_for(1ms);
      }
    }
  }
  // On all topics at once; half of it malformed. Returns how many messages were sent on each.
  int flood() {
    struct Ammunition {
      ros::Writer* writer;
      Bytes good, bad;
    };
    std::vector<Ammunition> all;
    for (auto& [topic, target] : targets_) {
      if (!topic.starts_with("rt/")) continue;
      Bytes good = testing_support::filled_payload(*target.type,
                                                   {.number = 1, .real = 1.0, .text = "x", .elements = 2});
      Bytes bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(good.size() / 2));
      all.push_back({target.writer.get(), std::move(good), std::move(bad)});
    }
    const auto start = SteadyClock::now();
    int sent = 0;
    const int wanted = static_cast<int>(kFloodRate * kFloodSeconds);
    while (sent < wanted) {
      for (auto& one : all) one.writer->write_raw(sent % 2 == 0 ? one.good : one.bad);
      ++sent;
      std::this_thread::sleep_until(start +
                                    std::chrono::duration<double>(sent / static_cast<double>(kFloodRate)));
    }
    return sent;
  }
  // A thousand requests at once to each service.
  void flood_services() {
    for (auto& [topic, target] : targets_) {
      if (!topic.starts_with("rq/")) continue;
      const Bytes request = testing_support::filled_payload(*target.type, {.elements = 0});
      for (int i = 0; i < 1000; ++i) target.writer->write_raw(request);
    }
  }

  std::size_t readers_of(const std::string& topic) const { return targets_.at(topic).readers; }
  std::vector<std::string> topics(const std::string& prefix) const {
    std::vector<std::string> names;
    for (const auto& [topic, target] : targets_) {
      if (topic.starts_with(prefix)) names.push_back(topic);
    }
    return names;
  }

 private:
  struct Target {
    std::shared_ptr<ros::Writer> writer;
    const idl::TypeDescription* type = nullptr;
    std::size_t readers = 0;
  };
  ros::EndpointWatcher watcher_;
  std::unique_ptr<ros::Context> context_;
  std::mt19937 random_;
  std::map<std::string, Target> targets_;
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// The executor tells its counts in the status that answers a refused trajectory.
class ExecutorCounts {
 public:
  ExecutorCounts(ros::Node& node)
      : node_(node),
        ask_(node.advertise<trajectory_msgs::msg::JointTrajectory>("/joint_trajectory")),
        status_(node.subscribe<goalnet_msgs::msg::ExecutorStatus>(
            "/executor_status", ros::Qos::latched(), [this](const auto& message) { last_ = message; })) {}
  // The answer to a trajectory of ours, known by its stamp: not one that waited in a queue.
  goalnet_msgs::msg::ExecutorStatus read() {
    EXPECT_TRUE(ask_->wait_for_subscribers(1, 5s));
    bool answered = false;
    trajectory_msgs::msg::JointTrajectory nothing;
    for (int tries = 0; tries < 40 && !answered; ++tries) {
      nothing.header().stamp(node_.now().to_msg());
      ask_->publish(nothing);
      answered = node_.loop().run_for(
          500ms, [&] { return last_.cycles() > 0 && last_.trajectory_stamp() == nothing.header().stamp(); });
    }
    EXPECT_TRUE(answered);
    return last_;
  }

 private:
  ros::Node& node_;
  goalnet_msgs::msg::ExecutorStatus last_;
  std::shared_ptr<ros::Publisher<trajectory_msgs::msg::JointTrajectory>> ask_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ExecutorStatus>> status_;
};

class Hostile : public testing::TestWithParam<std::string> {};

TEST_P(Hostile, ComponentLivesAnswersAndHoldsItsMemory) {
  const std::string name = GetParam();
  Process component({testing_support::program("goalnet"), "component", name},
                    {{"ROS_DOMAIN_ID", std::to_string(kDomain)}});
  ASSERT_TRUE(component.wait_for_text(name + " is up", 20s)) << component.err();
  Attacker attacker(kDomain);
  attacker.aim_at("/" + name);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_GE(attacker.topics("rq/").size(), 6u) << "the parameter services at least";
  const bool is_executor = name == "executor";

  auto context = ros::make_context(kDomain);
  ros::EventLoop loop;
  ros::Node node(*context, loop, ros::plain("judge"));
  ros::Client<rcl_interfaces::srv::ListParameters> ask(node, "/" + name + "/list_parameters");
  ASSERT_TRUE(ask.wait_for_service(5s));
  std::optional<Process>
      simulator;  // gives the executor's loop something to control; started after the aim was taken
  std::optional<ExecutorCounts> executor;
  goalnet_msgs::msg::ExecutorStatus idle_start, idle_end, flooded_end;
  SteadyClock::time_point t0, t1, t2;
  if (is_executor) {
    simulator.emplace(std::vector<std::string>{testing_support::program("goalnet"), "component", "simulator"},
                      std::map<std::string, std::string>{{"ROS_DOMAIN_ID", std::to_string(kDomain)}});
    executor.emplace(node);
    idle_start = executor->read();
    t0 = SteadyClock::now();
    loop.run_for(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(kFloodSeconds)));
    idle_end = executor->read();
    t1 = SteadyClock::now();
  }

  attacker.malformed();
  attacker.senseless();
  attacker.flood_services();
  EXPECT_TRUE(ask.call_and_run({}, 10s)) << "it answers after the nonsense: " << component.err();
  const double before = resident_mib(component.pid());
  if (is_executor) {
    idle_end = executor->read();
    t1 = SteadyClock::now();
  }
  const int sent = attacker.flood();
  if (is_executor) {
    flooded_end = executor->read();
    t2 = SteadyClock::now();
  }
  EXPECT_EQ(sent, kFloodRate);
  EXPECT_TRUE(ask.call_and_run({}, 10s)) << "it answers after the flood: " << component.err();
  attacker.flood();
  EXPECT_TRUE(ask.call_and_run({}, 10s));
  const double after = resident_mib(component.pid());
  EXPECT_LT(after, before + 32) << "a second flood of " << sent
                                << " messages a topic must not grow it without bound";

  const std::string words = component.err();
  for (const std::string& topic : attacker.topics("rt/")) {
    const std::size_t said = count(words, "dropped a malformed message on " + topic.substr(2) + " ");
    EXPECT_GE(said, 1u) << topic;
    EXPECT_LE(said, 6u * attacker.readers_of(topic))
        << topic << ": at the 1st, 10th, 100th, ... and 100,000th";
  }
  for (const std::string& topic : attacker.topics("rq/")) {
    const std::string service = topic.substr(2, topic.size() - 2 - 7);
    EXPECT_LE(count(words, "dropped a request to " + service + ":"), 1u) << topic;
  }
  if (is_executor) {
    const auto seconds = [](auto span) { return std::chrono::duration<double>(span).count(); };
    const double idle_rate = static_cast<double>(idle_end.cycles() - idle_start.cycles()) / seconds(t1 - t0);
    const double flooded_rate =
        static_cast<double>(flooded_end.cycles() - idle_end.cycles()) / seconds(t2 - t1);
    std::printf("control loop: %.0f cycles/s, %.0f under the flood; overruns %lu and %lu\n", idle_rate,
                flooded_rate, idle_end.overruns() - idle_start.overruns(),
                flooded_end.overruns() - idle_end.overruns());
    EXPECT_GT(flooded_rate, 0.95 * idle_rate) << "the control loop is undisturbed: " << component.err();
  }
  std::printf("%s: %zu topics, %zu services, %.1f -> %.1f MiB\n", name.c_str(), attacker.topics("rt/").size(),
              attacker.topics("rq/").size(), before, after);
  component.signal(SIGINT);
  EXPECT_EQ(component.wait(300s).exit_code, 0) << component.err();
}

INSTANTIATE_TEST_SUITE_P(Components, Hostile, testing::ValuesIn(component_names()),
                         [](const auto& instance) { return instance.param; });

// A whole run, in lockstep and so repeatable, under a rain of malformed samples on all its topics: the same
// result to the last number.
TEST(HostileRun, MalformedSamplesChangeNothing) {
  const std::vector<std::string> arguments = {
      testing_support::program("goalnet"), "run", "--json", "--goal", "(In Mug_1 Microwave)", "--verbose"};
  const std::map<std::string, std::string> environment = {{"ROS_DOMAIN_ID", std::to_string(kDomain)}};
  const auto result_of = [](const testing_support::ProcessResult& result) {
    EXPECT_EQ(result.exit_code, 0) << result.err;
    auto json = nlohmann::json::parse(result.out);
    json.erase("wall_time_s");
    return json;
  };
  const auto undisturbed = result_of(Process(arguments, environment).wait(120s));
  Process run(arguments, environment);
  Attacker attacker(kDomain);
  attacker.aim_at("the run", 100);  // eight nodes' topics and services
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_GT(attacker.topics("rt/").size(), 8u);
  int rounds = 0;
  while (kill(run.pid(), 0) == 0 && rounds < 2) {
    attacker.malformed();
    ++rounds;
  }
  EXPECT_EQ(result_of(run.wait(120s)), undisturbed);
  EXPECT_GE(rounds, 1);
}

}  // namespace
}  // namespace goalnet
