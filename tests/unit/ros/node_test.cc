// A node as a whole: parameters, clocks, timers, logs, and what ROS 2 tools ask it.
#include "components/ros/node.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/ros/parameter_file.h"
#include "components/ros/service.h"
#include "rcl_interfaces/msg/Log.h"
#include "rcl_interfaces/msg/ParameterEvent.h"
#include "rcl_interfaces/srv/DescribeParameters_service.h"
#include "rcl_interfaces/srv/GetParameterTypes_service.h"
#include "rcl_interfaces/srv/GetParameters_service.h"
#include "rcl_interfaces/srv/ListParameters_service.h"
#include "rcl_interfaces/srv/SetLoggerLevels_service.h"
#include "rcl_interfaces/srv/SetParametersAtomically_service.h"
#include "rcl_interfaces/srv/SetParameters_service.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/support.h"
#include "type_description_interfaces/srv/GetTypeDescription_service.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
namespace srv = rcl_interfaces::srv;

NodeOptions with(std::vector<std::string> words) {
  NodeOptions options = plain("planner");
  words.insert(words.begin(), "--ros-args");
  options.arguments = parse_arguments(words).value();
  options.arguments.console = false;
  return options;
}

struct NodeTest : testing::Test {
  std::unique_ptr<Context> context = make_context(own_domain());
  EventLoop loop;
};

TEST_F(NodeTest, NamesAndRemaps) {
  Node node(*context, loop,
            with({"-r", "__ns:=/robot_1", "-r", "__node:=brain", "-r", "world_state:=/shared/world"}));
  EXPECT_EQ(node.full_name(), "/robot_1/brain");
  EXPECT_EQ(node.resolve("world_state"), "/shared/world");
  EXPECT_EQ(node.resolve("plan"), "/robot_1/plan");
  EXPECT_EQ(node.resolve("~/x"), "/robot_1/brain/x");
  Node other(
      *context, loop,
      with({"-r", "planner:__node:=two", "-r", "rostopic://a:=b", "-r", "two:c:=/d", "-r", "planner:c:=/e"}));
  EXPECT_EQ(other.full_name(), "/two");
  EXPECT_EQ(other.resolve("a"), "/b");
  EXPECT_EQ(other.resolve("a", RemapKind::kService), "/a");
  EXPECT_EQ(other.resolve("a", RemapKind::kName), "/a") << "actions are of both kinds";
  EXPECT_EQ(other.resolve("c"), "/d") << "rules name the node as it is called in the end";
  const auto bad = Node::create(*context, loop, plain("a b"));
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, HasSubstr("node name"));
}

TEST_F(NodeTest, ParametersTakeOverridesAndAreChecked) {
  Node node(*context, loop,
            with({"-p", "gain:=3", "-p", "planner:depth:=7", "-p", "other:depth:=9", "-p", "speed:=9.5", "-p",
                  "name:=12", "-p", "lost:=1"}));
  EXPECT_EQ(*node.declare_parameter("gain", 1.0), 3.0) << "an integer where a number is meant";
  EXPECT_EQ(*node.declare_parameter("depth", 1), 7);
  EXPECT_EQ(*node.declare_parameter("label", "x"), "x");
  EXPECT_EQ(*node.declare_parameter("names", std::vector<std::string>{"a"}), std::vector<std::string>{"a"});
  const auto too_fast =
      node.declare_parameter("speed", 1.0, {.description = "m/s", .range = ParameterRange{0, 2}});
  ASSERT_FALSE(too_fast);
  EXPECT_THAT(too_fast.error().message, HasSubstr("-p: parameter 'speed': 9.5 is not within 0 .. 2"));
  const auto wrong_type = node.declare_parameter("name", "text");
  ASSERT_FALSE(wrong_type);
  EXPECT_THAT(wrong_type.error().message, HasSubstr("must be a string (for example \"text\")"));
  EXPECT_FALSE(node.declare_parameter("gain", 1.0)) << "twice";
  EXPECT_FALSE(node.declare_parameter("gain.left", 1.0)) << "a file has either a value there or a group";
  ASSERT_TRUE(node.declare_parameter("gains.left", 1.0));
  EXPECT_FALSE(node.declare_parameter("gains", 1.0));
  EXPECT_THAT(node.parameters().unused_overrides(), ElementsAre("lost (-p)"));
  EXPECT_EQ(node.parameter<double>("gain"), 3.0);
}

TEST_F(NodeTest, DumpedParametersLoadAgain) {
  Node node(*context, loop, plain("planner"));
  node.declare_parameter("a.b", 0.25);
  node.declare_parameter("text", "say \"hi\"\\\n");
  node.declare_parameter("list", std::vector<std::int64_t>{1, 2});
  node.declare_parameter("flags", std::vector<bool>{true, false});
  node.declare_parameter("whole", 2.0);
  node.declare_parameter("odd: name # - [", std::string("\t\r\x01 end"));
  node.declare_parameter("null", 1);
  const auto loaded = parse_parameters(node.parameters().dump(node.full_name()), "dump");
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->size(), node.parameters().names().size());
  for (const auto& one : *loaded) EXPECT_EQ(one.value, *node.parameters().find(one.name)) << one.name;
}

TEST_F(NodeTest, ADumpWithoutParametersLoadsToo) {
  const auto loaded = parse_parameters(Parameters().dump("/node"), "dump");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(loaded->empty());
}

TEST_F(NodeTest, SimulatedTimeDrivesClockAndTimers) {
  Node node(*context, loop, with({"-p", "use_sim_time:=true"}));
  auto clock = node.advertise<rosgraph_msgs::msg::Clock>("/clock", Qos::clock());
  EXPECT_EQ(node.now().nanoseconds, 0);
  int calls = 0;
  auto timer = node.create_timer(100ms, [&] { ++calls; });
  const auto tick = [&](std::int64_t ms) {
    rosgraph_msgs::msg::Clock message;
    message.clock(Time(ms * 1'000'000).to_msg());
    clock->publish(message);
    while (loop.run_pending()) {
    }
  };
  for (int ms = 10; ms <= 1000; ms += 10) tick(ms);
  EXPECT_EQ(node.now().nanoseconds, 1'000'000'000);
  EXPECT_EQ(calls, 10);
  tick(5000);
  EXPECT_EQ(calls, 11) << "missed periods are skipped";
  timer->cancel();
  tick(6000);
  EXPECT_EQ(calls, 11);
}

TEST_F(NodeTest, WallTimersRun) {
  Node node(*context, loop, plain("planner"));
  int calls = 0;
  auto timer = node.create_timer(10ms, [&] {
    if (++calls == 5) loop.stop();
  });
  const auto start = std::chrono::steady_clock::now();
  loop.run();
  EXPECT_EQ(calls, 5);
  EXPECT_GE(std::chrono::steady_clock::now() - start, 50ms);
}

TEST_F(NodeTest, TimeConversions) {
  EXPECT_EQ(Time(Time(-1).to_msg()).nanoseconds, -1);
  EXPECT_EQ(Time(1'999'999'999).to_msg().nanosec(), 999'999'999u);
  EXPECT_EQ(from_duration_msg(to_duration_msg(-1500ms)), -1500ms);
}

TEST_F(NodeTest, LogsReachRosout) {
  Node node(*context, loop, with({"-r", "__ns:=/robot_1", "--log-level", "warn"}));
  Node listener(*context, loop, plain("listener"));
  std::vector<rcl_interfaces::msg::Log> seen;
  node.log().error("before anyone listens: {}", 1);
  auto in = listener.subscribe<rcl_interfaces::msg::Log>("/rosout", Qos::rosout(),
                                                         [&](const auto& m) { seen.push_back(m); });
  node.log().info("too quiet");
  node.log().warn("{} and {}", "this", 2);
  loop.run_for(2s, [&] { return seen.size() >= 2; });
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].msg(), "before anyone listens: 1");
  EXPECT_EQ(seen[1].msg(), "this and 2");
  EXPECT_EQ(seen[1].level(), 30);
  EXPECT_EQ(seen[1].name(), "robot_1.planner");
  EXPECT_THAT(seen[1].file(), HasSubstr("node_test.cc"));
  EXPECT_GT(seen[1].line(), 0u);
}

rcl_interfaces::msg::Parameter parameter(const std::string& name, double value) {
  rcl_interfaces::msg::Parameter one;
  one.name(name);
  one.value().type(3);
  one.value().double_value(value);
  return one;
}

TEST_F(NodeTest, ParameterServices) {
  Node node(*context, loop, plain("planner"));
  Node tool(*context, loop, plain("tool"));
  node.declare_parameter("limits.speed", 1.0, {.description = "m/s", .range = ParameterRange{0, 2, 0.5}});
  node.declare_parameter("limits.force", 5.0, {.description = "N", .read_only = true});
  node.declare_parameter("depth", 4);
  node.parameters().add_validator([](const std::vector<Parameter>& values) -> Expected<void> {
    for (const auto& one : values) {
      if (one.name == "limits.speed" && std::get<double>(one.value) == 1.5)
        return fail(Outcome::kInvalidRequest, "not that one");
    }
    return {};
  });
  std::vector<rcl_interfaces::msg::ParameterEvent> events;
  auto in = tool.subscribe<rcl_interfaces::msg::ParameterEvent>("/parameter_events", Qos::parameters(),
                                                                [&](const auto& m) { events.push_back(m); });
  Client<srv::SetParameters> set(tool, "/planner/set_parameters");
  Client<srv::SetParametersAtomically> set_all(tool, "/planner/set_parameters_atomically");
  Client<srv::ListParameters> list(tool, "/planner/list_parameters");
  Client<srv::DescribeParameters> describe(tool, "/planner/describe_parameters");

  srv::SetParameters::Request request;
  request.parameters({parameter("limits.speed", 2.0), parameter("limits.speed", 0.7),
                      parameter("limits.speed", 3.0), parameter("limits.speed", 1.5),
                      parameter("limits.force", 1.0), parameter("depth", 1.0), parameter("unknown", 1.0)});
  const auto results = set.call_and_run(request, 2s);
  ASSERT_TRUE(results);
  std::vector<bool> successes;
  std::string reasons;
  for (const auto& one : results->results()) {
    successes.push_back(one.successful());
    reasons += one.reason() + "|";
  }
  EXPECT_THAT(successes, ElementsAre(true, false, false, false, false, false, false)) << reasons;
  for (const char* text : {"steps of 0.5", "not within 0 .. 2", "not that one", "read-only",
                           "of type integer", "not declared"}) {
    EXPECT_THAT(reasons, HasSubstr(text));
  }
  EXPECT_EQ(node.parameter<double>("limits.speed"), 2.0);

  // ros2 param delete sets a parameter to "not set": refused, as of all parameters of a fixed type.
  srv::SetParameters::Request removal;
  rcl_interfaces::msg::Parameter nothing;
  nothing.name("limits.speed");
  removal.parameters({nothing});
  const auto kept = set.call_and_run(removal, 2s);
  ASSERT_TRUE(kept);
  EXPECT_FALSE(kept->results().at(0).successful());
  EXPECT_THAT(kept->results().at(0).reason(), HasSubstr("of type"));

  srv::SetParametersAtomically::Request atomic;
  atomic.parameters({parameter("limits.speed", 0.5), parameter("unknown", 1.0)});
  const auto none = set_all.call_and_run(atomic, 2s);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->result().successful());
  EXPECT_EQ(node.parameter<double>("limits.speed"), 2.0) << "all or none";

  const auto all = list.call_and_run({}, 2s);
  ASSERT_TRUE(all);
  EXPECT_THAT(all->result().names(), ElementsAre("depth", "limits.force", "limits.speed",
                                                 "start_type_description_service", "use_sim_time"));
  EXPECT_THAT(all->result().prefixes(), ElementsAre("limits"));
  srv::ListParameters::Request below;
  below.prefixes({"limits"});
  EXPECT_THAT(list.call_and_run(below, 2s)->result().names(), ElementsAre("limits.force", "limits.speed"));

  srv::DescribeParameters::Request names;
  names.names({"limits.speed", "depth"});
  const auto described = describe.call_and_run(names, 2s);
  ASSERT_TRUE(described);
  ASSERT_EQ(described->descriptors().size(), 2u);
  EXPECT_EQ(described->descriptors()[0].description(), "m/s");
  EXPECT_EQ(described->descriptors()[0].floating_point_range().at(0).step(), 0.5);
  EXPECT_EQ(described->descriptors()[1].type(), 2);

  // A name that nobody declared empties the whole answer, as rclcpp's and rclpy's: `ros2 param get` fails by
  // it.
  Client<srv::GetParameters> get(tool, "/planner/get_parameters");
  Client<srv::GetParameterTypes> get_types(tool, "/planner/get_parameter_types");
  for (const bool declared : {true, false}) {
    const std::vector<std::string> asked = {"depth", declared ? "use_sim_time" : "nothing"};
    const std::size_t expected = declared ? 2 : 0;
    srv::GetParameters::Request values;
    values.names(asked);
    EXPECT_EQ(get.call_and_run(values, 2s)->values().size(), expected);
    srv::GetParameterTypes::Request types;
    types.names(asked);
    EXPECT_EQ(get_types.call_and_run(types, 2s)->types().size(), expected);
    names.names(asked);
    EXPECT_EQ(describe.call_and_run(names, 2s)->descriptors().size(), expected);
  }

  ASSERT_EQ(events.size(), 1u) << "one change happened";
  EXPECT_EQ(events[0].node(), "/planner");
  EXPECT_EQ(events[0].changed_parameters().at(0).value().double_value(), 2.0);
}

TEST_F(NodeTest, LoggerAndTypeServices) {
  Node node(*context, loop, plain("planner"));
  Client<srv::SetLoggerLevels> levels(node, "/planner/set_logger_levels");
  srv::SetLoggerLevels::Request request;
  rcl_interfaces::msg::LoggerLevel level;
  level.name("planner");
  level.level(10);
  request.levels({level});
  ASSERT_TRUE(levels.call_and_run(request, 2s)->results().at(0).successful());
  EXPECT_EQ(node.log().level(), LogLevel::kDebug);
  request.levels()[0].level(0);  // unset: the default again
  ASSERT_TRUE(levels.call_and_run(request, 2s)->results().at(0).successful());
  EXPECT_EQ(node.log().level(), LogLevel::kInfo);
  request.levels()[0].level(15);
  EXPECT_FALSE(levels.call_and_run(request, 2s)->results().at(0).successful());

  using type_description_interfaces::srv::GetTypeDescription;
  Client<GetTypeDescription> types(node, "/planner/get_type_description");
  GetTypeDescription::Request wanted;
  wanted.type_name("std_msgs/msg/String");
  wanted.type_hash("RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
  wanted.include_type_sources(true);
  const auto described = types.call_and_run(wanted, 2s);
  ASSERT_TRUE(described);
  ASSERT_TRUE(described->successful()) << described->failure_reason();
  EXPECT_EQ(described->type_description().type_description().fields().at(0).name(), "data");
  EXPECT_THAT(described->type_sources().at(0).raw_file_contents(), HasSubstr("string data"));
  wanted.type_hash("RIHS01_00");
  EXPECT_FALSE(types.call_and_run(wanted, 2s)->successful());
}

}  // namespace
}  // namespace goalnet::ros
