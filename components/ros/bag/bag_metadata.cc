#include "components/ros/bag/bag_metadata.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "components/ros/bag/offered_qos.h"

namespace goalnet::ros {
namespace {

constexpr std::size_t kMostTopics = 100'000, kMostFiles = 100'000;

// Plain where that is safe, else in double quotes.
std::string scalar(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '/' || c == '.' || c == '-';
  }) && text[0] != '-';
  if (plain) return text;
  std::string out = "\"";
  for (const unsigned char c : text) {
    if (c == '\n') {
      out += "\\n";
    } else if (c == '"' || c == '\\') {
      out += {'\\', static_cast<char>(c)};
    } else if (c < 0x20) {
      out += fmt::format("\\x{:02x}", c);
    } else {
      out += static_cast<char>(c);
    }
  }
  return out + "\"";
}

std::string indented(const std::string& text, std::size_t by) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    const auto end = std::min(text.find('\n', at), text.size());
    out += std::string(by, ' ') + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return out;
}

std::string topic_yaml(const BagTopic& topic, Distro distro) {
  std::string out =
      fmt::format("  - topic_metadata:\n      name: {}\n      type: {}\n      serialization_format: {}\n",
                  scalar(topic.name), scalar(topic.type), scalar(topic.serialization_format));
  const std::string qos = offered_qos_yaml(topic.offered, distro);
  if (distro == Distro::kJazzy) {
    out += "      offered_qos_profiles:" + (topic.offered.empty() ? " []\n" : "\n" + indented(qos, 8));
    out += "      type_description_hash: " + scalar(topic.type_hash) + "\n";
  } else {
    out += "      offered_qos_profiles: " + scalar(topic.offered.empty() ? "" : qos) + "\n";
  }
  return out + fmt::format("    message_count: {}\n", topic.message_count);
}

BagFile parse_file(const YAML::Node& node) {
  BagFile file;
  file.path = node["path"].as<std::string>();
  file.start = node["starting_time"]["nanoseconds_since_epoch"].as<std::uint64_t>();
  file.duration = node["duration"]["nanoseconds"].as<std::uint64_t>();
  file.message_count = node["message_count"].as<std::uint64_t>();
  return file;
}

BagTopic parse_topic(const YAML::Node& node) {
  const YAML::Node about = node["topic_metadata"];
  BagTopic topic;
  topic.name = about["name"].as<std::string>();
  topic.type = about["type"].as<std::string>();
  topic.serialization_format = about["serialization_format"].as<std::string>();
  topic.message_count = node["message_count"].as<std::uint64_t>();
  if (const YAML::Node hash = about["type_description_hash"]) topic.type_hash = hash.as<std::string>("");
  if (const YAML::Node qos = about["offered_qos_profiles"]) {
    // A list in version 9, a text with a list in it before.
    auto offered = parse_offered_qos(qos.IsScalar() ? qos.as<std::string>() : YAML::Dump(qos));
    if (!offered)
      throw YAML::Exception(qos.Mark(), topic.name.substr(0, 80) + ": " + offered.error().message);
    topic.offered = std::move(*offered);
  }
  return topic;
}

// A metadata file may only name files of its own directory.
bool inside(const std::string& path) {
  return !path.empty() && path[0] != '/' && path.find("..") == std::string::npos &&
         path.find('\0') == std::string::npos;
}

BagMetadata parse(const YAML::Node& info) {
  BagMetadata metadata;
  if (const int version = info["version"].as<int>(); version < 1 || version > 9) {
    throw YAML::Exception(info["version"].Mark(),
                          fmt::format("version {} is unknown (1 to 9 are read)", version));
  }
  auto storage = parse_bag_storage(info["storage_identifier"].as<std::string>());
  if (!storage) throw YAML::Exception(info["storage_identifier"].Mark(), storage.error().message);
  metadata.storage = *storage;
  const YAML::Node topics = info["topics_with_message_count"], files = info["files"],
                   paths = info["relative_file_paths"];
  if (topics.size() > kMostTopics || files.size() > kMostFiles || paths.size() > kMostFiles) {
    throw YAML::Exception(info.Mark(), "it lists more topics or files than anybody records");
  }
  for (const YAML::Node& topic : topics) metadata.topics.push_back(parse_topic(topic));
  for (const YAML::Node& file : files) metadata.files.push_back(parse_file(file));
  if (metadata.files.empty()) {  // versions before 5
    for (const YAML::Node& path : paths) metadata.files.push_back({path.as<std::string>(), kNoStart, 0, 0});
  }
  for (const BagFile& file : metadata.files) {
    if (!inside(file.path)) throw YAML::Exception(files.Mark(), "a file lies outside of the bag's directory");
  }
  metadata.compression_format = info["compression_format"].as<std::string>("");
  metadata.compression_mode = info["compression_mode"].as<std::string>("");
  return metadata;
}

}  // namespace

Expected<BagStorage> parse_bag_storage(std::string_view name) {
  if (name == "mcap") return BagStorage::kMcap;
  if (name == "sqlite3") return BagStorage::kSqlite;
  return fail(Outcome::kInvalidRequest, "there is no bag storage \"" + std::string(name.substr(0, 40)) +
                                            "\"; there are mcap and sqlite3");
}

std::string_view to_string(BagStorage storage) { return storage == BagStorage::kMcap ? "mcap" : "sqlite3"; }
std::string_view bag_file_extension(BagStorage storage) {
  return storage == BagStorage::kMcap ? ".mcap" : ".db3";
}

std::uint64_t BagMetadata::start() const {
  std::uint64_t earliest = kNoStart;
  for (const BagFile& file : files) earliest = std::min(earliest, file.start);
  return earliest;
}

std::uint64_t BagMetadata::duration() const {
  std::uint64_t latest = start();
  for (const BagFile& file : files) {
    if (file.message_count > 0) latest = std::max(latest, file.start + file.duration);
  }
  return latest - start();
}

std::uint64_t BagMetadata::message_count() const {
  std::uint64_t count = 0;
  for (const BagFile& file : files) count += file.message_count;
  return count;
}

std::string embedded_metadata_yaml(const BagMetadata& metadata, Distro distro) {
  const bool jazzy = distro == Distro::kJazzy;
  std::string out = fmt::format(
      "version: {}\nstorage_identifier: {}\nduration:\n  nanoseconds: {}\nstarting_time:\n  "
      "nanoseconds_since_epoch: {}\nmessage_count: {}\ntopics_with_message_count:\n",
      jazzy ? 9 : 5, to_string(metadata.storage), metadata.duration(), metadata.start(),
      metadata.message_count());
  if (metadata.topics.empty()) out += "  []\n";
  for (const BagTopic& topic : metadata.topics) out += topic_yaml(topic, distro);
  out += fmt::format("compression_format: {}\ncompression_mode: {}\nrelative_file_paths:\n",
                     scalar(metadata.compression_format), scalar(metadata.compression_mode));
  for (const BagFile& file : metadata.files) out += "  - " + scalar(file.path) + "\n";
  out += "files:\n";
  for (const BagFile& file : metadata.files) {
    out += fmt::format(
        "  - path: {}\n    starting_time:\n      nanoseconds_since_epoch: {}\n    duration:\n      "
        "nanoseconds: "
        "{}\n    message_count: {}\n",
        scalar(file.path), file.start, file.duration, file.message_count);
  }
  if (jazzy) out += "custom_data: ~\nros_distro: jazzy\n";
  out.pop_back();
  return out;
}

std::string bag_metadata_yaml(const BagMetadata& metadata, Distro distro) {
  std::string out = "rosbag2_bagfile_information:\n" + indented(embedded_metadata_yaml(metadata, distro), 2);
  out.pop_back();
  return out;
}

Expected<BagMetadata> parse_bag_metadata(const std::string& yaml) {
  constexpr std::size_t kLargest = 64u << 20;
  if (yaml.size() > kLargest) return fail(Outcome::kInvalidRequest, "it is larger than 64 MiB");
  try {
    const YAML::Node document = YAML::Load(yaml);
    if (!document.IsMap() || !document["rosbag2_bagfile_information"]) {
      return fail(Outcome::kInvalidRequest, "it has no rosbag2_bagfile_information");
    }
    return parse(document["rosbag2_bagfile_information"]);
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest, error.what());
  }
}

}  // namespace goalnet::ros
