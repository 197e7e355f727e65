// Receives messages of one type from one topic.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "components/ros/endpoint.h"
#include "components/ros/event_loop.h"

namespace goalnet::ros {

struct SubscribeOptions {
  // Call back at once in the thread that delivers, not in the event loop: what is called may not wait.
  bool immediate = false;
};

// The part of a subscription that does not depend on the type: a queue of at most `depth` messages (the
// oldest are dropped), drained by the event loop in order of arrival.
class SubscriptionBase : public std::enable_shared_from_this<SubscriptionBase> {
 public:
  using Callback = std::function<void(const void* message, const SampleInfo& info)>;
  using DropReport = std::function<void(const char* why)>;  // runs in the event loop
  // `arrival` may be empty.
  SubscriptionBase(EventLoop& loop, std::size_t depth, bool immediate, Callback arrival, Callback callback,
                   DropReport report);

  Expected<void> open(const std::shared_ptr<detail::Participant>& participant,
                      const EndpointOptions& options);

  const Reader& reader() const { return *reader_; }
  std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

 private:
  struct Entry {
    std::shared_ptr<void> message;
    SampleInfo info;
  };
  void on_message(std::shared_ptr<void> message, const SampleInfo& info);
  void on_dropped(const char* why);
  void deliver_one();

  EventLoop& loop_;
  const std::size_t depth_;
  const bool immediate_;
  Callback arrival_;
  Callback callback_;
  DropReport report_;
  std::mutex mutex_;
  std::deque<Entry> queue_;
  std::atomic<std::uint64_t> dropped_{0};  // malformed, not overwritten
  std::shared_ptr<Reader> reader_;         // last: stops calling before the rest goes
};

// Callbacks end when the subscription is destroyed; destroy it in the loop's thread.
template <class Message>
class Subscription {
 public:
  Subscription(std::shared_ptr<SubscriptionBase> base, std::string topic)
      : base_(std::move(base)), topic_(std::move(topic)) {}

  bool wait_for_publishers(std::size_t count = 1,
                           std::chrono::nanoseconds timeout = std::chrono::seconds(5)) const {
    return base_->reader().wait_for_matched(count, timeout);
  }
  std::size_t publisher_count() const { return base_->reader().matched(); }
  // Messages refused because they were malformed.
  std::uint64_t dropped() const { return base_->dropped(); }
  const std::string& topic() const { return topic_; }  // full ROS name
  const Gid& gid() const { return base_->reader().gid(); }

 private:
  std::shared_ptr<SubscriptionBase> base_;
  std::string topic_;
};

}  // namespace goalnet::ros
