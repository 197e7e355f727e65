// Records topics into a rosbag2 directory (MCAP): `ros2 bag info`, `ros2 bag play` and Foxglove open it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "components/ros/bag/bag_metadata.h"
#include "components/ros/bag/mcap_writer.h"
#include "components/ros/node.h"

namespace goalnet::ros {

struct RecorderOptions {
  std::string directory;                  // must not exist yet
  std::vector<std::string> topics;        // full names; empty: every topic of a known type, as it appears
  std::uint64_t most_bytes = 4ull << 30;  // recording ends there
};

// Runs in the node's loop, on the wall clock. What was recorded more than a second ago survives a crash.
// Messages are stamped with the node's clock, so that a recording of a simulation plays in simulated time.
class Recorder {
 public:
  // kInvalidRequest if the directory exists or cannot be made.
  static Expected<std::unique_ptr<Recorder>> create(Node& node, const RecorderOptions& options);
  ~Recorder();  // closes
  Recorder(const Recorder&) = delete;

  // Subscribes to what appeared since the last call; also called ten times a second. Call it before the first
  // message in a lockstep loop.
  void look_for_topics();
  // Ends the recording and writes the metadata. Safe to call twice.
  Expected<void> close();

  std::uint64_t message_count() const { return writer_->message_count(); }

 private:
  struct Channel {
    std::uint16_t id = 0;
    BagTopic topic;
    std::shared_ptr<Reader> reader;
  };
  struct Inbox;  // what readers post, alive as long as any post waits

  Recorder(Node& node, const RecorderOptions& options, std::unique_ptr<McapWriter> writer);
  void open_channel(const std::string& name, const idl::TypeSupport& support, const Qos& qos);
  void on_payload(const std::string& name, std::vector<std::uint8_t> payload, const SampleInfo& info);
  Expected<void> write_metadata();

  Node& node_;
  RecorderOptions options_;
  std::unique_ptr<McapWriter> writer_;
  Clock wall_;
  std::map<std::string, Channel> channels_;  // by ROS name
  std::shared_ptr<Inbox> inbox_;
  std::shared_ptr<Timer> looker_, flusher_;
  std::uint64_t first_ = 0, last_ = 0;
  bool closed_ = false;
};

}  // namespace goalnet::ros
