#include "components/ros/detail/participant.h"

namespace goalnet::ros::detail {
namespace {

namespace dds = eprosima::fastdds::dds;

eprosima::fastrtps::Duration_t to_duration(std::chrono::nanoseconds span) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(span);
  return eprosima::fastrtps::Duration_t(static_cast<std::int32_t>(seconds.count()),
                                        static_cast<std::uint32_t>((span - seconds).count()));
}

// rmw's 0 for "infinite".
std::chrono::nanoseconds to_nanoseconds(const eprosima::fastrtps::Duration_t& span) {
  if (span == eprosima::fastrtps::c_TimeInfinite || span.seconds < 0) return std::chrono::nanoseconds(0);
  return std::chrono::seconds(span.seconds) + std::chrono::nanoseconds(span.nanosec);
}

// What writers and readers have in common.
template <class DdsQos>
void fill(DdsQos& out, const Qos& qos, const std::string& user_data) {
  out.reliability().kind = qos.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  out.durability().kind =
      qos.transient_local ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  out.history().kind = qos.keep_all ? dds::KEEP_ALL_HISTORY_QOS : dds::KEEP_LAST_HISTORY_QOS;
  out.history().depth = static_cast<std::int32_t>(std::max<std::uint32_t>(qos.depth, 1));
  // Bounds what a history may hold; the defaults (5000) are below the depth of no profile in use.
  auto& limits = out.resource_limits();
  limits.max_samples = std::max(limits.max_samples, out.history().depth);
  limits.max_samples_per_instance = std::max(limits.max_samples_per_instance, out.history().depth);
  limits.allocated_samples = std::min<std::int32_t>(10, out.history().depth);
  if (qos.deadline.count() > 0) out.deadline().period = to_duration(qos.deadline);
  out.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  out.data_sharing().off();
  if (!user_data.empty()) out.user_data().data_vec({user_data.begin(), user_data.end()});
}

}  // namespace

Gid to_gid(const eprosima::fastrtps::rtps::GUID_t& guid) {
  Gid gid{};
  std::copy(guid.guidPrefix.value, guid.guidPrefix.value + 12, gid.begin());
  std::copy(guid.entityId.value, guid.entityId.value + 4, gid.begin() + 12);
  return gid;
}

eprosima::fastrtps::rtps::GUID_t to_guid(const Gid& gid) {
  eprosima::fastrtps::rtps::GUID_t guid;
  std::copy(gid.begin(), gid.begin() + 12, guid.guidPrefix.value);
  std::copy(gid.begin() + 12, gid.end(), guid.entityId.value);
  return guid;
}

dds::DataWriterQos writer_qos(const Qos& qos, const std::string& user_data,
                              std::chrono::milliseconds heartbeat) {
  dds::DataWriterQos out;
  fill(out, qos, user_data);
  out.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  // A reader that was not ready for the first message asks again at the next heartbeat: not after the default
  // of three seconds. Heartbeats are only sent while something is unacknowledged.
  out.reliable_writer_qos().times.heartbeatPeriod = to_duration(heartbeat);
  // For so long after a write nobody's wish for a repetition is heard. With Fast DDS's default of none, each
  // write wakes the event thread, which then waits for the writer's lock; so it is once in this time. Readers
  // ask for what they miss after heartbeats, and Fast DDS's own wait 5 ms before they do.
  out.reliable_writer_qos().times.nackSupressionDuration = to_duration(std::chrono::milliseconds(2));
  if (qos.lifespan.count() > 0) out.lifespan().duration = to_duration(qos.lifespan);
  return out;
}

dds::DataReaderQos reader_qos(const Qos& qos, const std::string& user_data) {
  dds::DataReaderQos out;
  fill(out, qos, user_data);
  return out;
}

OfferedQos offered_qos(const dds::WriterQos& qos) {
  OfferedQos out;
  out.qos.reliable = qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  out.qos.transient_local = qos.m_durability.kind != dds::VOLATILE_DURABILITY_QOS;
  out.qos.depth = 0;
  out.qos.lifespan = to_nanoseconds(qos.m_lifespan.duration);
  out.qos.deadline = to_nanoseconds(qos.m_deadline.period);
  out.liveliness = qos.m_liveliness.kind == dds::MANUAL_BY_PARTICIPANT_LIVELINESS_QOS ? 2
                   : qos.m_liveliness.kind == dds::MANUAL_BY_TOPIC_LIVELINESS_QOS     ? 3
                                                                                      : 1;
  out.liveliness_lease = to_nanoseconds(qos.m_liveliness.lease_duration);
  return out;
}

}  // namespace goalnet::ros::detail
