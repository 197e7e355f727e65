// metadata.yaml of a rosbag2 directory, in the version that the chosen distribution reads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_topic.h"
#include "components/ros/context.h"

namespace goalnet::ros {

enum class BagStorage { kMcap, kSqlite };
// "mcap" or "sqlite3", as `ros2 bag record --storage` calls them; kInvalidRequest for anything else.
Expected<BagStorage> parse_bag_storage(std::string_view name);
std::string_view to_string(BagStorage storage);
std::string_view bag_file_extension(BagStorage storage);  // .mcap, .db3

// Times of a file or bag without messages are those of rosbag2: the latest start there is, and no duration.
inline constexpr std::uint64_t kNoStart = 9'223'372'036'854'775'807u;

struct BagFile {
  std::string path;                // relative to the directory
  std::uint64_t start = kNoStart;  // [ns] first message
  std::uint64_t duration = 0;      // [ns]
  std::uint64_t message_count = 0;
};

struct BagMetadata {
  BagStorage storage = BagStorage::kMcap;
  std::vector<BagFile> files;
  std::vector<BagTopic> topics;  // definitions are not part of the file
  std::string compression_format,
      compression_mode;  // rosbag2's own, of whole files or messages; usually none

  std::uint64_t start() const;     // [ns] earliest of all files
  std::uint64_t duration() const;  // [ns] from there to the last message of all files
  std::uint64_t message_count() const;
};

// Version 9 for Jazzy, 5 for Humble (which cannot read 9). No newline at its end, as rosbag2 writes it.
std::string bag_metadata_yaml(const BagMetadata& metadata, Distro distro);

// The same without its top-level key, as Jazzy stores it inside bag files.
std::string embedded_metadata_yaml(const BagMetadata& metadata, Distro distro);

// Reads versions 1 to 9. kInvalidRequest with one message for anything else, also for paths that leave the
// directory.
Expected<BagMetadata> parse_bag_metadata(const std::string& yaml);

}  // namespace goalnet::ros
