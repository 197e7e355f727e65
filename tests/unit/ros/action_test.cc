// Actions: states, the four rules of cancelling, results, feedback, over real DDS.
#include "components/ros/action_server.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <random>

#include "components/ros/action_client.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;

GoalId id(std::uint8_t n) {
  GoalId id{};
  id[0] = n;
  return id;
}

std::vector<int> named(const ActionGoals::Selection& selection) {
  std::vector<int> names;
  for (const auto& goal : selection.goals) names.push_back(goal.id[0]);
  return names;
}

TEST(ActionGoals, CancelFollowsTheFourRules) {
  ActionGoals goals(1s, 10);
  for (std::uint8_t n = 1; n <= 5; ++n) {
    ASSERT_TRUE(goals.accept(id(n), Time(n * 100)));
    ASSERT_TRUE(goals.set(id(n), GoalState::kExecuting, Time(n * 100)));
  }
  ASSERT_TRUE(goals.set(id(2), GoalState::kSucceeded, Time(600)));
  using testing::ElementsAre;
  EXPECT_THAT(named(goals.select_for_cancel({}, Time(0))), ElementsAre(1, 3, 4, 5)) << "all";
  EXPECT_THAT(named(goals.select_for_cancel({}, Time(300))), ElementsAre(1, 3)) << "accepted at or before";
  EXPECT_THAT(named(goals.select_for_cancel(id(4), Time(0))), ElementsAre(4)) << "that one";
  EXPECT_THAT(named(goals.select_for_cancel(id(4), Time(300))), ElementsAre(1, 3, 4))
      << "that one and those before";
  EXPECT_EQ(goals.select_for_cancel(id(9), Time(0)).code, CancelCode::kUnknownGoal);
  EXPECT_EQ(goals.select_for_cancel(id(2), Time(0)).code, CancelCode::kTerminated);
  EXPECT_EQ(goals.select_for_cancel({}, Time(50)).code, CancelCode::kNone);
}

// The rules of CancelGoal.srv and rcl's practice, written down a second time and independently: for thousands
// of random servers and requests both must select the same goals and answer the same code.
TEST(ActionGoals, CancelEqualsAnIndependentModelOnRandomCases) {
  using S = GoalState;
  std::mt19937 random(11);
  const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int cancels = 0, unknown = 0, terminated = 0;
  for (int round = 0; round < 5000; ++round) {
    ActionGoals goals(1h, 100);
    struct Known {
      int name;
      std::int64_t accepted;
      S state;
    };
    std::vector<Known> known;
    const int count = any(8);
    std::int64_t now = 1;
    for (int i = 0; i < count; ++i) {
      now += any(3);
      const int name = 1 + i;
      ASSERT_TRUE(goals.accept(id(static_cast<std::uint8_t>(name)), Time(now)));
      // Walk to a random state on an allowed path.
      static const std::vector<std::vector<S>> kPaths = {{},
                                                         {S::kExecuting},
                                                         {S::kCanceling},
                                                         {S::kExecuting, S::kCanceling},
                                                         {S::kExecuting, S::kSucceeded},
                                                         {S::kExecuting, S::kAborted},
                                                         {S::kCanceling, S::kCanceled}};
      const auto& path = kPaths[static_cast<std::size_t>(any(7))];
      for (const S state : path)
        ASSERT_TRUE(goals.set(id(static_cast<std::uint8_t>(name)), state, Time(now)));
      known.push_back({name, now, path.empty() ? S::kAccepted : path.back()});
    }
    const int asked = any(11);  // 0: no id; above `count`: an unknown one
    const std::int64_t stamp = any(2) == 0 ? 0 : 1 + any(20);

    std::vector<int> expected;
    CancelCode code = CancelCode::kNone;
    for (const Known& goal : known) {
      const bool cancelable = goal.state == S::kAccepted || goal.state == S::kExecuting;
      bool meant = false;
      if (asked == 0 && stamp == 0) meant = true;                    // all goals
      if (asked == 0 && stamp != 0) meant = goal.accepted <= stamp;  // all up to a time
      if (asked != 0 && stamp == 0) meant = goal.name == asked;      // this one
      if (asked != 0 && stamp != 0) meant = goal.name == asked || goal.accepted <= stamp;
      if (meant && cancelable) expected.push_back(goal.name);
    }
    if (asked != 0 && stamp == 0) {
      if (asked > count) code = CancelCode::kUnknownGoal;
      if (asked <= count && expected.empty()) code = CancelCode::kTerminated;
    }
    const auto selection =
        goals.select_for_cancel(asked == 0 ? GoalId{} : id(static_cast<std::uint8_t>(asked)), Time(stamp));
    ASSERT_EQ(named(selection), expected) << "round " << round;
    ASSERT_EQ(selection.code, code) << "round " << round;
    cancels += expected.empty() ? 0 : 1;
    unknown += code == CancelCode::kUnknownGoal;
    terminated += code == CancelCode::kTerminated;
  }
  EXPECT_GT(cancels, 1000);
  EXPECT_GT(unknown, 200);
  EXPECT_GT(terminated, 200);
}

TEST(ActionGoals, OnlyAllowedChanges) {
  EXPECT_TRUE(allowed(GoalState::kAccepted, GoalState::kExecuting));
  EXPECT_TRUE(allowed(GoalState::kExecuting, GoalState::kCanceling));
  EXPECT_TRUE(allowed(GoalState::kCanceling, GoalState::kCanceled));
  EXPECT_TRUE(allowed(GoalState::kCanceling, GoalState::kSucceeded));
  EXPECT_FALSE(allowed(GoalState::kExecuting, GoalState::kCanceled)) << "must pass through CANCELING";
  EXPECT_FALSE(allowed(GoalState::kSucceeded, GoalState::kAborted));
  EXPECT_FALSE(allowed(GoalState::kCanceling, GoalState::kExecuting));
}

TEST(ActionGoals, CapacityAndExpiry) {
  ActionGoals goals(10s, 2);
  ASSERT_TRUE(goals.accept(id(1), Time(0)));
  EXPECT_FALSE(goals.accept(id(1), Time(0))) << "taken";
  ASSERT_TRUE(goals.accept(id(2), Time(0)));
  EXPECT_FALSE(goals.accept(id(3), Time(0))) << "full of unfinished goals";
  goals.set(id(1), GoalState::kExecuting, Time(0));
  goals.set(id(1), GoalState::kAborted, Time(5));
  EXPECT_TRUE(goals.accept(id(3), Time(0))) << "the finished one makes room";
  EXPECT_FALSE(goals.state(id(1)));
  goals.set(id(2), GoalState::kExecuting, Time(0));
  goals.set(id(2), GoalState::kSucceeded, Time(1'000'000'000));
  EXPECT_TRUE(goals.expire(Time(10'000'000'000)).empty());
  EXPECT_THAT(goals.expire(Time(11'000'000'000)), testing::ElementsAre(id(2)));
}

// Works on one goal at a time; the order is how many loop rounds it takes.
struct Worker {
  Worker(Node& node, const std::string& name)
      : server(node, name,
               {.on_goal =
                    [](const GoalId&, const Fibonacci::Goal& goal) {
                      return goal.order() < 0 ? GoalResponse::kReject : GoalResponse::kExecute;
                    },
                .on_accepted = [this](auto goal) { goals.push_back(std::move(goal)); },
                .on_cancel = [](auto&) { return true; }}),
        timer(node.create_timer(1ms, [this] { work(); })) {}

  void work() {
    for (auto& goal : goals) {
      Fibonacci::Result result;
      result.sequence_(progress[goal->id()]);
      if (goal->canceling()) {
        goal->canceled(result);
        continue;
      }
      auto& numbers = progress[goal->id()];
      numbers.push_back(static_cast<int>(numbers.size()));
      Fibonacci::Feedback feedback;
      feedback.sequence_(numbers);
      goal->publish_feedback(feedback);
      result.sequence_(numbers);
      if (static_cast<int>(numbers.size()) >= goal->goal().order()) goal->succeed(result);
    }
    std::erase_if(goals, [](const auto& goal) { return !goal->active(); });
  }

  std::map<GoalId, std::vector<int>> progress;
  std::vector<std::shared_ptr<GoalHandle<Fibonacci>>> goals;
  ActionServer<Fibonacci> server;
  std::shared_ptr<Timer> timer;
};

Fibonacci::Goal order(int n) {
  Fibonacci::Goal goal;
  goal.order(n);
  return goal;
}

TEST(Action, FeedbackResultRejectionAndCancel) {
  auto here = make_context(own_domain());
  auto there = make_context(own_domain());
  EventLoop loop;
  Node server_node(*here, loop, plain("server"));
  Node client_node(*there, loop, plain("client"));
  Worker worker(server_node, "fib");
  ActionClient<Fibonacci> client(client_node, "fib");
  ASSERT_TRUE(client.wait_for_server(2s));

  std::size_t feedbacks = 0;
  std::optional<std::pair<GoalState, Fibonacci::Result>> done;
  client.send(order(5), {.on_response = [](bool accepted) { EXPECT_TRUE(accepted); },
                         .on_feedback = [&](const Fibonacci::Feedback&) { ++feedbacks; },
                         .on_result = [&](auto result) { done = *result; }});
  ASSERT_TRUE(loop.run_for(2s, [&] { return done.has_value(); }));
  EXPECT_EQ(done->first, GoalState::kSucceeded);
  EXPECT_THAT(done->second.sequence_(), testing::ElementsAre(0, 1, 2, 3, 4));
  EXPECT_GE(feedbacks, 4u);

  std::optional<bool> accepted;
  client.send(order(-1),
              {.on_response = [&](bool yes) { accepted = yes; }, .on_feedback = {}, .on_result = {}});
  ASSERT_TRUE(loop.run_for(2s, [&] { return accepted.has_value(); }));
  EXPECT_FALSE(*accepted);

  done.reset();
  std::optional<CancelCode> code;
  const GoalId goal =
      client.send(order(1'000'000),
                  {.on_response = {}, .on_feedback = {}, .on_result = [&](auto result) { done = *result; }});
  loop.run_for(20ms);
  client.cancel(goal, [&](Expected<CancelCode> answer) { code = *answer; });
  ASSERT_TRUE(loop.run_for(2s, [&] { return done.has_value() && code.has_value(); }));
  EXPECT_EQ(*code, CancelCode::kNone);
  EXPECT_EQ(done->first, GoalState::kCanceled);
  client.cancel(goal, [&](Expected<CancelCode> answer) { code = *answer; });
  ASSERT_TRUE(loop.run_for(2s, [&] { return *code != CancelCode::kNone; }));
  EXPECT_EQ(*code, CancelCode::kTerminated);
}

TEST(Action, TwoHundredGoalsWithRandomCancels) {
  auto here = make_context(own_domain());
  auto there = make_context(own_domain());
  EventLoop loop;
  Node server_node(*here, loop, plain("server"));
  Node client_node(*there, loop, plain("client"));
  Worker worker(server_node, "fib");
  ActionClient<Fibonacci> client(client_node, "fib");
  ASSERT_TRUE(client.wait_for_server(2s));
  std::mt19937 random(7);
  std::map<GoalState, int> ends;
  int results = 0;
  int duplicates = 0;
  for (int i = 0; i < 200; ++i) {
    auto count = std::make_shared<int>(0);
    const GoalId goal =
        client.send(order(1 + static_cast<int>(random() % 30)),
                    {.on_response = {}, .on_feedback = {}, .on_result = [&, count](auto result) {
                       ASSERT_TRUE(result);
                       ++results;
                       if (++*count > 1) ++duplicates;
                       ++ends[result->first];
                     }});
    loop.run_for(std::chrono::microseconds(random() % 3000));
    if (random() % 2 == 0) client.cancel(goal);
  }
  EXPECT_TRUE(loop.run_for(5s, [&] { return results == 200; })) << results;
  EXPECT_EQ(duplicates, 0);
  EXPECT_EQ(ends[GoalState::kSucceeded] + ends[GoalState::kCanceled], 200);
  EXPECT_GT(ends[GoalState::kCanceled], 20);
  EXPECT_GT(ends[GoalState::kSucceeded], 20);
}

// Over DDS: what a server answers to a cancel request, where it takes some of the goals and refuses others.
TEST(Action, CancelAnswersListWhatWasTakenAndRejectWhereNothingWas) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  std::vector<std::shared_ptr<GoalHandle<Fibonacci>>> handles;
  ActionServer<Fibonacci> server(
      node, "fib",
      {.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kExecute; },
       .on_accepted = [&](auto goal) { handles.push_back(std::move(goal)); },
       .on_cancel = [](auto& goal) { return goal.goal().order() % 2 == 0; }});
  ActionClient<Fibonacci> client(node, "fib");
  Client<action_msgs::srv::CancelGoal> cancel(node, "/fib/_action/cancel_goal");
  std::map<GoalId, std::vector<GoalState>> told;
  for (int n = 1; n <= 4; ++n) {
    auto mine = std::make_shared<GoalId>();
    *mine = client.send(order(n), {.on_response = {},
                                   .on_feedback = {},
                                   .on_result = {},
                                   .on_status = [&told, mine](GoalState s) { told[*mine].push_back(s); }});
  }
  ASSERT_TRUE(loop.run_for(2s, [&] { return handles.size() == 4; }));
  const auto taken = [&](const GoalId& which) {
    action_msgs::srv::CancelGoal::Request request;
    request.goal_info().goal_id().uuid(which);
    const auto answer = cancel.call_and_run(request, 2s).value();
    std::vector<int> orders;
    for (const auto& one : answer.goals_canceling()) {
      for (const auto& handle : handles) {
        if (handle->id() == one.goal_id().uuid()) orders.push_back(handle->goal().order());
      }
    }
    return std::pair(static_cast<CancelCode>(answer.return_code()), orders);
  };
  using testing::ElementsAre;
  EXPECT_EQ(taken(handles[0]->id()), std::pair(CancelCode::kRejected, std::vector<int>{}));
  EXPECT_EQ(taken({}), std::pair(CancelCode::kNone, std::vector<int>{2, 4}));
  EXPECT_EQ(taken(handles[1]->id()), std::pair(CancelCode::kTerminated, std::vector<int>{}))
      << "is being cancelled";
  EXPECT_EQ(taken({}), std::pair(CancelCode::kRejected, std::vector<int>{})) << "1 and 3 refuse";
  ASSERT_TRUE(handles[1]->canceled({}));
  ASSERT_TRUE(loop.run_for(2s, [&] {
    const auto& states = told[handles[1]->id()];
    return !states.empty() && states.back() == GoalState::kCanceled;
  })) << "the status topic tells the client";
}

TEST(Action, ResultsAreKeptForTheirTimeAndThenForgotten) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  ActionServer<Fibonacci> server(
      node, "fib",
      {.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kExecute; },
       .on_accepted = [](auto goal) { goal->succeed({}); },
       .on_cancel = {}},
      {.result_timeout = 1500ms});
  ActionClient<Fibonacci> client(node, "fib");
  Client<Fibonacci::GetResult> get_result(node, "/fib/_action/get_result");
  bool done = false;
  const GoalId goal =
      client.send(order(1), {.on_response = {}, .on_feedback = {}, .on_result = [&](auto) { done = true; }});
  ASSERT_TRUE(loop.run_for(2s, [&] { return done; }));
  Fibonacci::GetResult::Request request;
  request.goal_id().uuid(goal);
  EXPECT_EQ(get_result.call_and_run(request, 2s)->status(), 4) << "kept";
  loop.run_for(3s);
  EXPECT_EQ(get_result.call_and_run(request, 2s)->status(), 0) << "forgotten: unknown";
}

TEST(Action, AGoalThatHasNoRoomIsNotBegun) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  int begun = 0;
  std::vector<std::shared_ptr<GoalHandle<Fibonacci>>> goals;
  ActionServer<Fibonacci> server(node, "fib",
                                 {.on_goal =
                                      [&](const GoalId&, const auto&) {
                                        ++begun;
                                        return GoalResponse::kExecute;
                                      },
                                  .on_accepted = [&](auto goal) { goals.push_back(std::move(goal)); },
                                  .on_cancel = {}},
                                 {.capacity = 1});
  ActionClient<Fibonacci> client(node, "fib");
  std::vector<bool> accepted;
  for (int i = 0; i < 2; ++i)
    client.send(
        order(1),
        {.on_response = [&](bool yes) { accepted.push_back(yes); }, .on_feedback = {}, .on_result = {}});
  ASSERT_TRUE(loop.run_for(2s, [&] { return accepted.size() == 2; }));
  EXPECT_THAT(accepted, testing::ElementsAre(true, false));
  EXPECT_EQ(begun, 1);
}

TEST(Action, ADroppedHandleAbortsItsGoal) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  ActionServer<Fibonacci> server(node, "fib",
                                 {.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kDefer; },
                                  .on_accepted = [](auto) {},
                                  .on_cancel = {}});
  ActionClient<Fibonacci> client(node, "fib");
  std::optional<GoalState> end;
  client.send(order(1),
              {.on_response = {}, .on_feedback = {}, .on_result = [&](auto result) { end = result->first; }});
  ASSERT_TRUE(loop.run_for(1s, [&] { return end.has_value(); }));
  EXPECT_EQ(*end, GoalState::kAborted);
}

}  // namespace
}  // namespace goalnet::ros
