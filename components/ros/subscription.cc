#include "components/ros/subscription.h"

namespace goalnet::ros {

SubscriptionBase::SubscriptionBase(EventLoop& loop, std::size_t depth, bool immediate, Callback arrival,
                                   Callback callback, DropReport report)
    : loop_(loop),
      depth_(depth),
      immediate_(immediate),
      arrival_(std::move(arrival)),
      callback_(std::move(callback)),
      report_(std::move(report)) {}

Expected<void> SubscriptionBase::open(const std::shared_ptr<detail::Participant>& participant,
                                      const EndpointOptions& options) {
  Reader::Callbacks callbacks;
  callbacks.on_message = [this](std::shared_ptr<void> message, const SampleInfo& info) {
    on_message(std::move(message), info);
  };
  callbacks.on_dropped = [this](const char* why) { on_dropped(why); };
  auto reader = Reader::create(participant, options, std::move(callbacks));
  if (!reader) return tl::unexpected(reader.error());
  reader_ = std::move(*reader);
  return {};
}

void SubscriptionBase::on_message(std::shared_ptr<void> message, const SampleInfo& info) {
  if (arrival_) arrival_(message.get(), info);
  if (immediate_) {
    callback_(message.get(), info);
    return;
  }
  {
    std::lock_guard lock(mutex_);
    queue_.push_back({std::move(message), info});
    if (queue_.size() > depth_) {
      queue_.pop_front();  // its place in the event loop now serves the new one
      return;
    }
  }
  loop_.post([weak = weak_from_this()] {
    if (auto self = weak.lock()) self->deliver_one();
  });
}

void SubscriptionBase::on_dropped(const char* why) {
  // One report at the first, then at 10, 100, ...: a flood of rubbish must not flood the log.
  const std::uint64_t count = dropped_.fetch_add(1, std::memory_order_relaxed) + 1;
  std::uint64_t power = 1;
  while (power < count) power *= 10;
  if (power != count) return;
  loop_.post([weak = weak_from_this(), why] {
    if (auto self = weak.lock()) self->report_(why);
  });
}

void SubscriptionBase::deliver_one() {
  Entry entry;
  {
    std::lock_guard lock(mutex_);
    if (queue_.empty()) return;
    entry = std::move(queue_.front());
    queue_.pop_front();
  }
  callback_(entry.message.get(), entry.info);
}

}  // namespace goalnet::ros
