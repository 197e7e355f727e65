// What cyclone_graph saw of a domain, as the middleware of a ROS 2 tool would remember it (rmw_dds_common's
// graph cache): participants, their endpoints, and the nodes that ros_discovery_info names.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace goalnet::ros {

struct SeenParticipant {
  std::string name, user_data;
};

// GUIDs in hexadecimal digits everywhere.
struct GraphEndpoint {
  std::string guid, participant;
  bool is_writer = false;
  std::string topic, type;
  bool reliable = false, transient_local = false;
  std::string deadline;  // [s], or "infinite"
  int liveliness = 0;    // 0: automatic
  std::string lease, user_data;
};

struct SeenNode {
  std::string participant, node_namespace, name;
  std::vector<std::string> readers, writers;
  std::string full_name() const { return (node_namespace == "/" ? "" : node_namespace) + "/" + name; }
};

struct SeenGraph {
  std::map<std::string, SeenParticipant> participants;  // by GUID
  std::map<std::string, GraphEndpoint> endpoints;       // by GUID
  std::vector<SeenNode> nodes;
  double seconds = 0.0;  // since the start of cyclone_graph

  std::vector<std::string> node_names() const;  // full names, sorted, doubles kept
  // Endpoints on a DDS topic.
  std::vector<const GraphEndpoint*> on(const std::string& topic, bool is_writer) const;
  // Endpoints of a node on a DDS topic.
  bool has(const SeenNode& node, const std::string& topic, const std::string& type, bool is_writer) const;
};

// The snapshots in the output of cyclone_graph, in order.
std::vector<SeenGraph> seen_graphs(const std::string& output);
// The last one of those with the most endpoints.
SeenGraph fullest_graph(const std::string& output);

}  // namespace goalnet::ros
