// What other participants say about their nodes, in both layouts.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/detail/graph.h"
#include "components/ros/detail/graph_peers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  for (const Distro distro : {Distro::kHumble, Distro::kJazzy}) {
    detail::GraphPeers peers(distro);
    peers.add_own("/robot");
    peers.take({data, size});
    if (peers.take({data, size})) std::abort();  // everything is said once
    const auto message = detail::decode_graph({data, size}, distro);
    if (!message) continue;
    // What was understood is written and understood again.
    detail::Graph graph(message->participant);
    for (const auto& node : message->nodes) graph.add_node(node.node_namespace, node.name);
    const auto again = detail::decode_graph(graph.encode(distro), distro);
    if (!again || again->nodes.size() != message->nodes.size()) std::abort();
  }
  return 0;
}
