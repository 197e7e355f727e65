// What other participants say about their nodes on ros_discovery_info. Knows no DDS.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "components/ros/detail/graph.h"

namespace goalnet::ros::detail {

// Thread-safe; takes no other lock, so that it may be called from any listener.
class GraphPeers {
 public:
  explicit GraphPeers(Distro distro) : distro_(distro) {}

  // A payload as received. Returns what is to be told to people, each thing once: a malformed message, one in
  // the other distribution's layout, a node of somebody else that bears the name of ours.
  std::optional<std::string> take(std::span<const std::uint8_t> payload);
  // A participant left; `participant` may be the Gid of any of its endpoints.
  void forget(const Gid& participant);

  void add_own(const std::string& full_name);
  void remove_own(const std::string& full_name);

  // Full names of the nodes of other participants, sorted.
  std::vector<std::string> names() const;

 private:
  using Prefix = std::array<std::uint8_t, 12>;  // what all Gids of a participant begin with
  static Prefix prefix_of(const Gid& gid);
  std::optional<std::string> once(std::string text);

  const Distro distro_;
  mutable std::mutex mutex_;
  std::map<Prefix, std::vector<std::string>> nodes_;  // bounded
  std::multiset<std::string> own_;
  std::set<std::string> told_;  // bounded
};

}  // namespace goalnet::ros::detail
