// Fast DDS 2.9 stops for ever where a reader leaves just while it is sent again what it has missed. The
// thread that repeats samples holds the lock of the queue of these and sends, for which it needs the lock of
// the writer's addresses; the thread that removes the reader holds the latter and removes what nobody waits
// for any more, for which it needs the former where that is still in the queue (docs/design/074). So a sample
// stays in the history while it is in that queue: with the writer's depth, or with the writer, it goes later.
#pragma once

#include <fastdds/rtps/writer/WriterListener.h>

#include <memory>

namespace goalnet::ros::detail {

// Stands between a writer of Fast DDS and its listener. Must outlive the writer.
class QueuedChanges : public eprosima::fastrtps::rtps::WriterListener {
 public:
  // nullptr where this process has no such writer.
  static std::unique_ptr<QueuedChanges> keep(const eprosima::fastrtps::rtps::GUID_t& writer);

  using Writer = eprosima::fastrtps::rtps::RTPSWriter;
  void onWriterMatched(Writer* writer, eprosima::fastrtps::rtps::MatchingInfo& info) override;
  void onWriterMatched(Writer* writer,
                       const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;
  void on_offered_incompatible_qos(Writer* writer, eprosima::fastdds::dds::PolicyMask qos) override;
  void onWriterChangeReceivedByAll(Writer* writer, eprosima::fastrtps::rtps::CacheChange_t* change) override;
  void on_liveliness_lost(Writer* writer, const eprosima::fastrtps::LivelinessLostStatus& status) override;
  void on_reader_discovery(Writer* writer,
                           eprosima::fastrtps::rtps::ReaderDiscoveryInfo::DISCOVERY_STATUS reason,
                           const eprosima::fastrtps::rtps::GUID_t& reader,
                           const eprosima::fastrtps::rtps::ReaderProxyData* data) override;

 private:
  explicit QueuedChanges(eprosima::fastrtps::rtps::WriterListener& next) : next_(next) {}
  eprosima::fastrtps::rtps::WriterListener& next_;
};

}  // namespace goalnet::ros::detail
