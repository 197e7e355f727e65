#include "tools/goalnet/replay_command.h"

#include <iostream>

#include "components/ros/arguments.h"
#include "components/ros/node.h"
#include "tools/goalnet/record_options.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

int refuse(const Error& error) {
  std::cerr << "goalnet replay: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

}  // namespace

int replay_command(int argc, char** argv) {
  auto parsed = parse_replay_options(argc, argv);
  if (!parsed) return refuse(parsed.error());
  if (parsed->help_shown) return 0;
  const auto arguments = ros::parse_arguments(parsed->ros_arguments);
  if (!arguments) return refuse(arguments.error());
  auto bag = ros::BagReader::open(parsed->bag);
  if (!bag) return refuse(bag.error());
  if (!(*bag)->finished()) {
    std::cerr << "goalnet replay: the bag's recorder was killed or still runs; playing what is there\n";
  }
  auto context = ros::Context::create();
  if (!context) return refuse(context.error());
  ros::EventLoop loop;
  StopSignal stop([&loop] { loop.stop(); });
  ros::NodeOptions node_options;
  node_options.name = "goalnet_replay";
  node_options.arguments = *arguments;
  // It would log to the topic that it plays.
  node_options.rosout = false;
  auto node = ros::Node::create(**context, loop, std::move(node_options));
  if (!node) return refuse(node.error());
  auto player = ros::Player::create(**node, std::move(*bag), std::move(parsed->options));
  if (!player) return refuse(player.error());
  const auto played = (*player)->play([&stop] { return stop.requested(); });
  std::cerr << (*player)->message_count() << " messages played\n";
  return played ? 0 : refuse(played.error());
}

}  // namespace goalnet::tools
