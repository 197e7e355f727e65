// goalnet-bench-peer DOMAIN: the other process of `goalnet bench ros`. Echoes, answers and publishes until
// its standard input ends.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "components/ros/service.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "std_msgs/msg/String.h"
#include "tools/bench/ros_peer/plain_echo.h"

int main(int argc, char** argv) {
  using namespace goalnet;
  if (argc != 2) {
    std::fprintf(stderr, "usage: goalnet-bench-peer DOMAIN\n");
    return 13;
  }
  const int domain = std::atoi(argv[1]);
  auto context = ros::Context::create({.domain_id = domain});
  if (!context) {
    std::fprintf(stderr, "goalnet-bench-peer: %s\n", context.error().message.c_str());
    return static_cast<int>(context.error().outcome);
  }
  ros::EventLoop loop;
  ros::NodeOptions options;
  options.name = "bench_peer";
  ros::Node node(**context, loop, options);
  using std_msgs::msg::String;
  auto direct_out = node.advertise<String>("/bench/direct_pong");
  auto direct_in =
      node.subscribe<String>("/bench/direct_ping", ros::Qos::standard(),
                             [&](const String& m) { direct_out->publish(m); }, {.immediate = true});
  auto queued_out = node.advertise<String>("/bench/queued_pong");
  auto queued_in = node.subscribe<String>("/bench/queued_ping", ros::Qos::standard(),
                                          [&](const String& m) { queued_out->publish(m); });
  ros::Server<example_interfaces::srv::AddTwoInts> add(
      node, "/bench/add",
      [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
  auto beat = node.advertise<String>("/bench/beat");
  auto timer = node.create_timer(std::chrono::milliseconds(5), [&] { beat->publish({}); });
  tools::PlainEndpoint* plain = nullptr;
  tools::PlainEndpoint echo(domain, "rt/bench/plain_ping", "rt/bench/plain_pong",
                            [&plain](const std::string& text) { plain->write(text); });
  plain = &echo;
  tools::PlainEndpoint* waiting = nullptr;
  tools::PlainEndpoint waiting_echo(
      domain, "rt/bench/waiting_ping", "rt/bench/waiting_pong",
      [&waiting](const std::string& text) { waiting->write(text); }, tools::Hearing::kWaitSet);
  waiting = &waiting_echo;
  std::jthread until_input_ends([&loop] {
    char byte = 0;
    while (read(0, &byte, 1) > 0) {
    }
    loop.stop();
  });
  loop.run();
  return 0;
}
