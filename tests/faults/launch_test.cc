// `goalnet launch`: processes that die, hang, or never start; and its own end.
#include <gmock/gmock-matchers.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/process.h"

namespace goalnet {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::Process;
using testing_support::ProcessResult;

class Launch : public testing::Test {
 protected:
  ~Launch() override { std::filesystem::remove(file_); }
  std::unique_ptr<Process> start(const std::string& text, std::vector<std::string> more = {"--json"}) {
    std::ofstream(file_) << text;
    more.insert(more.begin(), {testing_support::program("goalnet"), "launch", file_});
    return std::make_unique<Process>(more, std::map<std::string, std::string>{{"ROS_DOMAIN_ID", "87"}});
  }
  // The events so far: "NAME EVENT".
  static std::vector<nlohmann::json> events(const std::string& out) {
    std::vector<nlohmann::json> all;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
      auto one = nlohmann::json::parse(line, nullptr, false);
      if (one.is_object()) all.push_back(std::move(one));
    }
    return all;
  }
  static std::vector<std::string> told(const std::string& out) {
    std::vector<std::string> all;
    for (const auto& one : events(out))
      all.push_back(one["process"].get<std::string>() + " " + one["event"].get<std::string>());
    return all;
  }
  static int pid_of(const Process& launch, const std::string& name) {
    int pid = 0;
    for (const auto& one : events(launch.out())) {
      if (one["process"] == name && one["event"] == "started") pid = one["pid"];
    }
    return pid;
  }
  static bool alive(int pid) { return kill(pid, 0) == 0; }
  const std::string file_ =
      (std::filesystem::temp_directory_path() / ("launch_" + std::to_string(getpid()) + ".yaml")).string();
};

// It has not ended, but it does nothing any more: its event loop no longer answers.
TEST_F(Launch, StartsASilentComponentAgain) {
  const auto launch = start(R"(
restart: {delay: 0.05, silent_after: 3}
processes:
  thinker: {component: planner}
  bystander: {command: [sh, -c, "exec sleep 100"]}
)");
  ASSERT_TRUE(launch->wait_for_text("planner is up", 30s));
  usleep(3'000'000);  // it has been heard
  const int stopped = pid_of(*launch, "thinker");
  ASSERT_GT(stopped, 0);
  EXPECT_THAT(told(launch->out()), ElementsAre("thinker started", "bystander started"))
      << "who answers is left alone";
  kill(stopped, SIGSTOP);
  ASSERT_TRUE(launch->wait_for_text("\"silent\"", 30s));
  for (int i = 0; i < 3000 && pid_of(*launch, "thinker") == stopped; ++i) usleep(10'000);
  const int again = pid_of(*launch, "thinker");
  EXPECT_NE(again, stopped);
  launch->signal(SIGTERM);
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto all = told(result.out);
  ASSERT_GE(all.size(), 6u) << result.out;
  EXPECT_THAT(std::vector<std::string>(all.begin(), all.begin() + 6),
              ElementsAre("thinker started", "bystander started", "thinker silent", "thinker ended",
                          "thinker restarting", "thinker started"));
  EXPECT_EQ(events(result.out)[3]["exit_code"], 137);
  EXPECT_FALSE(alive(stopped));
}

TEST_F(Launch, WhatIsUpAlreadyIsNotStartedTwice) {
  const std::string text = "processes: {thinker: {component: planner}}\n";
  const auto first = start(text);
  ASSERT_TRUE(first->wait_for_text("planner is up", 30s));
  const ProcessResult second = start(text)->wait(20s);
  EXPECT_EQ(second.exit_code, 14) << second.err;
  EXPECT_THAT(second.err, HasSubstr("/thinker is up already"));
  EXPECT_TRUE(told(second.out).empty()) << second.out;
  first->signal(SIGTERM);
  EXPECT_EQ(first->wait(20s).exit_code, 0);
}

TEST_F(Launch, StartsAKilledChildAgainAndEndsAllInOrder) {
  const auto launch = start(R"(
restart: {delay: 0.05}
processes:
  first: {command: [sh, -c, "echo up; exec sleep 100"]}
  second: {command: [sh, -c, "echo up; exec sleep 100"]}
)");
  ASSERT_TRUE(launch->wait_for_text("[second] up", 10s));
  const int killed = pid_of(*launch, "first");
  ASSERT_GT(killed, 0);
  kill(killed, SIGKILL);
  ASSERT_TRUE(launch->wait_for_text("\"restarting\"", 10s));
  for (int i = 0; i < 500 && pid_of(*launch, "first") == killed; ++i) usleep(10'000);
  const int again = pid_of(*launch, "first"), second = pid_of(*launch, "second");
  EXPECT_NE(again, killed);
  launch->signal(SIGTERM);
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(told(result.out), ElementsAre("first started", "second started", "first ended",
                                            "first restarting", "first started", "second stopping",
                                            "second ended", "first stopping", "first ended"));
  EXPECT_EQ(events(result.out)[2]["exit_code"], 137);
  EXPECT_FALSE(alive(again));
  EXPECT_FALSE(alive(second));
}

TEST_F(Launch, GivesUpWhatFailsAgainAndAgain) {
  const auto launch = start(R"(
restart: {delay: 0.01, limit: 2}
processes:
  steady: {command: [sleep, "100"]}
  weak: {command: [sh, -c, "exit 3"]}
)");
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 32);
  EXPECT_THAT(result.err, HasSubstr("weak is lost: ended with code 3"));
  const auto all = told(result.out);
  EXPECT_EQ(std::count(all.begin(), all.end(), "weak started"), 3);
  EXPECT_EQ(all.back(), "steady ended") << "nothing stays behind";
}

TEST_F(Launch, WhatIsNotRequiredMayBeLost) {
  const auto launch = start(R"(
restart: never
processes:
  extra: {command: [sh, -c, "exit 3"], required: false}
  main: {command: [sh, -c, "sleep 0.3"]}
)");
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 0) << "all have ended, and nothing that was required failed";
  EXPECT_THAT(told(result.out), testing::Contains("extra given_up"));
}

TEST_F(Launch, KillsWhatDoesNotEnd) {
  const auto launch = start(R"(
patience: 0.2
processes: {stubborn: {command: [sh, -c, "trap '' TERM; echo deaf; while true; do sleep 1; done"]}}
)");
  ASSERT_TRUE(launch->wait_for_text("started", 10s));
  ASSERT_TRUE(launch->wait_for_text("deaf", 10s));
  const int pid = pid_of(*launch, "stubborn");
  ASSERT_GT(pid, 0);
  launch->signal(SIGINT);
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(told(result.out),
              ElementsAre("stubborn started", "stubborn stopping", "stubborn killed", "stubborn ended"));
  EXPECT_FALSE(alive(pid));
}

TEST_F(Launch, ChildrenDoNotOutliveAKilledLauncher) {
  const auto launch = start("processes: {child: {command: [sleep, '100']}}");
  ASSERT_TRUE(launch->wait_for_text("started", 10s));
  const int pid = pid_of(*launch, "child");
  launch->signal(SIGKILL);
  static_cast<void>(launch->wait(20s));
  for (int i = 0; i < 500 && alive(pid); ++i) usleep(10'000);
  EXPECT_FALSE(alive(pid));
}

TEST_F(Launch, NamesStandBeforeTheOutput) {
  const auto launch = start(R"(
restart: never
processes: {talker: {command: [sh, -c, "echo one; echo two >&2; printf three"]}}
)",
                            {});
  const ProcessResult result = launch->wait(20s);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "[talker] one\n[talker] three\n");
  EXPECT_THAT(result.err, HasSubstr("[talker] two\n"));
  EXPECT_THAT(result.err, HasSubstr("[talker] -- ended with code 0"));
}

TEST_F(Launch, RefusesFilesThatMakeNoSense) {
  const ProcessResult bad = start("processes: {a: {component: planer}}")->wait(20s);
  EXPECT_EQ(bad.exit_code, 13);
  EXPECT_THAT(bad.err, HasSubstr(":1: there is no component 'planer'"));
  const ProcessResult missing = testing_support::run_goalnet({"launch", "/no/such.yaml"}, 87);
  EXPECT_EQ(missing.exit_code, 13);
  EXPECT_THAT(missing.err, HasSubstr("cannot read the launch file /no/such.yaml"));
  const ProcessResult program = start("processes: {a: {command: [no_such_program]}}")->wait(20s);
  EXPECT_EQ(program.exit_code, 13);
  EXPECT_THAT(program.err, HasSubstr("there is no program 'no_such_program' in PATH"));
  // Found and allowed, but no program: the kernel says so when it is started.
  const std::string text_file = file_ + ".txt";
  std::ofstream(text_file) << "\x7f"
                              "ELF and nothing else";
  std::filesystem::permissions(text_file, std::filesystem::perms::owner_all);
  const ProcessResult broken = start("processes: {a: {command: [" + text_file + "]}}")->wait(20s);
  std::filesystem::remove(text_file);
  EXPECT_EQ(broken.exit_code, 32);
  EXPECT_THAT(broken.err, HasSubstr("cannot be started: Exec format error"));
}

}  // namespace
}  // namespace goalnet
