#include "tools/goalnet/record_command.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "components/ros/arguments.h"
#include "components/ros/bag/recorder.h"
#include "components/ros/node.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

constexpr const char* kHelp =
    "usage: goalnet record DIRECTORY [TOPIC...] [--ros-args …]\n"
    "\n"
    "Records topics of ROS 2 nodes on this domain into a new rosbag2 directory (MCAP) until Ctrl-C: all "
    "topics of\n"
    "known types, or those named. `ros2 bag info`, `ros2 bag play` and Foxglove open it.\n"
    "GOALNET_ROS_DISTRO=humble writes what Humble reads.\n";

int refuse(const Error& error) {
  std::cerr << "goalnet record: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

}  // namespace

int record_command(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) {
    std::fputs(kHelp, stdout);
    return 0;
  }
  const auto arguments = ros::parse_arguments(words);
  if (!arguments) return refuse(arguments.error());
  if (arguments->remaining.empty()) {
    return refuse({Outcome::kInvalidRequest, "where to? \"goalnet record --help\" tells more"});
  }
  ros::RecorderOptions options;
  options.directory = arguments->remaining[0];
  options.topics.assign(arguments->remaining.begin() + 1, arguments->remaining.end());
  for (std::string& topic : options.topics) {
    if (!topic.starts_with("/")) topic.insert(0, "/");
  }
  auto context = ros::Context::create();
  if (!context) return refuse(context.error());
  ros::EventLoop loop;
  StopSignal stop([&loop] { loop.stop(); });
  ros::NodeOptions node_options;
  node_options.name = "goalnet_record";
  node_options.arguments = *arguments;
  auto node = ros::Node::create(**context, loop, std::move(node_options));
  if (!node) return refuse(node.error());
  auto recorder = ros::Recorder::create(**node, options);
  if (!recorder) return refuse(recorder.error());
  std::cerr << "recording into " << options.directory << "; Ctrl-C ends it\n";
  if (!stop.requested()) loop.run();
  if (auto closed = (*recorder)->close(); !closed) return refuse(closed.error());
  std::cerr << (*recorder)->message_count() << " messages recorded\n";
  return 0;
}

}  // namespace goalnet::tools
