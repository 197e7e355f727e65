#include "tools/goalnet/component_command.h"

#include <atomic>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "components/ros/arguments.h"
#include "components/ros/managed_component.h"
#include "tools/goalnet/component_registry.h"
#include "tools/goalnet/parameter_check.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

void print_help() {
  std::puts(
      "usage: goalnet component NAME [--ros-args …]\n"
      "       goalnet component NAME --show-parameters [--markdown]\n"
      "\n"
      "Runs one component as a managed (lifecycle) ROS 2 node in a process of its own, until Ctrl-C. Start "
      "them in any\n"
      "order. It configures and activates itself, unless -p autostart:=false: then a lifecycle manager or\n"
      "\"ros2 lifecycle set\" does, and a bad parameter, file or model fails configure until \"ros2 param "
      "set\" mends it.\n"
      "Started by itself, it ends with code 13 and says why. Beside a simulator the others need its time:\n"
      "--ros-args -p use_sim_time:=true\n"
      "\n"
      "components:");
  for (const ComponentKind& kind : component_kinds()) {
    std::printf("  %-14.*s %.*s\n", static_cast<int>(kind.name.size()), kind.name.data(),
                static_cast<int>(kind.summary.size()), kind.summary.data());
  }
  std::puts(
      "\n-p NAME:=VALUE sets a parameter, -p NODE:NAME:=VALUE only on the node of that name; a NAME that the "
      "component\n"
      "does not have is refused.\n"
      "\nExamples:\n"
      "  goalnet component planner\n"
      "  goalnet component simulator --ros-args -p scene:=kitchen -p seed:=3\n"
      "  goalnet component executor --ros-args -r __ns:=/robot_1 --params-file robot_1.yaml");
}

int show_parameters(const ComponentKind& kind, bool markdown) {
  const std::string table = kind.parameters(markdown);
  if (markdown) {
    std::fputs(table.c_str(), stdout);
    return 0;
  }
  const std::string name(kind.name);
  std::printf(
      "goalnet component %s [--ros-args -p NAME:=VALUE … --params-file FILE -r FROM:=TO -r __ns:=/NAMESPACE "
      "…]\n"
      "%.*s\n\nparameters:\n%s"
      "every component besides:\n"
      "  autostart (bool, default true)\n      configure and activate at start; set: at start\n"
      "  use_sim_time (bool, default false)\n      follow /clock instead of the wall clock; set: any time\n",
      name.c_str(), static_cast<int>(kind.summary.size()), kind.summary.data(), table.c_str());
  return 0;
}

int refuse(const std::string& message) {
  std::cerr << "goalnet component: " << message << "\n";
  return static_cast<int>(Outcome::kInvalidRequest);
}

// What stands in a file for all nodes may well mean others, so this is no error.
void warn_of_unused(ros::Node& node) {
  for (const std::string& name : node.parameters().unused_overrides())
    node.log().warn("parameter {} is not known to this node", name);
}

int run(const ComponentKind& kind, const ros::Arguments& arguments) {
  ros::ContextOptions context_options;
  if (arguments.enclave) context_options.enclave = *arguments.enclave;
  auto context = ros::Context::create(context_options);
  if (!context) return refuse(context.error().message);
  ros::EventLoop loop;
  std::atomic<ros::ManagedComponent*> running{nullptr};
  StopSignal stop([&] {
    if (ros::ManagedComponent* component = running.load()) component->interrupt();
    loop.stop();
  });
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
  running = component->get();
  if (auto known = check_given_parameters(arguments, {node->get()}, false); !known)
    return refuse(known.error().message);
  warn_of_unused(**node);
  (*node)->log().info("{} is {}", std::string(kind.name),
                      (*component)->active() ? "up" : std::string(ros::label((*component)->state())));
  if (!stop.requested()) loop.run();
  running = nullptr;
  // As a lifecycle manager would: what moves comes to rest, what is written is finished.
  if (auto done = (*component)->shutdown(); !done && (*component)->state() != ros::LifecycleState::kFinalized)
    (*node)->log().warn("shutdown: {}", done.error().message);
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
  const bool markdown = words.size() == 3 && words[2] == "--markdown";
  if (words.size() > 1 && (words[1] == "--help" || words[1] == "-h")) return show_parameters(*kind, false);
  if ((words.size() == 2 || markdown) && words[1] == "--show-parameters")
    return show_parameters(*kind, markdown);
  const auto arguments = ros::parse_arguments({words.begin() + 1, words.end()});
  if (!arguments) return refuse(arguments.error().message);
  if (!arguments->remaining.empty()) {
    return refuse("\"" + arguments->remaining[0].substr(0, 60) +
                  "\" means nothing here; arguments for the node follow --ros-args");
  }
  return run(*kind, *arguments);
}

}  // namespace goalnet::tools
