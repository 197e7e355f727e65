// The other process of two_process_test and environment_test.
//   ros_peer serve DOMAIN LOG    serves /add and the action /fib until it is killed; appends each request it
//                                executes to the file LOG: "add A", "goal UUID"
//   ros_peer call DOMAIN         calls /add, 50 calls in flight, until it is killed
//   ros_peer list DOMAIN NAME    is the node /NAME and prints the nodes of others whenever they change
//   ros_peer discovery DOMAIN    is a Fast DDS discovery server on port 11811
#include <fastrtps/utils/IPLocator.h>
#include <fcntl.h>
#include <unistd.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

#include "components/ros/action_server.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "tests/interoperability/goal_id_text.h"

using namespace goalnet::ros;
using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;

namespace {

// Written at once by the kernel: what was executed stays known when this process is killed.
class ExecutionLog {
 public:
  explicit ExecutionLog(const char* path) : file_(open(path, O_WRONLY | O_CREAT | O_APPEND, 0644)) {}
  void add(const std::string& line) {
    if (write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::abort();
  }

 private:
  int file_;
};

void serve(Node& node, const char* path) {
  ExecutionLog log(path);
  Server<AddTwoInts> add(node, "/add", [&](const auto& request, auto& response) {
    log.add("add " + std::to_string(request.a()) + "\n");
    response.sum(request.a() + request.b());
  });
  std::vector<std::shared_ptr<GoalHandle<Fibonacci>>> goals;
  std::map<GoalId, int> rounds;
  ActionServer<Fibonacci>::Callbacks callbacks;
  callbacks.on_goal = [&](const GoalId& id, const auto&) {
    log.add("goal " + to_hex(id) + "\n");  // before the client hears of it
    return GoalResponse::kExecute;
  };
  callbacks.on_accepted = [&](auto goal) { goals.push_back(std::move(goal)); };
  callbacks.on_cancel = [](auto&) { return true; };
  ActionServer<Fibonacci> fib(node, "/fib", std::move(callbacks), {.capacity = 1000});
  auto timer = node.create_timer(std::chrono::milliseconds(1), [&] {
    for (auto& goal : goals) {
      Fibonacci::Result result;
      result.sequence_().push_back(rounds[goal->id()]);
      if (goal->canceling()) {
        goal->canceled(result);
      } else if (++rounds[goal->id()] >= goal->goal().order()) {
        goal->succeed(result);
      }
    }
    std::erase_if(goals, [](const auto& goal) { return !goal->active(); });
  });
  node.loop().run();
}

void call(Node& node) {
  Client<AddTwoInts> add(node, "/add");
  std::function<void()> next = [&] {
    add.call(
        {}, [&](auto) { next(); }, std::chrono::milliseconds(500));
  };
  for (int i = 0; i < 50; ++i) next();
  node.loop().run();
}

void list(Node& node) {
  std::string before;
  auto timer = node.create_timer(std::chrono::milliseconds(20), [&] {
    std::string now = "nodes:";
    for (const std::string& name : node.context().other_nodes()) now += " " + name;
    if (now == before) return;
    std::printf("%s.\n", now.c_str());
    std::fflush(stdout);
    before = now;
  });
  node.loop().run();
}

int discovery_server(int domain) {
  namespace rtps = eprosima::fastrtps::rtps;
  auto qos = eprosima::fastdds::dds::PARTICIPANT_QOS_DEFAULT;
  auto& builtin = qos.wire_protocol().builtin;
  builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol::SERVER;
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = 11811;
  rtps::IPLocator::setIPv4(locator, 0, 0, 0, 0);
  builtin.metatrafficUnicastLocatorList.push_back(locator);
  // The GUID that ROS_DISCOVERY_SERVER presumes for the first server of its list.
  rtps::GuidPrefix_t prefix;
  std::istringstream("44.53.00.5f.45.50.52.4f.53.49.4d.41") >> prefix;
  qos.wire_protocol().prefix = prefix;
  auto* participant =
      eprosima::fastdds::dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
  if (participant == nullptr) return 39;
  std::printf("serving\n");
  std::fflush(stdout);
  while (true) pause();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 13;
  const std::string mode = argv[1];
  const int domain = std::atoi(argv[2]);
  if (mode == "discovery") return discovery_server(domain);
  auto context = Context::create({.domain_id = domain});
  if (!context) {
    std::fprintf(stderr, "ros_peer: %s\n", context.error().message.c_str());
    return 39;
  }
  EventLoop loop;
  NodeOptions options;
  options.name = mode == "list" && argc > 3 ? argv[3] : "peer";
  Node node(**context, loop, options);
  if (mode == "serve") serve(node, argc > 3 ? argv[3] : "/dev/null");
  if (mode == "call") call(node);
  if (mode == "list") list(node);
  return 0;
}
