#include "components/ros/bag/bag_metadata.h"

#include <fmt/format.h>

namespace goalnet::ros {
namespace {

constexpr const char* kForever = "sec: 9223372036\n    nsec: 854775807";

std::string span(std::chrono::nanoseconds value) {
  if (value.count() <= 0) return kForever;
  return fmt::format("sec: {}\n    nsec: {}", value.count() / 1'000'000'000, value.count() % 1'000'000'000);
}

std::string indented(const std::string& text, const std::string& by) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    const auto end = std::min(text.find('\n', at), text.size());
    out += by + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return out;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\\n") : std::string(1, c);
  return out;
}

}  // namespace

std::string qos_yaml(const Qos& qos, Distro distro) {
  const bool words = distro == Distro::kJazzy;
  const std::string history = words ? (qos.keep_all ? "keep_all" : "keep_last") : (qos.keep_all ? "2" : "1");
  const std::string reliability =
      words ? (qos.reliable ? "reliable" : "best_effort") : (qos.reliable ? "1" : "2");
  const std::string durability =
      words ? (qos.transient_local ? "transient_local" : "volatile") : (qos.transient_local ? "1" : "2");
  return fmt::format(
      "- history: {}\n  depth: {}\n  reliability: {}\n  durability: {}\n  deadline:\n    {}\n  lifespan:\n   "
      " {}\n"
      "  liveliness: {}\n  liveliness_lease_duration:\n    {}\n  avoid_ros_namespace_conventions: false",
      history, qos.depth, reliability, durability, span(qos.deadline), span(qos.lifespan),
      words ? "automatic" : "1", kForever);
}

std::string bag_metadata(const BagSummary& summary, Distro distro) {
  const bool jazzy = distro == Distro::kJazzy;
  std::uint64_t messages = 0;
  for (const BagTopic& topic : summary.topics) messages += topic.message_count;
  std::string out = fmt::format(
      "rosbag2_bagfile_information:\n  version: {}\n  storage_identifier: mcap\n  duration:\n    "
      "nanoseconds: {}\n"
      "  starting_time:\n    nanoseconds_since_epoch: {}\n  message_count: {}\n  "
      "topics_with_message_count:{}\n",
      jazzy ? 9 : 5, summary.duration, summary.start, messages, summary.topics.empty() ? " []" : "");
  for (const BagTopic& topic : summary.topics) {
    out += fmt::format(
        "    - topic_metadata:\n        name: {}\n        type: {}\n        serialization_format: cdr\n",
        topic.name, topic.type);
    if (jazzy) {
      out += "        offered_qos_profiles:\n" + indented(qos_yaml(topic.qos, distro), "          ");
      out += fmt::format("        type_description_hash: {}\n", topic.type_hash);
    } else {
      out += fmt::format("        offered_qos_profiles: \"{}\"\n", escaped(qos_yaml(topic.qos, distro)));
    }
    out += fmt::format("      message_count: {}\n", topic.message_count);
  }
  out += fmt::format(
      "  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n    - {0}\n  files:\n   "
      " - path: {0}\n"
      "      starting_time:\n        nanoseconds_since_epoch: {1}\n      duration:\n        nanoseconds: "
      "{2}\n"
      "      message_count: {3}\n",
      summary.file, summary.start, summary.duration, messages);
  if (jazzy) out += "  custom_data: ~\n  ros_distro: jazzy\n";
  return out;
}

}  // namespace goalnet::ros
