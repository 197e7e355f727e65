#include "tools/goalnet/command.h"

#include <gmock/gmock-matchers.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace goalnet::tools {
namespace {

using testing::HasSubstr;

std::vector<std::string> seen;

int remember(int argc, char** argv) {
  seen.assign(argv, argv + argc);
  return 12;
}

constexpr Command kCommands[] = {{"plan", "solve a problem", remember},
                                 {"bench", "measure", nullptr, "no-such-program"}};

int run(std::vector<std::string> words) {
  words.insert(words.begin(), "goalnet");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return dispatch(kCommands, "usage: goalnet COMMAND\n", static_cast<int>(words.size()), argv.data());
}

TEST(Dispatch, HandsOverTheArgumentsAndReturnsTheCode) {
  EXPECT_EQ(run({"plan", "a.pddl", "--json"}), 12);
  EXPECT_THAT(seen, testing::ElementsAre("goalnet plan", "a.pddl", "--json"));
}

int talk(int, char**) {
  std::puts("a result");
  return 0;
}

// In a process of its own: its standard output is a disk without room.
TEST(Dispatch, OutputThatIsLostIsNoSuccess) {
  const auto on_full_disk = [] {
    if (std::freopen("/dev/full", "w", stdout) == nullptr) std::exit(1);
    constexpr Command kTalking[] = {{"talk", "say something", talk}};
    char program[] = "goalnet", command[] = "talk";
    char* argv[] = {program, command, nullptr};
    std::exit(dispatch(kTalking, "", 2, argv));
  };
  EXPECT_EXIT(on_full_disk(), testing::ExitedWithCode(39), "could not be written: No space left");
}

TEST(Dispatch, HelpListsTheCommandsAndTheExitCodes) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run({"--help"}), 0);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, HasSubstr("plan       solve a problem"));
  EXPECT_THAT(text, HasSubstr("22 cancelled"));
}

TEST(Dispatch, NamesTheNearestCommand) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({"paln"}), 13);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("did you mean \"plan\""));
}

TEST(Dispatch, NothingAskedIsAUsageError) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({}), 13);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--help"));
}

TEST(Dispatch, SaysWhenANeighbourIsMissing) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({"bench"}), 39);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("no-such-program"));
}

}  // namespace
}  // namespace goalnet::tools
