// `goalnet plan` as people meet it: what it prints and its exit codes.
#include "tools/goalnet/plan_command.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace goalnet::tools {
namespace {

using testing::HasSubstr;

struct Printed {
  int code;
  std::string out, error;
};

Printed plan(const std::string& goal, std::vector<std::string> more = {}) {
  const auto file =
      std::filesystem::temp_directory_path() / ("plan_command_" + std::to_string(getpid()) + ".pddl");
  std::ofstream(file)
      << "(define (problem p) (:domain goalnet-household) (:init (IsGraspable Mug_1) (On Mug_1 Counter_1)"
         " (HandsHold Zero) (TrayHolds Zero)) (:goal "
      << goal << "))";
  std::vector<std::string> arguments = {
      "goalnet plan", std::string(GOALNET_SOURCE_DIR) + "/config/domains/household.pddl", file.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = plan_command(static_cast<int>(arguments.size()), argv.data());
  const Printed run{code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
  std::filesystem::remove(file);
  return run;
}

TEST(PlanCommand, PrintsThePlanInTheCompetitionsFormat) {
  const Printed run = plan("(On Mug_1 Sink)");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out,
            "(moveto Mug_1)\n(grasp Mug_1)\n(moveto Sink)\n(keep-on Mug_1 Sink)\n; cost = 4 (unit cost)\n");
  EXPECT_EQ(run.error, "");
  const auto json = nlohmann::json::parse(plan("(On Mug_1 Sink)", {"--json"}).out);
  EXPECT_EQ(json["actions"].size(), 4u);
  EXPECT_EQ(json["optimal"], true);
  EXPECT_GT(json["statistics"]["peak_memory_mb"], 1.0);
  EXPECT_EQ(plan("(On Mug_1 Counter_1)").out, "; cost = 0 (unit cost)\n");  // holds already
}

TEST(PlanCommand, RefusalsNameWhatIsWrong) {
  const auto refused = [](const char* goal, int code, const char* message) {
    const Printed run = plan(goal);
    EXPECT_EQ(run.code, code) << goal;
    EXPECT_THAT(run.error, HasSubstr(message));
    EXPECT_EQ(run.out, "");
  };
  refused("(On Mag_1 Sink)", 13, "unknown object 'Mag_1' (did you mean Mug_1?)");
  refused("(On Mug_1)", 13, "'On' takes 2 arguments, not 1");
  refused("(Onn Mug_1 Sink)", 13, "unknown predicate 'Onn' (did you mean On?)");
  refused("(and (On Mug_1 Sink) (not (On Mug_1 Sink)))", 12, "(On Mug_1 Sink) and (not (On Mug_1 Sink))");
  refused("(and (On Mug_1 Sink) (Grasping Robot Mug_1))", 12,
          "(On Mug_1 Sink) and (Grasping Robot Mug_1) exclude each other");
  refused("(Grasping Robot Sink)", 12, "nothing can make (Grasping Robot Sink) true");
}

}  // namespace
}  // namespace goalnet::tools
