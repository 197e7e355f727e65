#include "components/ros/bag/recorder.h"

#include <algorithm>
#include <atomic>
#include <tuple>
#include <utility>

#include "components/ros/detail/participant.h"
#include "components/ros/names.h"

namespace goalnet::ros {
namespace {

constexpr std::uint32_t kDepth = 1000;  // messages of one topic that may wait

std::vector<OfferedQos> profiles(const std::map<Gid, OfferedQos>& offered) {
  std::vector<OfferedQos> list;
  for (const auto& [writer, qos] : offered) list.push_back(qos);
  // In an order that does not depend on the random part of DDS identifiers.
  std::stable_sort(list.begin(), list.end(), [](const OfferedQos& a, const OfferedQos& b) {
    const auto key = [](const OfferedQos& one) {
      return std::tuple(one.qos.reliable, one.qos.transient_local, one.history_known, one.qos.depth);
    };
    return key(a) > key(b);
  });
  return list;
}

}  // namespace

// Lets callbacks of the loop find the recorder while it lives.
struct Recorder::Inbox {
  Inbox(Recorder* owner, std::size_t limit) : recorder(owner), most_waiting(limit) {}

  Recorder* recorder;
  const std::size_t most_waiting;          // [bytes]
  std::atomic<std::size_t> waiting{0};     // [bytes]
  std::atomic<std::uint64_t> left_out{0};  // messages

  // Thread-safe. Whether there is room for so many bytes more; leave() gives it back.
  bool enter(std::size_t bytes) {
    if (waiting.fetch_add(bytes) + bytes <= most_waiting) return true;
    waiting.fetch_sub(bytes);
    left_out.fetch_add(1);
    return false;
  }
  void leave(std::size_t bytes) { waiting.fetch_sub(bytes); }
};

Expected<std::unique_ptr<Recorder>> Recorder::create(Node& node, RecorderOptions options) {
  options.bag.file.distro = node.context().distro();
  auto bag = BagWriter::create(options.bag);
  if (!bag) return tl::unexpected<Error>(std::move(bag.error()));
  return std::unique_ptr<Recorder>(new Recorder(node, std::move(options), std::move(*bag)));
}

Recorder::Recorder(Node& node, RecorderOptions options, std::unique_ptr<BagWriter> bag)
    : node_(node),
      options_(std::move(options)),
      bag_(std::move(bag)),
      inbox_(std::make_shared<Inbox>(this, options_.most_waiting)) {
  look_for_topics();
  if (options_.lockstep)
    node.context().participant()->written().on_local_writer([this] { look_for_topics(); });
  Clock& clock = options_.lockstep ? node.clock() : wall_;
  looker_ = Timer::create(node.loop(), clock, std::chrono::milliseconds(100), [this] { look_for_topics(); });
  flusher_ = Timer::create(node.loop(), clock, std::chrono::milliseconds(500), [this] { flush(); });
}

Recorder::~Recorder() {
  if (options_.lockstep) node_.context().participant()->written().on_local_writer({});
  static_cast<void>(close());
  channels_.clear();
  inbox_->recorder = nullptr;
}

void Recorder::look_for_topics() {
  if (closed_) return;
  for (const auto& [dds_name, writers] : node_.context().participant()->written().snapshot()) {
    if (!dds_name.starts_with("rt/") || writers.empty()) continue;
    const std::string name = dds_name.substr(2);
    if (!options_.selection.selects(name) || !expand_name(name, "/", "x")) continue;
    const auto known = channels_.find(name);
    std::map<Gid, OfferedQos> offered;
    if (known != channels_.end()) offered = known->second.offered;
    const detail::TopicWriter& first = writers.begin()->second;
    const std::string& dds_type = known != channels_.end() ? known->second.dds_type : first.dds_type;
    bool second_type = false;
    for (const auto& [gid, writer] : writers) {
      if (writer.dds_type == dds_type) {
        offered[gid] = writer.offered;
      } else {
        second_type = true;
      }
    }
    Channel* channel = known != channels_.end()
                           ? &known->second
                           : open_channel(name, dds_type, first.type_hash, profiles(offered));
    if (channel == nullptr) return;  // the recording has ended
    if (second_type && !channel->warned) {
      node_.log().warn("{} has publishers of several types; only those of {} are recorded", name, dds_type);
      channel->warned = true;
    }
    if (offered == channel->offered && (known != channels_.end())) continue;
    channel->offered = std::move(offered);
    subscribe(name, *channel);
  }
}

Recorder::Channel* Recorder::open_channel(const std::string& name, const std::string& dds_type,
                                          const std::string& hash, std::vector<OfferedQos> offered) {
  BagTopic topic;
  topic.name = name;
  topic.type = idl::ros_type_name(dds_type);
  topic.type_hash = hash;
  topic.offered = std::move(offered);
  Channel& channel = channels_[name];
  channel.dds_type = dds_type;
  if (topic.type.empty()) {
    node_.log().warn("{} is not recorded: {} is no type of ROS 2", name, dds_type);
    return &channel;
  }
  const idl::TypeDescription* description = idl::find_type(topic.type);
  if (description != nullptr && std::string_view(description->encoding) == "msg") {
    topic.definition = idl::full_definition(*description);
    if (topic.type_hash.empty()) topic.type_hash = description->hash;
  } else {
    node_.log().warn(
        "{} has the type {}, whose definition is not known here: its messages are recorded without it (ros2 "
        "bag play "
        "has its own; Foxglove cannot show them)",
        name, topic.type);
  }
  auto added = bag_->add_topic(topic);
  if (!added) {
    end_on(added.error());
    return nullptr;
  }
  channel.topic = *added;
  return &channel;
}

void Recorder::subscribe(const std::string& name, Channel& channel) {
  const std::string ros_type = idl::ros_type_name(channel.dds_type);
  if (ros_type.empty()) return;
  const std::vector<OfferedQos> offered = profiles(channel.offered);
  bag_->set_offered(channel.topic, offered);
  const Qos request = request_for(offered).keep_last(kDepth);
  if (channel.reader != nullptr && request == channel.request) return;
  if (channel.reader != nullptr) {
    node_.log().warn(
        "a publisher of {} offers less than those before; subscribed again with what all of them offer",
        name);
    channel.reader.reset();
  }
  channel.request = request;
  EndpointOptions endpoint;
  endpoint.dds_topic = topic_to_dds(name);
  endpoint.dds_type = channel.dds_type;
  if (const auto* description = idl::find_type(ros_type)) endpoint.type_hash = description->hash;
  endpoint.qos = request;
  endpoint.node = node_.full_name();
  Reader::Callbacks callbacks;
  callbacks.on_payload = [name, &loop = node_.loop(), inbox = inbox_](std::vector<std::uint8_t> payload,
                                                                      const SampleInfo& info) {
    const std::size_t size = payload.size();
    if (!inbox->enter(size)) return;
    loop.post([name, inbox, info, size, payload = std::move(payload)]() mutable {
      inbox->leave(size);
      if (inbox->recorder != nullptr) inbox->recorder->on_payload(name, std::move(payload), info);
    });
  };
  auto reader = Reader::create(node_.context().participant(), endpoint, std::move(callbacks));
  if (!reader) {
    node_.log().warn("{} is not recorded: {}", name, reader.error().message);
    return;
  }
  channel.reader = std::move(*reader);
}

void Recorder::on_payload(const std::string& name, std::vector<std::uint8_t> payload,
                          const SampleInfo& info) {
  if (closed_ || payload.size() < 4) return;
  const auto now = static_cast<std::uint64_t>(std::max<std::int64_t>(node_.now().nanoseconds, 0));
  const auto sent = static_cast<std::uint64_t>(std::max<std::int64_t>(info.source_timestamp, 0));
  // DDS stamps with the wall clock, which means nothing in simulated time.
  auto written = bag_->write(channels_[name].topic, now, node_.clock().simulated() ? now : sent, payload);
  if (!written) end_on(written.error());
}

void Recorder::end_on(const Error& error) {
  node_.log().error("{}; the recording ends here", error.message);
  static_cast<void>(close());
  result_ = tl::unexpected(error);
  if (options_.on_end) options_.on_end();
}

void Recorder::flush() {
  const std::uint64_t left = left_out();
  if (left > told_left_out_)
    node_.log().warn("{} messages were left out: they come faster than they can be written",
                     left - std::exchange(told_left_out_, left));
  if (auto flushed = bag_->flush(); !flushed) end_on(flushed.error());
}

std::uint64_t Recorder::left_out() const { return inbox_->left_out.load(); }

Expected<void> Recorder::close() {
  if (closed_) return result_;
  closed_ = true;
  if (looker_) looker_->cancel();
  if (flusher_) flusher_->cancel();
  result_ = bag_->close();
  return result_;
}

}  // namespace goalnet::ros
