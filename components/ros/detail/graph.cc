#include "components/ros/detail/graph.h"

#include <algorithm>
#include <cstring>

namespace goalnet::ros::detail {
namespace {

constexpr std::size_t kMostNodes = 1024;           // per participant
constexpr std::size_t kMostEndpoints = 16 * 1024;  // per node
constexpr std::size_t kLongestName = 256;

std::size_t gid_size(Distro distro) { return distro == Distro::kHumble ? 24 : 16; }

class Encoder {
 public:
  Encoder(std::size_t gid_bytes, std::uint8_t padding) : gid_bytes_(gid_bytes), padding_(padding) {
    bytes_ = {0, 1, 0, 0};
  }
  void gid(const Gid& gid) {
    bytes_.insert(bytes_.end(), gid.begin(), gid.end());
    bytes_.resize(bytes_.size() + gid_bytes_ - gid.size());
  }
  void number(std::size_t value) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(padding_);
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  void text(const std::string& text) {
    number(text.size() + 1);
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::size_t gid_bytes_;
  std::uint8_t padding_;
  std::vector<std::uint8_t> bytes_;
};

class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> bytes, std::size_t gid_bytes)
      : bytes_(bytes), gid_bytes_(gid_bytes), swap_(bytes[1] == 0) {}
  bool gid(Gid& gid) {
    if (bytes_.size() - at_ < gid_bytes_) return false;
    std::memcpy(gid.data(), bytes_.data() + at_, gid.size());
    at_ += gid_bytes_;
    return true;
  }
  bool number(std::uint32_t& value) {
    at_ += (4 - at_ % 4) % 4;
    if (at_ > bytes_.size() || bytes_.size() - at_ < 4) return false;
    std::memcpy(&value, bytes_.data() + at_, 4);
    if (swap_) value = __builtin_bswap32(value);
    at_ += 4;
    return true;
  }
  bool text(std::string& text) {
    std::uint32_t length = 0;
    if (!number(length) || length > kLongestName + 1 || length > bytes_.size() - at_) return false;
    text.assign(reinterpret_cast<const char*>(bytes_.data()) + at_, length);
    if (!text.empty() && text.back() == '\0') text.pop_back();
    at_ += length;
    return true;
  }
  bool gids(std::vector<Gid>& gids) {
    std::uint32_t count = 0;
    if (!number(count) || count > kMostEndpoints || count > (bytes_.size() - at_) / gid_bytes_) return false;
    gids.resize(count);
    return std::all_of(gids.begin(), gids.end(), [this](Gid& one) { return gid(one); });
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t gid_bytes_;
  bool swap_;
  std::size_t at_ = 4;
};

std::string join(const GraphNode& node) { return full_name(node.node_namespace, node.name); }

}  // namespace

std::string full_name(const std::string& node_namespace, const std::string& name) {
  return (node_namespace == "/" ? "" : node_namespace) + "/" + name;
}

GraphNode* Graph::find(const std::string& full_name) {
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](const auto& node) { return join(node) == full_name; });
  return found == nodes_.end() ? nullptr : &*found;
}

void Graph::add_node(const std::string& node_namespace, const std::string& name) {
  nodes_.push_back({node_namespace, name, {}, {}});
}

void Graph::remove_node(const std::string& full_name) {
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](const auto& node) { return join(node) == full_name; });
  if (found != nodes_.end()) nodes_.erase(found);
}

bool Graph::add(const std::string& node_full_name, const Gid& gid, bool is_writer) {
  GraphNode* node = find(node_full_name);
  if (node == nullptr) return false;
  (is_writer ? node->writers : node->readers).push_back(gid);
  return true;
}

bool Graph::remove(const Gid& gid) {
  std::size_t removed = 0;
  for (GraphNode& node : nodes_) removed += std::erase(node.readers, gid) + std::erase(node.writers, gid);
  return removed > 0;
}

std::vector<std::uint8_t> Graph::encode(Distro distro, std::uint8_t padding) const {
  Encoder out(gid_size(distro), padding);
  out.gid(participant_);
  out.number(nodes_.size());
  for (const GraphNode& node : nodes_) {
    out.text(node.node_namespace);
    out.text(node.name);
    for (const auto* gids : {&node.readers, &node.writers}) {
      out.number(gids->size());
      for (const Gid& gid : *gids) out.gid(gid);
    }
  }
  return out.take();
}

Expected<GraphMessage> decode_graph(std::span<const std::uint8_t> payload, Distro distro) {
  const auto malformed = [] {
    return fail(Outcome::kInvalidRequest, "malformed ros_discovery_info; dropped");
  };
  if (payload.size() < 4 || payload[0] != 0 || payload[1] > 1) return malformed();
  Decoder in(payload, gid_size(distro));
  GraphMessage message;
  std::uint32_t count = 0;
  if (!in.gid(message.participant) || !in.number(count) || count > kMostNodes) return malformed();
  for (std::uint32_t i = 0; i < count; ++i) {
    GraphNode node;
    if (!in.text(node.node_namespace) || !in.text(node.name) || !in.gids(node.readers) ||
        !in.gids(node.writers)) {
      return malformed();
    }
    message.nodes.push_back(std::move(node));
  }
  return message;
}

}  // namespace goalnet::ros::detail
