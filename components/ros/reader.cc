#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "components/ros/detail/matches.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"
#include "components/ros/endpoint.h"

namespace goalnet::ros {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

namespace {

SampleId to_sample_id(const rtps::SampleIdentity& identity) {
  const rtps::SequenceNumber_t unknown = rtps::SequenceNumber_t::unknown();
  SampleId id;
  id.writer = detail::to_gid(identity.writer_guid());
  id.sequence = identity.sequence_number() == unknown
                    ? 0
                    : static_cast<std::int64_t>(identity.sequence_number().to64long());
  return id;
}

}  // namespace

struct Reader::Impl : dds::DataReaderListener {
  std::shared_ptr<detail::Participant> participant;
  EndpointOptions options;
  Callbacks callbacks;
  const idl::CdrLayout* layout = nullptr;
  std::shared_ptr<void> spare;  // a message that nothing was decoded into: most looks find nothing
  dds::DataReader* reader = nullptr;
  Gid gid{};
  detail::Matches matches;

  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    const std::size_t count = matches.update(status.last_publication_handle, status.current_count_change);
    if (callbacks.on_matched) callbacks.on_matched(count);
  }
  void on_data_available(dds::DataReader* source) override {
    while (take_one(source)) {
    }
  }
  bool take_one(dds::DataReader* source);
};

bool Reader::Impl::take_one(dds::DataReader* source) {
  detail::Incoming in;
  std::shared_ptr<void> message;
  if (options.support != nullptr) {
    message =
        spare ? std::move(spare) : std::shared_ptr<void>(options.support->create(), options.support->destroy);
    in.support = options.support;
    in.layout = layout;
    in.message = message.get();
  }
  dds::SampleInfo sample;
  if (source->take_next_sample(&in, &sample) != ReturnCode_t::RETCODE_OK) {
    spare = std::move(message);
    return false;
  }
  if (!sample.valid_data) return true;  // a writer left
  if (in.fault != nullptr) {
    if (callbacks.on_dropped) callbacks.on_dropped(in.fault);
    return true;
  }
  SampleInfo info;
  info.id = to_sample_id(sample.sample_identity);
  info.related = to_sample_id(sample.related_sample_identity);
  info.source_timestamp = sample.source_timestamp.to_ns();
  info.from_this_participant = sample.sample_identity.writer_guid().guidPrefix == source->guid().guidPrefix;
  if (options.support != nullptr) {
    if (callbacks.on_message) callbacks.on_message(std::move(message), info);
  } else if (callbacks.on_payload) {
    callbacks.on_payload(std::move(in.payload), info);
  }
  return true;
}

Reader::Reader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Expected<std::shared_ptr<Reader>> Reader::create(const std::shared_ptr<detail::Participant>& participant,
                                                 const EndpointOptions& options, Callbacks callbacks) {
  auto impl = std::make_unique<Impl>();
  impl->participant = participant;
  impl->options = options;
  impl->callbacks = std::move(callbacks);
  if (options.support != nullptr) impl->layout = &detail::layout_of(*options.support);
  auto topic = participant->acquire_topic(options.dds_topic, options.dds_type);
  if (!topic) return tl::unexpected(topic.error());
  const auto qos = detail::reader_qos(
      options.qos, detail::endpoint_user_data(participant->settings().distro, options.type_hash));
  impl->reader = participant->subscriber().create_datareader(
      *topic, qos, impl.get(), dds::StatusMask::data_available() << dds::StatusMask::subscription_matched());
  if (impl->reader == nullptr) {
    participant->release_topic(options.dds_topic);
    return fail(Outcome::kInternal, "Fast DDS cannot make a reader for " + options.dds_topic);
  }
  impl->gid = detail::to_gid(impl->reader->guid());
  participant->add_endpoint(options.node, impl->gid, false);
  return std::shared_ptr<Reader>(new Reader(std::move(impl)));
}

Reader::~Reader() {
  impl_->reader->set_listener(nullptr);
  impl_->participant->subscriber().delete_datareader(impl_->reader);
  impl_->participant->release_topic(impl_->options.dds_topic);
  impl_->participant->remove_endpoint(impl_->gid);
}

std::size_t Reader::matched() const { return impl_->matches.count(); }
bool Reader::matched_with(const Gid& writer) const { return impl_->matches.contains(writer); }
bool Reader::wait_for_matched(std::size_t count, std::chrono::nanoseconds timeout) const {
  return impl_->matches.wait_for(count, timeout);
}
const Gid& Reader::gid() const { return impl_->gid; }

}  // namespace goalnet::ros
