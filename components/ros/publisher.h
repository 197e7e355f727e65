// Sends messages of one type to one topic.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "components/ros/endpoint.h"

namespace goalnet::ros {

// Thread-safe. Never call it from the real-time thread: DDS allocates and locks.
template <class Message>
class Publisher {
 public:
  Publisher(std::shared_ptr<Writer> writer, std::string topic)
      : writer_(std::move(writer)), topic_(std::move(topic)) {}

  // Subscriptions of the same process have the message queued on return. False if it could not be sent.
  bool publish(const Message& message) { return writer_->write(&message); }

  // A volatile message published before its readers are known never reaches them: wait first where it
  // matters.
  bool wait_for_subscribers(std::size_t count = 1,
                            std::chrono::nanoseconds timeout = std::chrono::seconds(5)) const {
    return writer_->wait_for_matched(count, timeout);
  }
  std::size_t subscriber_count() const { return writer_->matched(); }
  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
    return writer_->wait_for_acknowledgments(timeout);
  }
  const std::string& topic() const { return topic_; }  // full ROS name
  const Gid& gid() const { return writer_->gid(); }

 private:
  std::shared_ptr<Writer> writer_;
  std::string topic_;
};

}  // namespace goalnet::ros
