// What a participant tells ROS 2 tools about its nodes: the content of the topic ros_discovery_info.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/ros/context.h"
#include "components/ros/endpoint.h"

namespace goalnet::ros::detail {

struct GraphNode {
  std::string node_namespace;
  std::string name;
  std::vector<Gid> readers;  // in order of creation
  std::vector<Gid> writers;
};

// "/robot_1/planner" from "/robot_1" and "planner"; "/planner" where the namespace is "/".
std::string full_name(const std::string& node_namespace, const std::string& name);

// Not thread-safe; the participant guards it.
class Graph {
 public:
  explicit Graph(const Gid& participant) : participant_(participant) {}

  void add_node(const std::string& node_namespace, const std::string& name);
  void remove_node(const std::string& full_name);
  // False if the node is unknown: then nothing changed.
  bool add(const std::string& node_full_name, const Gid& gid, bool is_writer);
  bool remove(const Gid& gid);

  // ParticipantEntitiesInfo in the layout of the distribution (a Gid has 24 bytes in Humble, 16 in Jazzy),
  // with encapsulation, little endian. `padding` fills what carries no data.
  std::vector<std::uint8_t> encode(Distro distro, std::uint8_t padding = 0) const;

  const std::vector<GraphNode>& nodes() const { return nodes_; }

 private:
  GraphNode* find(const std::string& full_name);
  Gid participant_;
  std::vector<GraphNode> nodes_;
};

// The inverse of Graph::encode. kInvalidRequest for malformed or unreasonably large content.
struct GraphMessage {
  Gid participant{};
  std::vector<GraphNode> nodes;
};
Expected<GraphMessage> decode_graph(std::span<const std::uint8_t> payload, Distro distro);

}  // namespace goalnet::ros::detail
