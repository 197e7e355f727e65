#include "components/ros/detail/graph_peers.h"

#include <algorithm>

namespace goalnet::ros::detail {
namespace {

// What a hostile peer can make us remember.
constexpr std::size_t kMostParticipants = 1000;
constexpr std::size_t kMostNodesEach = 200;
constexpr std::size_t kLargestMessage = 1u << 20;  // [bytes]
constexpr std::size_t kMostTold = 100;

}  // namespace

GraphPeers::Prefix GraphPeers::prefix_of(const Gid& gid) {
  Prefix prefix;
  std::copy_n(gid.begin(), prefix.size(), prefix.begin());
  return prefix;
}

std::optional<std::string> GraphPeers::once(std::string text) {
  if (told_.size() >= kMostTold || !told_.insert(text).second) return std::nullopt;
  return text;
}

std::optional<std::string> GraphPeers::take(std::span<const std::uint8_t> payload) {
  std::lock_guard lock(mutex_);
  if (payload.size() > kLargestMessage) return once("dropped an unreasonably large ros_discovery_info");
  const auto message = decode_graph(payload, distro_);
  if (!message || message->nodes.empty()) {
    // A message in the longer layout looks like one without nodes in the shorter.
    const Distro other = distro_ == Distro::kJazzy ? Distro::kHumble : Distro::kJazzy;
    const auto in_other = decode_graph(payload, other);
    if (in_other && !in_other->nodes.empty()) {
      return once("a participant on this domain uses the layout of ROS 2 " + std::string(to_string(other)) +
                  ": topics flow, but neither side sees the other's node names; GOALNET_ROS_DISTRO selects "
                  "the layout");
    }
    if (!message) return once(message.error().message);
  }
  const Prefix prefix = prefix_of(message->participant);
  if (nodes_.size() >= kMostParticipants && !nodes_.contains(prefix)) return std::nullopt;
  std::vector<std::string>& names = nodes_[prefix];
  names.clear();
  std::optional<std::string> report;
  for (const GraphNode& node : message->nodes) {
    if (names.size() >= kMostNodesEach) break;
    names.push_back(full_name(node.node_namespace, node.name));
    if (!report && own_.contains(names.back())) {
      report = once(
          "another program has a node called " + names.back() +
          " as well; give one of them another name (-r __node:=NAME) or namespace (-r __ns:=/NAMESPACE)");
    }
  }
  if (names.empty()) nodes_.erase(prefix);
  return report;
}

void GraphPeers::forget(const Gid& participant) {
  std::lock_guard lock(mutex_);
  nodes_.erase(prefix_of(participant));
}

void GraphPeers::add_own(const std::string& name) {
  std::lock_guard lock(mutex_);
  own_.insert(name);
}

void GraphPeers::remove_own(const std::string& name) {
  std::lock_guard lock(mutex_);
  if (const auto found = own_.find(name); found != own_.end()) own_.erase(found);
}

std::vector<std::string> GraphPeers::names() const {
  std::lock_guard lock(mutex_);
  std::vector<std::string> all;
  for (const auto& [prefix, names] : nodes_) all.insert(all.end(), names.begin(), names.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace goalnet::ros::detail
