#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/dds/publisher/DataWriterListener.hpp>

#include "components/ros/detail/matches.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"
#include "components/ros/detail/queued_changes.h"
#include "components/ros/endpoint.h"

namespace goalnet::ros {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

namespace {

rtps::WriteParams to_params(const SampleId& related) {
  rtps::WriteParams params;
  params.related_sample_identity().writer_guid(detail::to_guid(related.writer));
  params.related_sample_identity().sequence_number() = rtps::SequenceNumber_t(
      static_cast<std::int32_t>(related.sequence >> 32), static_cast<std::uint32_t>(related.sequence));
  return params;
}

}  // namespace

EndpointOptions EndpointOptions::of(const idl::TypeSupport& support, std::string dds_topic, const Qos& qos,
                                    std::string node) {
  return {std::move(dds_topic), support.dds_name, support.description->hash, &support, qos, std::move(node)};
}

struct Writer::Impl : dds::DataWriterListener {
  std::shared_ptr<detail::Participant> participant;
  EndpointOptions options;
  dds::DataWriter* writer = nullptr;
  std::unique_ptr<detail::QueuedChanges> queued_changes;
  Gid gid{};
  detail::Matches matches;
  std::function<void()> on_matched;

  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
    matches.update(status.last_subscription_handle, status.current_count_change);
    if (on_matched) on_matched();
  }
};

Writer::Writer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Expected<std::shared_ptr<Writer>> Writer::create(const std::shared_ptr<detail::Participant>& participant,
                                                 const EndpointOptions& options,
                                                 std::function<void()> on_matched) {
  auto impl = std::make_unique<Impl>();
  impl->participant = participant;
  impl->options = options;
  impl->on_matched = std::move(on_matched);
  auto topic = participant->acquire_topic(options.dds_topic, options.dds_type);
  if (!topic) return tl::unexpected(topic.error());
  const auto qos = detail::writer_qos(
      options.qos, detail::endpoint_user_data(participant->settings().distro, options.type_hash),
      options.heartbeat);
  impl->writer = participant->publisher().create_datawriter(*topic, qos, impl.get(),
                                                            dds::StatusMask::publication_matched());
  if (impl->writer == nullptr) {
    participant->release_topic(options.dds_topic);
    return fail(Outcome::kInternal, "Fast DDS cannot make a writer for " + options.dds_topic);
  }
  // Other writers keep what all readers have, or repeat nothing.
  if (options.qos.reliable && !options.qos.transient_local)
    impl->queued_changes = detail::QueuedChanges::keep(impl->writer->guid());
  impl->gid = detail::to_gid(impl->writer->guid());
  participant->written().note(
      options.dds_topic, impl->gid,
      {options.dds_type, options.type_hash, {.qos = options.qos, .history_known = true}});
  participant->add_endpoint(options.node, impl->gid, true);
  participant->written().local_writer_made();
  return std::shared_ptr<Writer>(new Writer(std::move(impl)));
}

Writer::~Writer() {
  impl_->participant->written().forget(impl_->options.dds_topic, impl_->gid);
  impl_->writer->set_listener(nullptr);
  // Fast DDS 2.9 gives back what is still unread while its heartbeat may be going through it, and then looks
  // for the end of that list for ever: nothing may be left when a writer goes.
  std::size_t dropped = 0;
  impl_->writer->clear_history(&dropped);
  impl_->participant->publisher().delete_datawriter(impl_->writer);
  impl_->participant->release_topic(impl_->options.dds_topic);
  impl_->participant->remove_endpoint(impl_->gid);
}

bool Writer::write(const void* message) {
  detail::Outgoing out;
  out.support = impl_->options.support;
  out.message = message;
  return impl_->writer->write(&out);
}

bool Writer::write_related(const void* message, const SampleId& related, SampleId* id) {
  detail::Outgoing out;
  out.support = impl_->options.support;
  out.message = message;
  rtps::WriteParams params = to_params(related);
  if (!impl_->writer->write(&out, params)) return false;
  if (id != nullptr) {
    id->writer = detail::to_gid(params.sample_identity().writer_guid());
    id->sequence = static_cast<std::int64_t>(params.sample_identity().sequence_number().to64long());
  }
  return true;
}

bool Writer::write_raw(std::span<const std::uint8_t> payload, const SampleId* related) {
  detail::Outgoing out;
  out.payload = payload;
  if (related == nullptr) return impl_->writer->write(&out);
  rtps::WriteParams params = to_params(*related);
  return impl_->writer->write(&out, params);
}

std::size_t Writer::matched() const { return impl_->matches.count(); }
bool Writer::matched_with(const Gid& reader) const { return impl_->matches.contains(reader); }
std::vector<Gid> Writer::matched_readers() const { return impl_->matches.all(); }
bool Writer::wait_for_matched(std::size_t count, std::chrono::nanoseconds timeout) const {
  return impl_->matches.wait_for(count, timeout);
}

bool Writer::wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(timeout);
  const eprosima::fastrtps::Duration_t limit(static_cast<std::int32_t>(seconds.count()),
                                             static_cast<std::uint32_t>((timeout - seconds).count()));
  return impl_->writer->wait_for_acknowledgments(limit) == ReturnCode_t::RETCODE_OK;
}

const Gid& Writer::gid() const { return impl_->gid; }

}  // namespace goalnet::ros
