// The other process of two_process_test: serves /add and the action /fib until it is killed.
#include <cstdlib>
#include <map>

#include "components/ros/action_server.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "example_interfaces/srv/AddTwoInts_service.h"

using namespace goalnet::ros;
using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;

int main(int argc, char** argv) {
  if (argc != 2) return 13;
  auto context = Context::create({.domain_id = std::atoi(argv[1])});
  if (!context) return 39;
  EventLoop loop;
  NodeOptions options;
  options.name = "peer";
  Node node(**context, loop, options);
  Server<AddTwoInts> add(
      node, "/add", [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
  std::vector<std::shared_ptr<GoalHandle<Fibonacci>>> goals;
  std::map<GoalId, int> rounds;
  ActionServer<Fibonacci> fib(node, "/fib",
                              {.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kExecute; },
                               .on_accepted = [&](auto goal) { goals.push_back(std::move(goal)); },
                               .on_cancel = [](auto&) { return true; }});
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
  loop.run();
  return 0;
}
