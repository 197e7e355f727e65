// A server of ours among clients of all kinds that come, go and are killed, and that is killed itself now and
// then. A few seconds in the suite; GOALNET_SOAK_MINUTES=20 soaks it. Prints what became of everything.
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <fstream>
#include <list>
#include <random>

#include "components/ros/action_client.h"
#include "components/ros/service.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;
using testing_support::Process;
using SteadyClock = std::chrono::steady_clock;

const int kDomain = own_domain();

std::chrono::nanoseconds length() {
  const char* minutes = std::getenv("GOALNET_SOAK_MINUTES");
  return minutes == nullptr ? std::chrono::nanoseconds(6s)
                            : std::chrono::nanoseconds(std::int64_t(std::atof(minutes) * 60e9));
}

// What became of the things of one kind. Those that the server died under are nobody's loss.
struct Tally {
  int begun = 0, answered = 0, killed = 0, server_died = 0, lost = 0;
  int not_started = 0;  // tools whose port somebody else had taken
  std::string faults;   // of the first few that were lost
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  return out << tally.begun << " begun, " << tally.answered << " answered, " << tally.killed << " killed, "
             << tally.server_died << " by a server that died, " << tally.not_started << " not started, "
             << tally.lost << " lost" << tally.faults;
}

class Soak : public testing::Test {
 protected:
  std::unique_ptr<Context> context = make_context(kDomain);
  EventLoop loop;
  Node node{*context, loop, plain("soak")};
  Client<AddTwoInts> add{node, "/add"};
  ActionClient<Fibonacci> fib{node, "/fib"};
  std::mt19937 random{3};
  std::string log = testing::TempDir() + "/goalnet_soak_" + std::to_string(getpid());
  std::unique_ptr<Process> server;
  int servers = 0;  // how many there have been
  std::int64_t number = 1'000'000;
  Tally calls, goals, fast_dds, cyclone_dds;

  void TearDown() override { std::remove(log.c_str()); }

  bool chance(int in_a_hundred) { return static_cast<int>(random() % 100) < in_a_hundred; }
  std::unique_ptr<Process> start(std::vector<std::string> words) {
    words[0] = testing_support::program(words[0]);
    return std::make_unique<Process>(words, std::map<std::string, std::string>{{"RMW_TOOL_UDP_ONLY", "1"}});
  }

  // Kills the server, if there is one, and starts another; returns once that one has answered a call.
  void new_server() {
    if (server) server->signal(SIGKILL);
    server = start({"ros_peer", "serve", std::to_string(kDomain), log});
    ++servers;
    bool answered = false;
    for (int tries = 0; tries < 200 && !answered; ++tries) {
      bool ended = false;
      call_add(100ms, [&](bool good) {
        answered = answered || good;
        ended = true;
      });
      loop.run_for(1s, [&] { return ended; });
    }
    ASSERT_TRUE(answered) << "server " << servers;
  }

  void call_add(std::chrono::nanoseconds timeout, std::function<void(bool)> then) {
    AddTwoInts::Request request;
    request.a(++number);
    request.b(1);
    add.call(
        request,
        [expected = number + 1, then = std::move(then)](auto response) {
          then(response && (*response)->sum() == expected);
        },
        timeout);
  }

  void count(Tally& tally, bool good, int of_server, const std::string& fault = "") {
    if (good) {
      ++tally.answered;
    } else if (of_server != servers) {
      ++tally.server_died;
    } else if (++tally.lost <= 5) {
      tally.faults += "; " + fault.substr(0, 200);
    }
  }

  int open_calls = 0, open_goals = 0;

  // Seldom: every client hears the replies to all of them, and keeps ten that it has not looked at.
  void call_now_and_then() {
    if (open_calls >= 3 || !chance(2)) return;
    ++calls.begun;
    ++open_calls;
    call_add(10s, [this, of = servers](bool good) {
      --open_calls;
      count(calls, good, of, "a call");
    });
  }

  void send_a_goal_now_and_then() {
    if (open_goals >= 3 || !chance(5)) return;
    ++goals.begun;
    ++open_goals;
    Fibonacci::Goal goal;
    goal.order(1 + static_cast<int>(random() % 20));
    ActionClient<Fibonacci>::GoalCallbacks callbacks;
    // Ends once: refused, or with its result.
    auto ended = [this, of = servers, open = std::make_shared<bool>(true)](bool good, const char* fault) {
      if (!*open) return count(goals, false, of, "ended twice");
      *open = false;
      --open_goals;
      count(goals, good, of, fault);
    };
    callbacks.on_response = [ended](bool accepted) {
      if (!accepted) ended(false, "not accepted");
    };
    callbacks.on_result = [ended](auto result) {
      if (!result && result.error().message.find("send_goal") != std::string::npos) return;  // told above
      ended(result && (result->first == GoalState::kSucceeded || result->first == GoalState::kCanceled),
            "without its result");
    };
    const GoalId id = fib.send(goal, std::move(callbacks), 10s, 10s);
    if (chance(50)) fib.cancel(id);
  }

  // One tool after the other, as people type them; some are killed at a moment of their lives.
  struct Tools {
    Tally& tally;
    std::function<std::vector<std::string>()> words;
    std::function<bool(const std::string& out)> good;
    std::unique_ptr<Process> now = {};
    int of_server = 0;
    bool killed = false;
    SteadyClock::time_point started = {}, kill_at = {};
  };

  void look_after(Tools& tools) {
    if (tools.now == nullptr) {
      ++tools.tally.begun;
      tools.now = start(tools.words());
      tools.of_server = servers;
      tools.started = SteadyClock::now();
      tools.killed = chance(20);
      tools.kill_at = tools.started + std::chrono::milliseconds(random() % 150);
    } else if (tools.now->ended()) {
      const auto result = tools.now->wait(0ms);
      tools.now.reset();
      if (tools.killed && result.exit_code == 128 + SIGKILL) {
        ++tools.tally.killed;
      } else if (result.err.find("address in use") != std::string::npos) {
        ++tools.tally.not_started;
      } else {
        count(tools.tally, result.exit_code == 0 && tools.good(result.out), tools.of_server,
              std::to_string(result.exit_code) + " " + result.out + result.err);
      }
    } else if ((tools.killed && SteadyClock::now() >= tools.kill_at) ||
               SteadyClock::now() > tools.started + 30s) {
      tools.now->signal(SIGKILL);  // the latter is stuck: counted as lost
    }
  }

  // Lines of the server's log that are there twice: a request of ours or of a Fast DDS tool that was executed
  // twice.
  int executed_twice() const {
    std::map<std::string, int> counts;
    std::ifstream file(log);
    for (std::string line; std::getline(file, line);) {
      if (line.size() > std::string("add 999999").size()) ++counts[line];
    }
    return static_cast<int>(
        std::count_if(counts.begin(), counts.end(), [](const auto& one) { return one.second > 1; }));
  }
};

TEST_F(Soak, NobodyIsLeftWithoutAnAnswer) {
  const auto end = SteadyClock::now() + length();
  const auto between_deaths = std::min<std::chrono::nanoseconds>(length() / 3, 20s);
  std::int64_t asked = 0;
  Tools fast{.tally = fast_dds,
             .words =
                 [&] {
                   asked = ++number;
                   return std::vector<std::string>{
                       "rmw_tool", "call", std::to_string(kDomain), "/add", std::to_string(asked), "5"};
                 },
             .good =
                 [&](const std::string& out) {
                   return out.find("\n" + std::to_string(asked + 5) + "\n") != std::string::npos;
                 }};
  Tools cyclone{
      .tally = cyclone_dds,
      .words =
          [] {
            return std::vector<std::string>{"cyclone_services", "call", std::to_string(kDomain), "2"};
          },
      .good = [](const std::string& out) { return out == "sum 1001\nsum 1002\n"; }};
  while (SteadyClock::now() < end) {
    ASSERT_NO_FATAL_FAILURE(new_server());
    const auto dies = std::min(SteadyClock::now() + between_deaths, end);
    while (SteadyClock::now() < dies) {
      look_after(fast);
      look_after(cyclone);
      call_now_and_then();
      send_a_goal_now_and_then();
      loop.run_for(1ms);
      ASSERT_FALSE(server->ended()) << server->err();
    }
  }
  // The last ones.
  fast.killed = cyclone.killed = false;
  loop.run_for(12s, [&] {
    for (Tools* tools : {&fast, &cyclone}) {
      if (tools->now) look_after(*tools);
    }
    return !fast.now && !cyclone.now && open_calls == 0 && open_goals == 0;
  });
  std::cout << servers << " servers\ncalls: " << calls << "\ngoals: " << goals
            << "\nFast DDS tools: " << fast_dds << "\nCyclone DDS tools: " << cyclone_dds << "\n";
  for (const Tally* tally : {&calls, &goals, &fast_dds, &cyclone_dds}) {
    EXPECT_EQ(tally->lost, 0) << *tally;
    EXPECT_GT(tally->answered, 3);
    EXPECT_EQ(tally->begun,
              tally->answered + tally->killed + tally->server_died + tally->not_started + tally->lost);
  }
  EXPECT_EQ(executed_twice(), 0);
}

}  // namespace
}  // namespace goalnet::ros
