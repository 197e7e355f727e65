#include "components/ros/detail/lease_checks.h"

#include <fastrtps/config.h>

#define GOALNET_FASTDDS_ASSERTS_LEASES (FASTRTPS_VERSION_MAJOR == 2 && FASTRTPS_VERSION_MINOR == 9)

#if GOALNET_FASTDDS_ASSERTS_LEASES
#include <dlfcn.h>
#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/builtin/discovery/participant/PDP.h>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/resources/TimedEvent.h>
#include <fastrtps/utils/TimeConversion.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace eprosima::fastrtps::rtps {

// On the timers' thread. Removes a participant that was silent for its whole lease, or sets the timer for
// when that would be so.
__attribute__((visibility("default"))) void PDP::check_remote_participant_liveliness(
    ParticipantProxyData* remote) {
  using std::chrono::duration;
  std::unique_lock lock(*getMutex());
  // It has left: its data waits for the next participant, or is another's already.
  if (!remote->should_check_lease_duration || remote->m_guid == GUID_t::unknown()) return;
  const auto lease =
      std::chrono::microseconds(TimeConv::Duration_t2MicroSecondsInt64(remote->m_leaseDuration));
  const auto left = remote->last_received_message_tm() + lease - std::chrono::steady_clock::now();
  if (left < left.zero()) {
    // Removing takes other locks, so not under this one; without it the data may become another's.
    const GUID_t gone = remote->m_guid;
    lock.unlock();
    remove_remote_participant(gone, ParticipantDiscoveryInfo::DROPPED_PARTICIPANT);
    return;
  }
  // Fast DDS' own cuts off to milliseconds, and spins through the last of them.
  remote->lease_duration_event->update_interval_millisec(
      std::max(1.0, duration<double, std::milli>(left).count()));
  remote->lease_duration_event->restart_timer();
}

}  // namespace eprosima::fastrtps::rtps

#endif

namespace goalnet::ros::detail {

bool lease_checks_are_ours() {
#if GOALNET_FASTDDS_ASSERTS_LEASES
  constexpr const char* kCheck =
      "_ZN8eprosima8fastrtps4rtps3PDP35check_remote_participant_livelinessEPNS1_20ParticipantProxyDataE";
  const void* found = dlsym(RTLD_DEFAULT, kCheck);
  Dl_info of_found{}, of_this{};
  return found != nullptr && dladdr(found, &of_found) != 0 &&
         dladdr(reinterpret_cast<const void*>(&lease_checks_are_ours), &of_this) != 0 &&
         of_found.dli_fbase == of_this.dli_fbase;
#else
  return true;
#endif
}

}  // namespace goalnet::ros::detail
