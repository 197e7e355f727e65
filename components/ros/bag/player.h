// Plays a bag: publishes what was recorded, with the types and the quality of service it was recorded with.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "components/ros/bag/bag_reader.h"
#include "components/ros/bag/topic_selection.h"
#include "components/ros/node.h"

namespace goalnet::ros {

struct PlayerOptions {
  TopicSelection selection;
  double rate = 1.0;      // > 0: seconds of the recording in a second
  double clock_hz = 0.0;  // publish /clock this often [Hz of wall time]; 0: never
  std::chrono::nanoseconds delay{
      500'000'000};   // before the first message, for subscribers to find the topics
  bool loop = false;  // for ever
};

// Belongs to the thread of the node's loop.
class Player {
 public:
  // Makes the publishers. kInvalidRequest where nothing is selected, or for a topic that ROS 2 cannot have.
  static Expected<std::unique_ptr<Player>> create(Node& node, std::unique_ptr<BagReader> bag,
                                                  PlayerOptions options);

  // Runs the node's loop meanwhile. Returns when all is played, or soon after `stop` says so (asked often).
  // Errors are those of the bag: what came before them was played.
  Expected<void> play(const std::function<bool()>& stop);

  std::uint64_t message_count() const { return message_count_; }  // published so far

 private:
  Player(Node& node, std::unique_ptr<BagReader> bag, PlayerOptions options)
      : node_(node), bag_(std::move(bag)), options_(options) {}
  Expected<void> open_topics();
  Expected<void> play_once(const std::function<bool()>& stop);
  bool wait_until(std::chrono::steady_clock::time_point due, const std::function<bool()>& stop);
  void publish_clock();
  std::uint64_t recording_now() const;

  Node& node_;
  std::unique_ptr<BagReader> bag_;
  const PlayerOptions options_;
  std::vector<std::shared_ptr<Writer>> writers_;  // by the bag's topics; nullptr: not played
  std::shared_ptr<Writer> clock_;
  std::chrono::steady_clock::time_point start_, next_clock_;
  std::uint64_t first_time_ = 0;  // [ns] of the recording, at start_
  std::uint64_t message_count_ = 0;
};

}  // namespace goalnet::ros
