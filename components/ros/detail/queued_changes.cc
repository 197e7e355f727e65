#include "components/ros/detail/queued_changes.h"

#include <fastdds/rtps/common/CacheChange.h>

#include <mutex>

#include "components/ros/detail/local_writer.h"

namespace goalnet::ros::detail {

namespace rtps = eprosima::fastrtps::rtps;

std::unique_ptr<QueuedChanges> QueuedChanges::keep(const rtps::GUID_t& guid) {
  rtps::RTPSWriter* writer = local_writer(guid);
  if (writer == nullptr) return nullptr;
  std::lock_guard lock(writer->getMutex());
  if (writer->getListener() == nullptr) return nullptr;
  std::unique_ptr<QueuedChanges> self(new QueuedChanges(*writer->getListener()));
  writer->set_listener(self.get());
  return self;
}

void QueuedChanges::onWriterChangeReceivedByAll(Writer* writer, rtps::CacheChange_t* change) {
  // Under the writer's lock, without which no sample gets into the queue.
  if (!change->writer_info.is_linked) next_.onWriterChangeReceivedByAll(writer, change);
}

void QueuedChanges::onWriterMatched(Writer* writer, rtps::MatchingInfo& info) {
  next_.onWriterMatched(writer, info);
}

void QueuedChanges::onWriterMatched(Writer* writer,
                                    const eprosima::fastdds::dds::PublicationMatchedStatus& status) {
  next_.onWriterMatched(writer, status);
}

void QueuedChanges::on_offered_incompatible_qos(Writer* writer, eprosima::fastdds::dds::PolicyMask qos) {
  next_.on_offered_incompatible_qos(writer, qos);
}

void QueuedChanges::on_liveliness_lost(Writer* writer,
                                       const eprosima::fastrtps::LivelinessLostStatus& status) {
  next_.on_liveliness_lost(writer, status);
}

void QueuedChanges::on_reader_discovery(Writer* writer, rtps::ReaderDiscoveryInfo::DISCOVERY_STATUS reason,
                                        const rtps::GUID_t& reader, const rtps::ReaderProxyData* data) {
  next_.on_reader_discovery(writer, reason, reader, data);
}

}  // namespace goalnet::ros::detail
