// How a run can end, seen from outside: exit code and JSON for each outcome that the whole loop can produce.
#include <gmock/gmock-more-matchers.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/process.h"
#include "tests/support/slowdown.h"

namespace goalnet {
namespace {

using testing::HasSubstr;
using testing_support::Process;
using testing_support::ProcessResult;

constexpr int kDomain = 82;

struct Ended {
  int exit_code = -1;
  nlohmann::json json;
};

Ended run(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"run", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProcessResult result = testing_support::run_goalnet(all, kDomain, {}, std::chrono::seconds(100));
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << "one object, one line";
  return {result.exit_code, nlohmann::json::parse(result.out, nullptr, false)};
}

void expect_end(const Ended& ended, int code, const std::string& outcome, const std::string& part) {
  EXPECT_EQ(ended.exit_code, code) << ended.json.dump(1);
  ASSERT_TRUE(ended.json.is_object());
  EXPECT_EQ(ended.json["outcome"], outcome);
  EXPECT_THAT(ended.json["message"].get<std::string>(), HasSubstr(part));
}

TEST(OutcomeOfARun, NotUnderstood) {
  const Ended ended = run({"flurb the gribble with wibble"});
  expect_end(ended, 10, "not_understood", "");
  EXPECT_FALSE(ended.json["message"].get<std::string>().empty());
  EXPECT_TRUE(ended.json["steps"].empty());
}

TEST(OutcomeOfARun, UnknownObject) {
  expect_end(run({"--goal", "(On Mug_9 Sink)"}), 11, "unknown_object", "Mug_9");
}

TEST(OutcomeOfARun, NoPlan) {
  const Ended ended = run({"--goal", "(Grasping Robot Mug_1)", "--goal", "(On Mug_1 Sink)"});
  expect_end(ended, 12, "no_plan", "");
  EXPECT_FALSE(ended.json["message"].get<std::string>().empty());
}

TEST(OutcomeOfARun, TimeLimit) {
  expect_end(run({"--goal", "(state Microwave DoorIsOpen)", "--max-sim-time", "1"}), 20, "time_limit",
             "too long");
}

TEST(OutcomeOfARun, StepLimit) {
  expect_end(run({"--max-steps", "1", "open the microwave"}), 21, "step_limit", "");
}

// Shared memory is off by default; here it is on, so that there is something that could be left behind.
std::map<std::string, std::string> with_shared_memory() {
  return {{"ROS_DOMAIN_ID", std::to_string(kDomain)}, {"GOALNET_SHARED_MEMORY", "1"}};
}

// Starts a run and waits until the robot is at its first action.
struct Moving {
  Moving()
      : process({testing_support::program("goalnet"), "run", "--goal", "(In Mug_1 Microwave)"},
                with_shared_memory()) {
    EXPECT_TRUE(process.wait_for_text("✓ moveto", std::chrono::seconds(60)));
  }
  Process process;
};

TEST(Interruption, CtrlCStopsWithinASecondAndLeavesNothing) {
  for (const int number : {SIGINT, SIGTERM}) {
    Moving moving;
    const auto used = testing_support::shared_memory_of(moving.process.pid());
    EXPECT_FALSE(used.empty()) << "nothing could be left behind: this test looks in the wrong place";
    testing_support::Slowdown watch;
    moving.process.signal(number);
    const ProcessResult result = moving.process.wait(std::chrono::seconds(100));
    const auto took = watch.undisturbed();
    EXPECT_EQ(result.exit_code, 22) << result.out << result.err;
    EXPECT_LT(took, std::chrono::seconds(1));
    EXPECT_THAT(result.out, HasSubstr("\ncancelled: ")) << "in motion, or while planning one";
    EXPECT_THAT(result.out, testing::Not(HasSubstr("had not come to rest")))
        << "the robot stopped before we left";
    for (const std::string& file : used)
      EXPECT_FALSE(std::filesystem::exists(file)) << file << " is left behind";
  }
}

// As when a terminal is closed, or a connection breaks: the shell and the kernel both tell.
TEST(Interruption, AClosedTerminalStopsTheRobotAsCtrlCDoes) {
  signal(SIGHUP, SIG_DFL);  // under nohup it would be inherited, and obeyed
  Moving moving;
  moving.process.signal(SIGHUP);
  moving.process.signal(SIGHUP);
  const ProcessResult result = moving.process.wait(std::chrono::seconds(100));
  EXPECT_EQ(result.exit_code, 22) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("\ncancelled: "));
}

TEST(Interruption, CtrlCWhileStartingEndsCleanly) {
  Process process({testing_support::program("goalnet"), "run", "open the microwave"}, with_shared_memory());
  for (int i = 0; i < 10'000 && testing_support::shared_memory_of(process.pid()).empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process.signal(SIGINT);
  const ProcessResult result = process.wait(std::chrono::seconds(60));
  EXPECT_EQ(result.exit_code, 22) << result.out << result.err;
  EXPECT_THAT(testing_support::shared_memory_of_domain(kDomain), testing::IsEmpty());
}

}  // namespace
}  // namespace goalnet
