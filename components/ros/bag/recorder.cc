#include "components/ros/bag/recorder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "components/ros/detail/participant.h"
#include "components/ros/names.h"

namespace goalnet::ros {
namespace {

constexpr const char* kFileName = "recording_0.mcap";
constexpr std::uint32_t kDepth = 1000;  // messages of one topic that may wait

bool hidden(const std::string& name) { return name.find("/_") != std::string::npos; }

}  // namespace

// Lets callbacks of the loop find the recorder while it lives.
struct Recorder::Inbox {
  Recorder* recorder;
};

Expected<std::unique_ptr<Recorder>> Recorder::create(Node& node, const RecorderOptions& options) {
  std::error_code error;
  const std::filesystem::path directory(options.directory);
  if (std::filesystem::exists(directory, error)) {
    return fail(Outcome::kInvalidRequest,
                "the recording " + options.directory + " exists already; choose another name");
  }
  std::filesystem::create_directories(directory, error);
  if (error)
    return fail(Outcome::kInvalidRequest, "cannot make " + options.directory + ": " + error.message());
  auto writer = McapWriter::create((directory / kFileName).string());
  if (!writer) return tl::unexpected(writer.error());
  return std::unique_ptr<Recorder>(new Recorder(node, options, std::move(*writer)));
}

Recorder::Recorder(Node& node, const RecorderOptions& options, std::unique_ptr<McapWriter> writer)
    : node_(node),
      options_(options),
      writer_(std::move(writer)),
      inbox_(std::make_shared<Inbox>(Inbox{this})) {
  look_for_topics();
  looker_ = Timer::create(node.loop(), wall_, std::chrono::milliseconds(100), [this] { look_for_topics(); });
  flusher_ = Timer::create(node.loop(), wall_, std::chrono::milliseconds(500), [this] {
    auto done = writer_->flush();
    if (done) done = write_metadata();
    if (!done) node_.log().error("{}", done.error().message);
  });
}

Recorder::~Recorder() {
  static_cast<void>(close());
  channels_.clear();
  inbox_->recorder = nullptr;
}

void Recorder::look_for_topics() {
  for (const auto& [dds_name, written] : node_.context().participant()->written_topics()) {
    if (!dds_name.starts_with("rt/")) continue;
    const std::string name = dds_name.substr(2);
    const bool wanted = options_.topics.empty() ? !hidden(name)
                                                : std::find(options_.topics.begin(), options_.topics.end(),
                                                            name) != options_.topics.end();
    if (!wanted || channels_.contains(name)) continue;
    const idl::TypeSupport* support = idl::find_type_support(idl::ros_type_name(written.dds_type));
    if (support == nullptr || std::string_view(support->description->encoding) != "msg") continue;
    Qos qos = Qos::standard().keep_last(kDepth);
    qos.reliable = written.reliable;
    qos.transient_local = written.transient_local;
    open_channel(name, *support, qos);
  }
}

void Recorder::open_channel(const std::string& name, const idl::TypeSupport& support, const Qos& qos) {
  Channel& channel = channels_[name];
  channel.topic = {name, support.ros_name, support.description->hash, qos, 0};
  channel.id = writer_->add_channel(name, support.ros_name, idl::full_definition(*support.description),
                                    qos_yaml(qos, node_.context().distro()), support.description->hash);
  EndpointOptions endpoint = EndpointOptions::of(support, topic_to_dds(name), qos, node_.full_name());
  endpoint.support = nullptr;  // payloads as they come
  Reader::Callbacks callbacks;
  callbacks.on_payload = [name, &loop = node_.loop(), inbox = inbox_](std::vector<std::uint8_t> payload,
                                                                      const SampleInfo& info) {
    loop.post([name, inbox, info, payload = std::move(payload)]() mutable {
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
  Channel& channel = channels_[name];
  const auto now = static_cast<std::uint64_t>(std::max<std::int64_t>(node_.now().nanoseconds, 0));
  const auto sent = static_cast<std::uint64_t>(std::max<std::int64_t>(info.source_timestamp, 0));
  if (writer_->message_count() == 0) first_ = last_ = now;
  first_ = std::min(first_, now);
  last_ = std::max(last_, now);
  ++channel.topic.message_count;
  if (auto ok = writer_->write(channel.id, now, node_.clock().simulated() ? now : sent, payload); !ok) {
    node_.log().error("{}; the recording ends here", ok.error().message);
    static_cast<void>(close());
  } else if (writer_->size() > options_.most_bytes) {
    node_.log().warn("the recording reached {} bytes and ends here", options_.most_bytes);
    static_cast<void>(close());
  }
}

Expected<void> Recorder::write_metadata() {
  BagSummary summary{kFileName, first_, last_ - first_, {}};
  for (const auto& [name, channel] : channels_) summary.topics.push_back(channel.topic);
  const auto path = std::filesystem::path(options_.directory) / "metadata.yaml";
  const std::string fresh = path.string() + ".new";
  {
    std::ofstream file(fresh, std::ios::trunc);
    file << bag_metadata(summary, node_.context().distro());
    if (!file.flush()) return fail(Outcome::kInternal, "cannot write " + fresh);
  }
  std::error_code error;
  std::filesystem::rename(fresh, path, error);  // readers see the old one or the new one, never half of it
  if (error) return fail(Outcome::kInternal, "cannot write " + path.string() + ": " + error.message());
  return {};
}

Expected<void> Recorder::close() {
  if (closed_) return {};
  closed_ = true;
  looker_->cancel();
  flusher_->cancel();
  auto done = writer_->close();
  if (done) done = write_metadata();
  return done;
}

}  // namespace goalnet::ros
