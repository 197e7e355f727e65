// Names, the command line and parameter files: pure, no DDS.
#include "components/ros/arguments.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <fstream>

#include "components/ros/names.h"
#include "components/ros/parameter_file.h"

namespace goalnet::ros {
namespace {

using testing::HasSubstr;

TEST(Names, Expand) {
  EXPECT_EQ(*expand_name("/x", "/ns", "n"), "/x");
  EXPECT_EQ(*expand_name("x", "/ns", "n"), "/ns/x");
  EXPECT_EQ(*expand_name("a/b", "/", "n"), "/a/b");
  EXPECT_EQ(*expand_name("~/x", "/ns", "n"), "/ns/n/x");
  EXPECT_EQ(*expand_name("~", "/", "n"), "/n");
  for (const char* bad : {"", "/", "a//b", "a/", "1a", "a b", "a__b", "/x\xc3\xa4", "a-b"}) {
    EXPECT_FALSE(expand_name(bad, "/ns", "n")) << bad;
  }
  EXPECT_FALSE(expand_name(std::string(300, 'a'), "/", "n"));
}

TEST(Names, ToDds) {
  EXPECT_EQ(topic_to_dds("/a/b"), "rt/a/b");
  EXPECT_EQ(service_request_to_dds("/s"), "rq/sRequest");
  EXPECT_EQ(service_reply_to_dds("/s"), "rr/sReply");
  EXPECT_EQ(logger_name("/robot_1", "planner"), "robot_1.planner");
  EXPECT_EQ(logger_name("/", "planner"), "planner");
  EXPECT_EQ(*normalize_namespace("robot_1"), "/robot_1");
  EXPECT_EQ(*normalize_namespace(""), "/");
  EXPECT_FALSE(normalize_namespace("/a b"));
}

TEST(Names, NodePatterns) {
  EXPECT_TRUE(matches_node("/**", "/a/b/c"));
  EXPECT_TRUE(matches_node("planner", "/planner"));
  EXPECT_FALSE(matches_node("planner", "/ns/planner"));
  EXPECT_TRUE(matches_node("/*/planner", "/ns/planner"));
  EXPECT_FALSE(matches_node("/*/planner", "/a/b/planner"));
  EXPECT_TRUE(matches_node("/**/planner", "/a/b/planner"));
  EXPECT_TRUE(matches_node("/**/planner", "/planner"));
  EXPECT_FALSE(matches_node("/ns/planner", "/ns/planner2"));
}

TEST(Arguments, TakesWhatRclTakes) {
  const auto parsed = parse_arguments({"fill the mug", "--ros-args", "-r",
                                       "__node:=me",   "-r",         "__ns:=/robot_1",
                                       "-r",           "a:=/b",      "-p",
                                       "gain:=2.5",    "-p",         "other:names:=[a, b]",
                                       "--log-level",  "debug",      "--log-level",
                                       "me:=error",    "-e",         "/enclave",
                                       "--",           "--seed",     "3"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_THAT(parsed->remaining, testing::ElementsAre("fill the mug", "--seed", "3"));
  EXPECT_EQ(parsed->node_name("planner"), "me");
  EXPECT_EQ(parsed->node_namespace("me"), "/robot_1");
  ASSERT_EQ(parsed->remaps.size(), 3u);
  EXPECT_EQ(parsed->remaps[2].to, "/b");
  ASSERT_EQ(parsed->parameters.size(), 2u);
  EXPECT_EQ(parsed->parameters[0].node, "/**");
  EXPECT_EQ(parsed->parameters[0].value, ParameterValue(2.5));
  EXPECT_EQ(parsed->parameters[1].node, "other");
  EXPECT_EQ(parsed->parameters[1].value, ParameterValue(std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(parsed->log_level, LogLevel::kDebug);
  EXPECT_EQ(parsed->enclave, "/enclave");
}

TEST(Arguments, RulesForOneNodeAndForOneKindOfName) {
  const auto parsed =
      parse_arguments({"--ros-args", "-r", "planner:__node:=brain", "-r", "__node:=other", "-r",
                       "__node:=late", "-r", "brain:__ns:=/head", "-r", "rostopic://plan:=a", "-r",
                       "rosservice:///plan:=/b", "-r", "brain:rostopic://~/x:=c", "-r", "/ns/brain:plan:=d"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->node_name("planner"), "brain");
  EXPECT_EQ(parsed->node_name("coordinator"), "other") << "the first that applies wins, as in rcl";
  EXPECT_EQ(parsed->node_namespace("brain"), "/head");
  EXPECT_EQ(parsed->node_namespace("other"), std::nullopt);
  const auto rule = [&](std::size_t i) {
    const Remap& one = parsed->remaps[i];
    return std::tuple(one.node, one.kind, one.from, one.to);
  };
  ASSERT_EQ(parsed->remaps.size(), 8u);
  EXPECT_EQ(rule(4), std::tuple("", RemapKind::kTopic, "plan", "a"));
  EXPECT_EQ(rule(5), std::tuple("", RemapKind::kService, "/plan", "/b"));
  EXPECT_EQ(rule(6), std::tuple("brain", RemapKind::kTopic, "~/x", "c"));
  EXPECT_EQ(rule(7), std::tuple("/ns/brain", RemapKind::kName, "plan", "d"));
}

TEST(Arguments, LevelsOfLoggersAndOfThoseBelow) {
  const auto parsed = parse_arguments({"--ros-args", "--log-level", "robot_1:=debug", "--log-level", "error",
                                       "--log-level", "robot_1.planner:=fatal"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->level_of("robot_1.planner"), LogLevel::kFatal);
  EXPECT_EQ(parsed->level_of("robot_1.executor"), LogLevel::kDebug);
  EXPECT_EQ(parsed->level_of("robot_12.executor"), LogLevel::kError);
  EXPECT_EQ(Arguments().level_of("planner"), std::nullopt);
  EXPECT_EQ(parse_arguments({"--ros-args", "--log-level", "UNSET"})->log_level, LogLevel::kInfo);
}

// launch and people pass these to every node; here they have no effect.
TEST(Arguments, TakesTheFlagsOfRclsLogLibrary) {
  const auto parsed =
      parse_arguments({"--ros-args", "--log-file-name", "robot", "--log-config-file", "log.yaml",
                       "--disable-external-lib-logs", "--disable-stdout-logs", "--disable-rosout-logs"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_FALSE(parsed->console);
  EXPECT_FALSE(parsed->rosout);
  EXPECT_FALSE(parse_arguments({"--ros-args", "--log-file-name"}));
}

TEST(Arguments, RefusesWithAReason) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--ros-args", "-r"}, "needs a value"},
      {{"--ros-args", "-r", "nonsense"}, "from:=to"},
      {{"--ros-args", "-r", "__node:=a b"}, "node name"},
      {{"--ros-args", "-r", "a:=/b//c"}, "empty part"},
      {{"--ros-args", "-p", "gain"}, "name:=value"},
      {{"--ros-args", "-p", "gain:={a: 1}"}, "neither a value nor an array"},
      {{"--ros-args", "-p", "gain:=[1, x]"}, "one type"},
      {{"--ros-args", "--log-level", "loud"}, "unknown log level"},
      {{"--ros-args", "--params-file", "/nowhere.yaml"}, "cannot open"},
      {{"--ros-args", "--frobnicate"}, "unknown argument"}};
  for (const auto& [words, text] : cases) {
    const auto parsed = parse_arguments(words);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().outcome, Outcome::kInvalidRequest);
    EXPECT_THAT(parsed.error().message, HasSubstr(text));
  }
}

TEST(ParameterFile, ReadsNodesGroupsAndTypes) {
  const auto read = parse_parameters(R"(
/**:
  ros__parameters:
    use_sim_time: true
robot_1:
  planner:
    ros__parameters:
      limits: {nodes: 1000, seconds: 0.5}
      names: ["1", "2"]
      mixed: [1, 2.5]
      quoted: "true"
      none: []
      hex: 0x10
      octal: 010
      endless: [+.Inf, -.inf]
)",
                                     "p.yaml");
  ASSERT_TRUE(read) << read.error().message;
  std::map<std::string, ParameterOverride> by_name;
  for (const auto& one : *read) by_name[one.name] = one;
  EXPECT_EQ(by_name["use_sim_time"].node, "/**");
  EXPECT_EQ(by_name["use_sim_time"].value, ParameterValue(true));
  EXPECT_TRUE(matches_node(by_name["limits.nodes"].node, "/robot_1/planner"));
  EXPECT_EQ(by_name["limits.nodes"].value, ParameterValue(std::int64_t{1000}));
  EXPECT_EQ(by_name["limits.seconds"].value, ParameterValue(0.5));
  EXPECT_EQ(by_name["limits.seconds"].origin, "p.yaml:8");
  EXPECT_EQ(by_name["names"].value, ParameterValue(std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(by_name["mixed"].value, ParameterValue(std::vector<double>{1, 2.5}));
  EXPECT_EQ(by_name["quoted"].value, ParameterValue(std::string("true")));
  EXPECT_EQ(by_name["none"].value, ParameterValue(std::vector<std::string>{}));
  EXPECT_EQ(by_name["hex"].value, ParameterValue(std::int64_t{16}));
  EXPECT_EQ(by_name["octal"].value, ParameterValue(std::int64_t{8}));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(by_name["endless"].value, ParameterValue(std::vector<double>{kInfinity, -kInfinity}));
}

TEST(ParameterFile, MalformedFilesNameFileAndLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"a: [1, 2", "p.yaml:1: not valid YAML"},
      {"\n\n\tplanner: 3", "p.yaml:3: not valid YAML"},
      {"- 1\n- 2", "must be NODE: {ros__parameters"},
      {"planner:\n  gain: 3\n", "p.yaml:2: 'gain' is neither a node nor ros__parameters"},
      {"ros__parameters: {a: 1}", "p.yaml:1: ros__parameters must stand below"},
      {"planner:\n  ros__parameters: 3\n", "p.yaml:2: ros__parameters must hold"},
      {"planner:\n  ros__parameters:\n    a: [1, x]\n",
       "p.yaml:3: the elements of an array must have one type"},
      {"planner:\n  ros__parameters:\n    a: [[1], [2]]\n", "p.yaml:3: an array may only hold plain values"},
      {"planner:\n  ros__parameters:\n    a:\n", "p.yaml:3: parameter 'a' has no value"},
      {"planner:\n  ros__parameters:\n    [1, 2]: 3\n", "must be plain text"},
      {"? [a]\n: {b: {c: 1}}\n", "must be plain text"},
      {std::string("a: \x01\x02"), "p.yaml:1"}};
  for (const auto& [text, message] : cases) {
    const auto read = parse_parameters(text, "p.yaml");
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().outcome, Outcome::kInvalidRequest);
    EXPECT_THAT(read.error().message, HasSubstr(message)) << text;
  }
  EXPECT_TRUE(parse_parameters("", "p.yaml")) << "an empty file sets nothing";
}

TEST(ParameterFile, HostileFilesAreBounded) {
  std::string deep = "a";
  for (int i = 0; i < 200; ++i) deep = "{a: " + deep + "}";
  EXPECT_FALSE(parse_parameters("n: {ros__parameters: " + deep + "}", "p.yaml"));
  std::string many = "n:\n  ros__parameters:\n";
  for (int i = 0; i < 10'001; ++i) many += "    p" + std::to_string(i) + ": 1\n";
  const auto read = parse_parameters(many, "p.yaml");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("more than 10000"));
  const std::string path = testing::TempDir() + "/large.yaml";
  std::ofstream(path) << std::string(2u << 20, '#');
  EXPECT_THAT(read_parameter_file(path).error().message, HasSubstr("larger than 1 MiB"));
}

TEST(ParameterFile, AliasesThatMultiplyAreRefused) {
  std::string text = "n: {ros__parameters: {a: &g0 {}";
  for (int i = 1; i < 30; ++i) {
    const std::string last = "*g" + std::to_string(i - 1);
    text += ", b" + std::to_string(i) + ": &g" + std::to_string(i) + " {x: " + last + ", y: " + last + "}";
  }
  const auto read = parse_parameters(text + "}}", "p.yaml");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("more than 10000 groups"), std::string::npos) << read.error().message;
}

}  // namespace
}  // namespace goalnet::ros
