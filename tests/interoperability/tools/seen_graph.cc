#include "tests/interoperability/tools/seen_graph.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace goalnet::ros {
namespace {

std::string bytes_of(const std::string& digits) {
  std::string bytes;
  if (digits == "-") return bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return bytes;
}

GraphEndpoint read_endpoint(std::istringstream& words, bool is_writer) {
  GraphEndpoint one;
  std::string user_data;
  one.is_writer = is_writer;
  words >> one.guid >> one.participant >> one.topic >> one.type >> one.reliable >> one.transient_local >>
      one.deadline >> one.liveliness >> one.lease >> user_data;
  one.user_data = bytes_of(user_data);
  return one;
}

SeenNode read_node(std::istringstream& words) {
  SeenNode node;
  words >> node.participant >> node.node_namespace >> node.name;
  std::vector<std::string>* into = nullptr;
  for (std::string word; words >> word;) {
    if (word == "readers") {
      into = &node.readers;
    } else if (word == "writers") {
      into = &node.writers;
    } else {
      into->push_back(word);
    }
  }
  return node;
}

}  // namespace

std::vector<std::string> SeenGraph::node_names() const {
  std::vector<std::string> names;
  for (const SeenNode& node : nodes) names.push_back(node.full_name());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<const GraphEndpoint*> SeenGraph::on(const std::string& topic, bool is_writer) const {
  std::vector<const GraphEndpoint*> found;
  for (const auto& [guid, one] : endpoints) {
    if (one.topic == topic && one.is_writer == is_writer) found.push_back(&one);
  }
  return found;
}

bool SeenGraph::has(const SeenNode& node, const std::string& topic, const std::string& type,
                    bool is_writer) const {
  const auto& gids = is_writer ? node.writers : node.readers;
  return std::any_of(gids.begin(), gids.end(), [&](const std::string& gid) {
    const auto found = endpoints.find(gid);
    return found != endpoints.end() && found->second.topic == topic && found->second.type == type;
  });
}

std::vector<SeenGraph> seen_graphs(const std::string& output) {
  std::vector<SeenGraph> graphs;
  SeenGraph current;
  std::map<std::string, std::vector<SeenNode>> nodes;  // the last that each participant said
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "participant") {
      std::string guid, user_data;
      SeenParticipant one;
      words >> guid >> one.name >> user_data;
      one.user_data = bytes_of(user_data);
      current.participants[guid] = one;
    } else if (kind == "writer" || kind == "reader") {
      const GraphEndpoint one = read_endpoint(words, kind == "writer");
      current.endpoints[one.guid] = one;
    } else if (kind == "nodes") {
      std::string participant;
      words >> participant;
      nodes[participant].clear();
    } else if (kind == "node") {
      const SeenNode node = read_node(words);
      nodes[node.participant].push_back(node);
    } else if (kind == "end") {
      words >> current.seconds;
      for (const auto& [participant, list] : nodes)
        current.nodes.insert(current.nodes.end(), list.begin(), list.end());
      graphs.push_back(std::exchange(current, {}));
    }
  }
  return graphs;
}

SeenGraph fullest_graph(const std::string& output) {
  SeenGraph best;
  for (SeenGraph& graph : seen_graphs(output)) {
    if (graph.endpoints.size() >= best.endpoints.size()) best = std::move(graph);
  }
  return best;
}

}  // namespace goalnet::ros
