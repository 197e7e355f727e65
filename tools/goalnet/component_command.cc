#include "tools/goalnet/component_command.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "components/ros/arguments.h"
#include "components/ros/node.h"
#include "tools/goalnet/component_registry.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

void print_help() {
  std::puts(
      "usage: goalnet component NAME [--ros-args …]\n"
      "\n"
      "Runs one component as a ROS 2 node in a process of its own, until Ctrl-C. Start them in any order.\n"
      "Beside a simulator the others need its time: --ros-args -p use_sim_time:=true\n"
      "\n"
      "components:");
  for (const ComponentKind& kind : component_kinds()) {
    std::printf("  %-14.*s %.*s\n", static_cast<int>(kind.name.size()), kind.name.data(),
                static_cast<int>(kind.summary.size()), kind.summary.data());
  }
  std::puts(
      "\nExamples:\n"
      "  goalnet component planner\n"
      "  goalnet component simulator --ros-args -p scene:=kitchen -p seed:=3\n"
      "  goalnet component executor --ros-args -r __ns:=/robot_1 --params-file robot_1.yaml");
}

int refuse(const std::string& message) {
  std::cerr << "goalnet component: " << message << "\n";
  return static_cast<int>(Outcome::kInvalidRequest);
}

int run(const ComponentKind& kind, const ros::Arguments& arguments) {
  ros::ContextOptions context_options;
  if (arguments.enclave) context_options.enclave = *arguments.enclave;
  auto context = ros::Context::create(context_options);
  if (!context) return refuse(context.error().message);
  ros::EventLoop loop;
  StopSignal stop([&loop] { loop.stop(); });
  ros::NodeOptions options;
  options.name = kind.name;
  options.arguments = arguments;
  auto node = ros::Node::create(**context, loop, std::move(options));
  if (!node) return refuse(node.error().message);
  auto component = kind.create(**node);
  if (!component) {
    std::cerr << "goalnet component: " << component.error().message << "\n";
    return static_cast<int>(component.error().outcome);
  }
  (*node)->log().info("{} is up", std::string(kind.name));
  if (!stop.requested()) loop.run();
  return 0;
}

}  // namespace

int component_command(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) {
    print_help();
    return 0;
  }
  if (words.empty() || words[0].starts_with("-"))
    return refuse("which component? \"goalnet component --help\" lists them");
  const ComponentKind* kind = find_component_kind(words[0]);
  if (kind == nullptr) {
    return refuse("there is no component \"" + words[0].substr(0, 60) +
                  "\"; \"goalnet component --help\" lists them");
  }
  const auto arguments = ros::parse_arguments({words.begin() + 1, words.end()});
  if (!arguments) return refuse(arguments.error().message);
  if (!arguments->remaining.empty()) {
    return refuse("\"" + arguments->remaining[0].substr(0, 60) +
                  "\" means nothing here; arguments for the node follow --ros-args");
  }
  return run(*kind, *arguments);
}

}  // namespace goalnet::tools
