#include "tools/goalnet/record_command.h"

#include <iostream>

#include "components/ros/arguments.h"
#include "components/ros/bag/bag_repair.h"
#include "components/ros/node.h"
#include "tools/goalnet/record_options.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

int refuse_record(const Error& error) {
  std::cerr << "goalnet record: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

int repair(const ParsedRecord& parsed, ros::Distro distro) {
  const auto bag = ros::repair_bag(parsed.repair, distro);
  if (!bag) return refuse_record(bag.error());
  std::cerr << parsed.repair << " is whole: " << bag->message_count() << " messages of " << bag->topics.size()
            << " topics in " << bag->files.size() << " file(s)\n";
  return 0;
}

}  // namespace

int record_command(int argc, char** argv) {
  auto parsed = parse_record_options(argc, argv);
  if (!parsed) return refuse_record(parsed.error());
  if (parsed->help_shown) return 0;
  const auto arguments = ros::parse_arguments(parsed->ros_arguments);
  if (!arguments) return refuse_record(arguments.error());
  auto context = ros::Context::create();
  if (!context) return refuse_record(context.error());
  if (!parsed->repair.empty()) return repair(*parsed, (*context)->distro());
  ros::EventLoop loop;
  StopSignal stop([&loop] { loop.stop(); });
  ros::NodeOptions node_options;
  node_options.name = "goalnet_record";
  node_options.arguments = *arguments;
  auto node = ros::Node::create(**context, loop, std::move(node_options));
  if (!node) return refuse_record(node.error());
  const std::string directory = parsed->options.bag.directory;
  parsed->options.on_end = [&loop] { loop.stop(); };
  auto recorder = ros::Recorder::create(**node, std::move(parsed->options));
  if (!recorder) return refuse_record(recorder.error());
  std::cerr << "recording into " << directory << "; Ctrl-C ends it\n";
  if (!stop.requested()) loop.run();
  if (auto closed = (*recorder)->close(); !closed) return refuse_record(closed.error());
  std::cerr << (*recorder)->message_count() << " messages recorded";
  if (const auto left = (*recorder)->left_out(); left > 0)
    std::cerr << ", " << left << " left out: they came faster than they could be written";
  std::cerr << "\n";
  return 0;
}

}  // namespace goalnet::tools
