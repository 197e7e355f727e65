// Which endpoints on the other side an endpoint is matched with; waiting for them.
#pragma once

#include <fastdds/rtps/common/InstanceHandle.h>
#include <fastdds/dds/core/status/BaseStatus.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "components/ros/detail/participant.h"
#include "components/ros/endpoint.h"

namespace goalnet::ros::detail {

// Thread-safe.
class Matches {
 public:
  // As a listener is told: `change` +1 or -1. Returns how many there are now.
  std::size_t update(const eprosima::fastrtps::rtps::InstanceHandle_t& handle, int change) {
    eprosima::fastrtps::rtps::GUID_t guid;
    eprosima::fastrtps::rtps::iHandle2GUID(guid, handle);
    const Gid gid = to_gid(guid);
    std::size_t count = 0;
    {
      std::lock_guard lock(mutex_);
      std::erase(gids_, gid);
      if (change > 0) gids_.push_back(gid);
      count = gids_.size();
    }
    changed_.notify_all();
    return count;
  }

  std::size_t count() const {
    std::lock_guard lock(mutex_);
    return gids_.size();
  }

  bool contains(const Gid& gid) const {
    std::lock_guard lock(mutex_);
    return std::find(gids_.begin(), gids_.end(), gid) != gids_.end();
  }

  std::vector<Gid> all() const {
    std::lock_guard lock(mutex_);
    return gids_;
  }

  bool wait_for(std::size_t count, std::chrono::nanoseconds timeout) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [&] { return gids_.size() >= count; });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::vector<Gid> gids_;
};

}  // namespace goalnet::ros::detail
