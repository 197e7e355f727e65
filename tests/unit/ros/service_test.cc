// Services between nodes, participants and across a restart of the server.
#include <gtest/gtest.h>

#include "components/ros/detail/cyclone_service.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/service.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "std_srvs/srv/Trigger_service.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::srv::AddTwoInts;
using std_srvs::srv::Trigger;

AddTwoInts::Request sum_of(int a, int b) {
  AddTwoInts::Request request;
  request.a(a);
  request.b(b);
  return request;
}

void add(const AddTwoInts::Request& request, AddTwoInts::Response& response) {
  response.sum(request.a() + request.b());
}

TEST(Service, AnswersInsideAndAcrossParticipants) {
  auto here = make_context(own_domain());
  auto there = make_context(own_domain());
  EventLoop loop;
  Node server_node(*here, loop, plain("server"));
  Server<AddTwoInts> server(server_node, "add", add);
  for (Context* context : {here.get(), there.get()}) {
    Node client_node(*context, loop, plain("client"));
    Client<AddTwoInts> client(client_node, "add");
    ASSERT_TRUE(client.wait_for_service(2s));
    for (int i = 0; i < 500; ++i) {
      const auto response = client.call_and_run(sum_of(i, 1000), 2s);
      ASSERT_TRUE(response) << i << ": " << response.error().message;
      ASSERT_EQ(response->sum(), i + 1000);
    }
  }
}

TEST(Service, ABurstLosesNothingAndAnswersGoToWhoAsked) {
  auto here = make_context(own_domain());
  auto there = make_context(own_domain());
  EventLoop loop;
  Node server_node(*here, loop, plain("server"));
  Node first_node(*there, loop, plain("first"));
  Node second_node(*there, loop, plain("second"));
  Server<AddTwoInts> server(server_node, "add", add);
  Client<AddTwoInts> first(first_node, "add");
  Client<AddTwoInts> second(second_node, "add");
  ASSERT_TRUE(first.wait_for_service(2s));
  ASSERT_TRUE(second.wait_for_service(2s));
  int wrong = 0;
  std::vector<int> answers(400, 0);
  for (int i = 0; i < 400; ++i) {
    auto& client = i % 2 == 0 ? first : second;
    client.call(sum_of(i, i), [&, i](Expected<std::shared_ptr<AddTwoInts::Response>> response) {
      ++answers[i];
      if (!response || (*response)->sum() != 2 * i) ++wrong;
    });
  }
  EXPECT_TRUE(loop.run_for(5s, [&] { return std::count(answers.begin(), answers.end(), 1) == 400; }));
  loop.run_for(50ms);
  EXPECT_EQ(std::count(answers.begin(), answers.end(), 1), 400) << "each call is answered exactly once";
  EXPECT_EQ(wrong, 0);
}

TEST(Service, NoServerIsATimeout) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("client"));
  Client<Trigger> client(node, "nobody");
  EXPECT_FALSE(client.wait_for_service(10ms));
  const auto response = client.call_and_run({}, 50ms);
  ASSERT_FALSE(response);
  EXPECT_EQ(response.error().outcome, Outcome::kTimeLimit);
}

TEST(Service, AServerThatGoesBeforeItAnswersIsTold) {
  auto here = make_context(own_domain()), there = make_context(own_domain());
  EventLoop loop;
  Node client_node(*here, loop, plain("client"));
  Node server_node(*there, loop, plain("server"));
  int asked = 0;
  const auto serve = [&] {
    return Server<Trigger>::deferred(server_node, "later", [&](auto, auto) { ++asked; });
  };
  auto server = serve();
  Client<Trigger> client(client_node, "later");
  ASSERT_TRUE(client.wait_for_service(5s));
  std::optional<Error> error;
  client.call(
      {},
      [&](auto response) {
        if (!response) error = response.error();
      },
      1h);
  ASSERT_TRUE(loop.run_for(5s, [&] { return asked == 1; }));
  loop.run_for(700ms);
  EXPECT_FALSE(error) << error->message << ": a server may take its time";
  server.reset();
  server = serve();  // started again, it knows nothing of what was asked before
  EXPECT_TRUE(loop.run_for(5s, [&] { return error.has_value(); }));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->outcome, Outcome::kComponentLost);
  EXPECT_EQ(asked, 1);
}

TEST(Service, DeferredAnswers) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  std::vector<Responder<Trigger>> kept;
  auto server =
      Server<Trigger>::deferred(node, "later", [&](auto, auto responder) { kept.push_back(responder); });
  Client<Trigger> client(node, "later");
  bool answered = false;
  client.call(
      {}, [&](Expected<std::shared_ptr<Trigger::Response>> response) { answered = response.has_value(); });
  while (loop.run_pending()) {
  }
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_FALSE(answered);
  kept[0].send({});
  while (loop.run_pending()) {
  }
  EXPECT_TRUE(answered);
}

TEST(Service, ClientsSurviveRestartsOfTheServer) {
  auto here = make_context(own_domain());
  EventLoop loop;
  Node client_node(*here, loop, plain("client"));
  Client<AddTwoInts> client(client_node, "add");
  for (int round = 0; round < 10; ++round) {
    {
      auto there = make_context(own_domain());
      Node server_node(*there, loop, plain("server"));
      Server<AddTwoInts> server(server_node, "add", add);
      ASSERT_TRUE(client.wait_for_service(2s)) << round;
      for (int i = 0; i < 20; ++i) {
        const auto response = client.call_and_run(sum_of(round, i), 2s);
        ASSERT_TRUE(response) << round << " " << i << ": " << response.error().message;
        ASSERT_EQ(response->sum(), round + i);
      }
    }
    // The old server's endpoints must be gone before the next round, else the client waits for a ghost.
    ASSERT_TRUE(loop.run_for(2s, [&] { return !client.ready(); })) << round;
  }
}

TEST(Service, ReadsEachRequestInTheFormatOfWhoSentIt) {
  auto context = make_context(own_domain());
  EventLoop loop;
  std::vector<std::pair<std::int64_t, ReplyTo>> calls;
  std::vector<std::string> dropped;
  const auto types = service_types<AddTwoInts>();
  auto server = std::make_shared<ServiceServerBase>(
      loop,
      [&](std::shared_ptr<void> request, const ReplyTo& reply_to) {
        const auto& sum = *std::static_pointer_cast<AddTwoInts::Request>(request);
        calls.emplace_back(sum.a() * 1000 + sum.b(), reply_to);
      },
      [&](const std::string& why) { dropped.push_back(why); });
  ASSERT_TRUE(server->open(context->participant(), "/add", "", types, Qos::services()));
  const AddTwoInts::Request request = sum_of(3, 4);
  const auto payload = detail::encode(idl::type_support<AddTwoInts::Request>(), &request);
  // Only the vendor id of the writer tells them apart; real clients of Cyclone are tried in
  // tests/interoperability.
  SampleInfo info;
  info.id = {{0x01, 0x0f, 9}, 5};
  info.related.writer = {0x01, 0x0f, 9, 9};
  server->on_request(payload, info);
  info.id.writer = {0x01, 0x10, 8};
  server->on_request(detail::with_cyclone_header(payload, {77, 12}), info);
  server->on_request({0, 1, 0, 0, 1, 2, 3}, info);  // too short for a header
  server->on_request(payload, info);                // a header, and no message behind it
  while (loop.run_pending()) {
  }
  ASSERT_EQ(calls.size(), 2u);
  EXPECT_EQ(calls[0].first, 3004);
  EXPECT_EQ(calls[0].second.request, (SampleId{info.related.writer, 5}));
  EXPECT_EQ(calls[1].first, 3004);
  EXPECT_EQ(calls[1].second.request, (SampleId{info.id.writer, 12}));
  EXPECT_EQ(calls[1].second.cyclone_client, 77u);
  EXPECT_EQ(dropped.size(), 1u) << "told once, not for each";
}

}  // namespace
}  // namespace goalnet::ros
