// Fast DDS 2.9 ends the process (PDP.cpp, an assertion) when a participant elsewhere leaves just while its
// lease is checked (docs/design/075). Participants that leave when their lease ends, one after the other,
// meet Fast DDS as it comes, which dies, and then components/ros, in this process, which lives.
#include <fastrtps/config.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <thread>

#include "components/ros/detail/lease_checks.h"
#include "tests/support/process.h"
#include "tests/unit/ros/fake_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing_support::Process;

const int kDomain = own_domain();
constexpr int kMostRoundsToAbort = 20'000;
constexpr bool kAborts = FASTRTPS_VERSION_MAJOR == 2 && FASTRTPS_VERSION_MINOR == 9;

// Two that come and go by turns. Each goes about when its lease ends, and just when the other has come, so
// that the lock which the check of its lease needs is in use.
class Visitors {
 public:
  Visitors() {
    for (FakeParticipant* peer : {here_, away_}) peer->set_lease(1ms);
  }
  void take_turns() {
    away_->rename();
    away_->announce();
    here_->leave();
    std::swap(here_, away_);
    std::this_thread::sleep_for(950us);
  }
  bool were_met() { return !here_->received().empty(); }

 private:
  FakeParticipant first_{kDomain, 1}, second_{kDomain, 2};
  FakeParticipant *here_ = &first_, *away_ = &second_;
};

int rounds_until_death_of_plain() {
  Process plain({testing_support::program("plain_participant"), std::to_string(kDomain)}, {});
  EXPECT_TRUE(plain.wait_for_text("up", 20s));
  Visitors visitors;
  int round = 0;
  for (; round < kMostRoundsToAbort && !plain.ended(); ++round) visitors.take_turns();
  if (!plain.ended()) return round;
  EXPECT_EQ(plain.wait(5s).exit_code, 128 + SIGABRT);
  EXPECT_TRUE(plain.wait_for_text("check_remote_participant_liveliness", 0ms)) << plain.err();
  return round;
}

TEST(LeaseChecks, OursStandBeforeThoseOfFastDds) { EXPECT_TRUE(detail::lease_checks_are_ours()); }

TEST(LeaseChecks, OursSurviveWhatEndsTheDefault) {
  const int died_after = rounds_until_death_of_plain();
  if (kAborts) {
    EXPECT_LT(died_after, kMostRoundsToAbort)
        << "these participants no longer provoke the abort: this test proves nothing";
  }
  RecordProperty("plain_died_after_rounds", died_after);

  auto context = make_context(kDomain);
  Visitors visitors;
  for (int round = 0; round < std::clamp(5 * died_after, 2000, 20'000); ++round) visitors.take_turns();
  EXPECT_TRUE(visitors.were_met());
}

}  // namespace
}  // namespace goalnet::ros
