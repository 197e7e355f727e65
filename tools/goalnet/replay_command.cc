#include "tools/goalnet/replay_command.h"

#include <iostream>

#include "components/ros/arguments.h"
#include "components/ros/node.h"
#include "tools/goalnet/record_options.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

int refuse_replay(const Error& error) {
  std::cerr << "goalnet replay: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

}  // namespace

int replay_command(int argc, char** argv) {
  auto parsed = parse_replay_options(argc, argv);
  if (!parsed) return refuse_replay(parsed.error());
  if (parsed->help_shown) return 0;
  const auto arguments = ros::parse_arguments(parsed->ros_arguments);
  if (!arguments) return refuse_replay(arguments.error());
  auto bag = ros::BagReader::open(parsed->bag);
  if (!bag) return refuse_replay(bag.error());
  if (!(*bag)->finished()) {
    std::cerr << "goalnet replay: the bag's recorder was killed or still runs; playing what is there\n";
  }
  auto context = ros::Context::create();
  if (!context) return refuse_replay(context.error());
  ros::EventLoop loop;
  StopSignal stop([&loop] { loop.stop(); });
  ros::NodeOptions node_options;
  node_options.name = "goalnet_replay";
  node_options.arguments = *arguments;
  // It would log to the topic that it plays.
  node_options.rosout = false;
  auto node = ros::Node::create(**context, loop, std::move(node_options));
  if (!node) return refuse_replay(node.error());
  auto player = ros::Player::create(**node, std::move(*bag), std::move(parsed->options));
  if (!player) return refuse_replay(player.error());
  const auto played = (*player)->play([&stop] { return stop.requested(); });
  std::cerr << (*player)->message_count() << " messages played\n";
  return played ? 0 : refuse_replay(played.error());
}

}  // namespace goalnet::tools
