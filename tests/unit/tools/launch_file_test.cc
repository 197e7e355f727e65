// What a launch file becomes, and what is said of one that makes no sense.
#include "tools/goalnet/launch/launch_file.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

namespace goalnet::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const LaunchSurroundings kSurroundings{"/bin/goalnet", {"simulator", "planner"}, "/usr/bin:/bin"};

Expected<LaunchPlan> parse_launch(const std::string& text,
                                  const std::map<std::string, std::string>& given = {}) {
  return parse_launch(text, "x.yaml", "/folder", given, kSurroundings);
}

TEST(LaunchFile, ComponentsBecomeCommands) {
  const auto plan = parse_launch(R"(
arguments: {scene: kitchen, space: /robot1}
namespace: ${space}
use_sim_time: true
environment: {A: x, C: ""}
patience: 1.5
processes:
  simulator: {component: simulator, parameters: {scene: "${scene}", seed: 3}, restart: never}
  brain: {component: planner, remap: {/plan: /my_plan}, environment: {A: y, B: z}, required: false}
)",
                                 {{"scene", "living_room"}});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->patience, 1.5);
  ASSERT_EQ(plan->processes.size(), 2u);
  EXPECT_THAT(
      plan->processes[0].command,
      ElementsAre("/bin/goalnet", "component", "simulator", "--ros-args", "-r", "__ns:=/robot1", "-r",
                  "/tf:=tf", "-r", "/tf_static:=tf_static", "-p", "scene:=living_room", "-p", "seed:=3"));
  EXPECT_EQ(plan->processes[0].restart.when, RestartWhen::kNever);
  EXPECT_THAT(plan->processes[1].command,
              ElementsAre("/bin/goalnet", "component", "planner", "--ros-args", "-r", "__ns:=/robot1", "-r",
                          "/tf:=tf", "-r", "/tf_static:=tf_static", "-r", "__node:=brain", "-p",
                          "use_sim_time:=true", "-r", "/plan:=/my_plan"));
  EXPECT_EQ(plan->processes[1].environment.at("A"), "y");
  EXPECT_FALSE(plan->processes[1].environment.contains("C")) << "left as it is";
  EXPECT_FALSE(plan->processes[1].required);
}

TEST(LaunchFile, CommandsAreFoundInThePath) {
  const auto plan =
      parse_launch("processes: {say: {command: [sh, -c, 'echo 1'], restart: {when: always, limit: 2}}}");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_THAT(plan->processes[0].command, ElementsAre(testing::EndsWith("/sh"), "-c", "echo 1"));
  EXPECT_EQ(plan->processes[0].restart.limit, 2);
}

TEST(LaunchFile, SlipsAreNamedWithTheirLine) {
  const std::pair<const char*, const char*> kSlips[] = {
      {"", "must be a map"},
      {"- a", "must be a map"},
      {"processes: {}", "needs 'processes:'"},
      {"processes:\n  a: {component: planer}",
       "x.yaml:2: there is no component 'planer'; known: simulator, planner"},
      {"processes:\n  a: {}", "x.yaml:2: process 'a' needs either"},
      {"processes: {a: {component: planner, command: [sh]}}", "needs either"},
      {"processes: {a: {command: [no_such_program_here]}}",
       "there is no program 'no_such_program_here' in PATH"},
      {"processes: {a: {command: [/etc/passwd]}}", "/etc/passwd cannot be executed"},
      {"processes: {a: {command: sh}}", "a list of words"},
      {"processes: {a: {command: []}}", "must be a list"},
      {"processes: {a: {command: [sh], parameters: {x: 1}}}", "for components only"},
      {"processes: {a: {component: planner, params_file: /no/such.yaml}}",
       "cannot read the parameter file /no/such.yaml"},
      {"processes: {a: {component: planner, restart: sometimes}}", "never, on_failure or always"},
      {"processes: {a: {component: planner, restart: {limit: -1}}}", "'limit' must be a number"},
      {"processes: {a: {component: planner, required: maybe}}", "'required' must be true or false"},
      {"processes: {a: {component: planner, colour: red}}", "has no key 'colour'; known:"},
      {"proceses: {a: {component: planner}}", "has no key 'proceses'"},
      {"patience: soon\nprocesses: {a: {component: planner}}", "'patience' must be a number"},
      {"patience: .nan\nprocesses: {a: {component: planner}}", "'patience' must be a number"},
      {"processes: {a: {component: '${b}'}}", "${b} is not among the file's arguments"},
      {"processes: {a: {component: '${b'}}", "'${' without '}'"},
      {"processes: {a: {component: planner}, a: {component: planner}}", "two processes called 'a'"},
      {"processes: {a: {component: [x]}}", "plain text is needed"},
      {"processes: {a: [}", "this is no YAML"},
  };
  for (const auto& [text, message] : kSlips) {
    const auto plan = parse_launch(text);
    ASSERT_FALSE(plan) << text;
    EXPECT_EQ(plan.error().outcome, Outcome::kInvalidRequest) << text;
    EXPECT_THAT(plan.error().message, HasSubstr(message)) << text;
    EXPECT_THAT(plan.error().message, testing::StartsWith("x.yaml")) << text;
  }
  const auto unknown =
      parse_launch("arguments: {scene: a}\nprocesses: {a: {component: planner}}", {{"scenes", "b"}});
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("there is no argument 'scenes'; this file has: scene"));
}

TEST(LaunchFile, ThoseThatAreShippedAreSound) {
  LaunchSurroundings all = kSurroundings;
  all.components = {"simulator", "executor",     "world_model", "goalnet",
                    "planner",   "manipulation", "coordinator", "visualization"};
  const std::string folder = GOALNET_SOURCE_DIR "/config/launch/";
  const auto robot = read_launch_file(folder + "robot.yaml", {{"namespace", "/robot1"}}, all);
  ASSERT_TRUE(robot) << robot.error().message;
  EXPECT_EQ(robot->processes.size(), 8u);
  const auto components = read_launch_file(folder + "components.yaml", {}, all);
  ASSERT_TRUE(components) << components.error().message;
  EXPECT_EQ(components->processes.size(), 7u);
  EXPECT_THAT(read_launch_file("/no/such/file.yaml", {}, all).error().message,
              HasSubstr("cannot read the launch file /no/such/file.yaml"));
}

TEST(LaunchFile, SaysWhichComponentsAreWatchedForSilence) {
  const auto plan = parse_launch(
      "restart: {silent_after: 20}\nnamespace: /robot1\nprocesses:\n"
      "  thinker: {component: planner}\n"
      "  world: {component: simulator, namespace: /, restart: {silent_after: 0}}\n"
      "  other: {command: [sh]}\n");
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->processes.size(), 3u);
  EXPECT_EQ(plan->processes[0].node, "/robot1/thinker");
  EXPECT_EQ(plan->processes[0].restart.silent_after, 20.0);
  EXPECT_EQ(plan->processes[1].node, "/world");
  EXPECT_EQ(plan->processes[1].restart.silent_after, 0.0);
  EXPECT_EQ(plan->processes[2].node, "") << "not a component: nobody to ask";
  const auto bad = parse_launch("restart: {silent_after: -1}\nprocesses:\n  a: {component: planner}\n");
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, HasSubstr("silent_after"));
}

TEST(RestartPolicy, BacksOffAndGivesUp) {
  using Kind = RestartPolicy::Decision::Kind;
  RestartPolicy policy(
      {.when = RestartWhen::kOnFailure, .delay = 1, .longest_delay = 3, .limit = 3, .window = 60});
  EXPECT_EQ(policy.ended(false, 0).kind, Kind::kStayEnded);
  EXPECT_EQ(policy.ended(true, 10).at, 11);
  EXPECT_EQ(policy.ended(true, 12).at, 14) << "twice as long";
  EXPECT_EQ(policy.ended(true, 15).at, 18) << "no longer than the longest";
  EXPECT_EQ(policy.ended(true, 19).kind, Kind::kGiveUp);
  EXPECT_EQ(policy.ended(true, 200).at, 201) << "long ago is forgotten";
  RestartPolicy always({.when = RestartWhen::kAlways});
  EXPECT_EQ(always.ended(false, 0).kind, Kind::kRestart);
  RestartPolicy never({.when = RestartWhen::kNever});
  EXPECT_EQ(never.ended(true, 0).kind, Kind::kGiveUp);
  EXPECT_EQ(never.ended(false, 0).kind, Kind::kStayEnded);
}

}  // namespace
}  // namespace goalnet::tools
