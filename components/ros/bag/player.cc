#include "components/ros/bag/player.h"

#include <algorithm>
#include <cmath>

#include "components/ros/bag/offered_qos.h"
#include "components/ros/detail/participant.h"
#include "components/ros/names.h"
#include "rosgraph_msgs/msg/Clock.h"

namespace goalnet::ros {
namespace {

using SteadyClock = std::chrono::steady_clock;

}  // namespace

Expected<std::unique_ptr<Player>> Player::create(Node& node, std::unique_ptr<BagReader> bag,
                                                 PlayerOptions options) {
  if (!(options.rate > 0.0) || !std::isfinite(options.rate))
    return fail(Outcome::kInvalidRequest, "the rate must be greater than 0");
  std::unique_ptr<Player> player(new Player(node, std::move(bag), std::move(options)));
  if (auto opened = player->open_topics(); !opened) return tl::unexpected<Error>(std::move(opened.error()));
  return player;
}

Expected<void> Player::open_topics() {
  bool any = false;
  for (const BagTopic& topic : bag_->topics()) {
    writers_.push_back(nullptr);
    if (!options_.selection.selects(topic.name)) continue;
    if (options_.clock_hz > 0.0 && topic.name == "/clock") {
      node_.log().info("the recorded /clock is left out: --clock makes one");
      continue;
    }
    if (topic.serialization_format != "cdr") {
      return fail(Outcome::kInvalidRequest, topic.name + " is recorded in the format \"" +
                                                topic.serialization_format.substr(0, 40) +
                                                "\"; only cdr can be played");
    }
    if (auto name = expand_name(topic.name, "/", "x");
        !name || idl::ros_type_name(idl::dds_type_name(topic.type)) != topic.type) {
      return fail(Outcome::kInvalidRequest, "\"" + topic.name.substr(0, 80) + "\" of type \"" +
                                                topic.type.substr(0, 80) + "\" is no topic of ROS 2");
    }
    EndpointOptions endpoint;
    endpoint.dds_topic = topic_to_dds(node_.resolve(topic.name));
    endpoint.dds_type = idl::dds_type_name(topic.type);
    endpoint.type_hash = topic.type_hash;
    if (const auto* known = idl::find_type(topic.type); known != nullptr && endpoint.type_hash.empty())
      endpoint.type_hash = known->hash;
    endpoint.qos = offer_in_place_of(topic.offered);
    endpoint.node = node_.full_name();
    auto writer = Writer::create(node_.context().participant(), endpoint);
    if (!writer) return tl::unexpected<Error>(std::move(writer.error()));
    writers_.back() = std::move(*writer);
    any = true;
  }
  if (!any) return fail(Outcome::kInvalidRequest, "the bag has none of these topics");
  if (options_.clock_hz > 0.0) {
    clock_ = node_.open_writer(node_.resolve("/clock"), idl::type_support<rosgraph_msgs::msg::Clock>(),
                               Qos::clock());
  }
  return {};
}

Expected<void> Player::play(const std::function<bool()>& stop) {
  next_clock_ = SteadyClock::now();
  if (!wait_until(SteadyClock::now() + options_.delay, stop)) return {};
  do {
    if (auto played = play_once(stop); !played) return played;
    if (options_.loop && !stop()) {
      if (auto again = bag_->rewind(); !again) return again;
    }
  } while (options_.loop && !stop());
  // Reliable subscribers get the last messages before their publishers go.
  for (const auto& writer : writers_) {
    if (writer != nullptr && !stop()) writer->wait_for_acknowledgments(std::chrono::seconds(1));
  }
  return {};
}

Expected<void> Player::play_once(const std::function<bool()>& stop) {
  BagMessage message;
  bool begun = false;
  for (;;) {
    auto more = bag_->next(message);
    if (!more) return tl::unexpected<Error>(std::move(more.error()));
    if (!*more) return {};
    const auto& writer = writers_[message.topic];
    if (writer == nullptr) continue;
    if (!begun) {
      begun = true;
      first_time_ = message.log_time;
      start_ = next_clock_ = SteadyClock::now();
    }
    // A recording that spans more than a year in one bag is damaged; do not wait for it.
    constexpr double kLongest = 366.0 * 86400.0;
    const double since =
        static_cast<double>(message.log_time - std::min(first_time_, message.log_time)) * 1e-9;
    const std::chrono::duration<double> wait(std::min(since / options_.rate, kLongest));
    if (!wait_until(start_ + std::chrono::duration_cast<SteadyClock::duration>(wait), stop)) return {};
    if (message.payload.size() < 4 || !writer->write_raw(message.payload)) {
      node_.log().warn("a message of {} could not be sent", bag_->topics()[message.topic].name);
      continue;
    }
    ++message_count_;
  }
}

// Serves the node, and publishes /clock, until then. False where it was stopped.
bool Player::wait_until(SteadyClock::time_point due, const std::function<bool()>& stop) {
  for (;;) {
    if (stop()) return false;
    if (clock_ != nullptr && SteadyClock::now() >= next_clock_) publish_clock();
    const auto now = SteadyClock::now();
    if (now >= due) {
      node_.loop().run_pending();
      return true;
    }
    auto next = std::min(due, now + std::chrono::milliseconds(20));
    if (clock_ != nullptr) next = std::min(next, next_clock_);
    node_.loop().run_for(next - now);
  }
}

std::uint64_t Player::recording_now() const {
  const std::chrono::duration<double, std::nano> since = SteadyClock::now() - start_;
  return first_time_ + static_cast<std::uint64_t>(std::max(since.count(), 0.0) * options_.rate);
}

void Player::publish_clock() {
  const auto period = std::chrono::duration_cast<SteadyClock::duration>(
      std::chrono::duration<double>(1.0 / options_.clock_hz));
  next_clock_ = std::max(next_clock_ + period, SteadyClock::now());
  if (first_time_ == 0 && message_count_ == 0)
    return;  // before the first message it is not known what time it is
  rosgraph_msgs::msg::Clock message;
  message.clock(Time(static_cast<std::int64_t>(recording_now())).to_msg());
  clock_->write(&message);
}

}  // namespace goalnet::ros
