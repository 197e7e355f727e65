// Fast DDS 2.9 aborts on its own (OutputTrafficManager.hpp, an assertion) when several Cyclone DDS peers that
// announce a shared multicast address and separate ports for discovery and data start together. Here the same
// plain Fast DDS program meets such peers twice: with its default configuration it dies, with ours it lives.
#include <fastrtps/config.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <memory>
#include <vector>

#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing_support::Process;

const int kDomain = own_domain();
constexpr int kMostRoundsToAbort = 20;
constexpr bool kAborts = FASTRTPS_VERSION_MAJOR == 2 && FASTRTPS_VERSION_MINOR < 10;

std::unique_ptr<Process> start(const std::string& program, const std::string& mode,
                               const std::string& seconds) {
  const std::map<std::string, std::string> environment = {{"CYCLONEDDS_URI", kCycloneWithSeparatePorts}};
  return std::make_unique<Process>(
      std::vector<std::string>{testing_support::program(program), mode, std::to_string(kDomain), seconds},
      environment);
}

// Rounds that the plain program lived through, of at most `rounds`.
int rounds_survived(const std::string& configuration, int rounds) {
  auto plain = start("plain_writer", configuration, "600");
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::unique_ptr<Process>> peers;
    for (int i = 0; i < 3; ++i) peers.push_back(start("cyclone_peer", "churn", "0.8"));
    for (auto& one : peers) EXPECT_TRUE(one->wait_for_text("ready", 10s));  // they overlap on any machine
    for (auto& one : peers) EXPECT_EQ(one->wait(10s).exit_code, 0);
    if (plain->wait_for_text("OutputTrafficManager", 0ms)) {
      EXPECT_EQ(plain->wait(5s).exit_code, 128 + SIGABRT);
      return round;
    }
  }
  EXPECT_EQ(kill(plain->pid(), 0), 0) << plain->err();
  return rounds;
}

TEST(FastDdsAbort, OursSurvivesWhatKillsTheDefault) {
  const int died_after = rounds_survived("default", kMostRoundsToAbort);
  if (kAborts) {
    EXPECT_LT(died_after, kMostRoundsToAbort)
        << "the peers no longer provoke the abort: this test proves nothing";
  }
  const int wanted = std::max(5 * (died_after + 1), 12);
  EXPECT_EQ(rounds_survived("ours", wanted), wanted);
  RecordProperty("default_died_after_rounds", died_after);
}

}  // namespace
}  // namespace goalnet::ros
