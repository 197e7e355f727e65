// Records topics of any type into a rosbag2 directory: `ros2 bag info`, `ros2 bag play` and Foxglove open it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "components/ros/bag/bag_writer.h"
#include "components/ros/bag/offered_qos.h"
#include "components/ros/bag/topic_selection.h"
#include "components/ros/node.h"

namespace goalnet::ros {

struct RecorderOptions {
  BagWriterOptions bag;  // its distribution is the context's
  TopicSelection selection;
  // For a simulation in lockstep, with all nodes in this thread: subscribes to each publisher of this process
  // before it publishes anything, and flushes in simulated time. The same run is then recorded the same way
  // each time.
  bool lockstep = false;
  // [bytes] of messages that may wait to be written where they come faster than the disk takes them; more are
  // left out, counted and told.
  std::size_t most_waiting = std::size_t{256} << 20;
  // Called when nothing more can be written (the disk is full); close() says why. May be empty.
  std::function<void()> on_end;
};

// Runs in the node's loop. What was recorded more than a second ago survives a crash. Messages are stamped
// with the node's clock, so that a recording of a simulation is in simulated time; in wall-clock time the
// moment of sending is kept too. Subscribes as rosbag2 does: reliable, or transient local, only where all
// publishers of the topic are, and weaker when a weaker one comes.
class Recorder {
 public:
  // kInvalidRequest if the directory exists or cannot be made.
  static Expected<std::unique_ptr<Recorder>> create(Node& node, RecorderOptions options);
  ~Recorder();  // closes
  Recorder(const Recorder&) = delete;

  // Subscribes to what appeared since the last call; also called ten times a second.
  void look_for_topics();
  // Ends the recording and completes the bag. Safe to call twice. Returns what went wrong first, if anything.
  Expected<void> close();

  std::uint64_t message_count() const { return bag_->message_count(); }
  // Messages that came faster than they could be written.
  std::uint64_t left_out() const;
  const BagMetadata& metadata() const { return bag_->metadata(); }

 private:
  struct Channel {
    std::size_t topic = 0;  // in the bag
    std::string dds_type;
    std::map<Gid, OfferedQos> offered;  // of all publishers seen
    Qos request;
    std::shared_ptr<Reader> reader;  // nullptr: not recorded
    bool warned = false;             // of a second type
  };
  struct Inbox;  // what readers post, alive as long as any post waits

  Recorder(Node& node, RecorderOptions options, std::unique_ptr<BagWriter> bag);
  Channel* open_channel(const std::string& name, const std::string& dds_type, const std::string& hash,
                        std::vector<OfferedQos> offered);
  void subscribe(const std::string& name, Channel& channel);
  void on_payload(const std::string& name, std::vector<std::uint8_t> payload, const SampleInfo& info);
  void end_on(const Error& error);
  void flush();

  Node& node_;
  RecorderOptions options_;
  std::unique_ptr<BagWriter> bag_;
  Clock wall_;
  std::map<std::string, Channel> channels_;  // by ROS name
  std::shared_ptr<Inbox> inbox_;
  std::shared_ptr<Timer> looker_, flusher_;
  std::uint64_t told_left_out_ = 0;
  bool closed_ = false;
  Expected<void> result_;
};

}  // namespace goalnet::ros
