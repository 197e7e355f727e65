// A rosbag2 directory, being written: its files, split by size or time, and its metadata.yaml. Knows nothing
// of DDS.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"
#include "components/ros/bag/storage_writer.h"

namespace goalnet::ros {

struct BagWriterOptions {
  std::string directory;  // must not exist yet
  BagStorage storage = BagStorage::kMcap;
  StorageOptions file;
  std::uint64_t split_bytes = 0;               // a new file begins when one has this size; 0: never
  std::chrono::nanoseconds split_duration{0};  // or spans this time; 0: never
};

// One thread. What was flushed survives a crash of the process: the caller flushes at least once a second.
class BagWriter {
 public:
  // Makes the directory, its first file and metadata.yaml. kInvalidRequest if it exists or cannot be made.
  static Expected<std::unique_ptr<BagWriter>> create(const BagWriterOptions& options);
  ~BagWriter();  // closes
  BagWriter(const BagWriter&) = delete;

  // Returns the topic's index. kInternal where the disk is full.
  Expected<std::size_t> add_topic(const BagTopic& topic);
  // Publishers that came later: metadata.yaml lists them too.
  void set_offered(std::size_t topic, std::vector<OfferedQos> offered);
  // `payload` with encapsulation; times in ns. kInternal where the disk is full.
  Expected<void> write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                       std::span<const std::uint8_t> payload);
  // Everything so far to the files, and metadata.yaml brought up to date.
  Expected<void> flush();
  // Completes the last file and the metadata; nothing can be written afterwards. Safe to call twice.
  Expected<void> close();

  const BagMetadata& metadata() const { return metadata_; }
  std::uint64_t message_count() const { return metadata_.message_count(); }
  std::uint64_t size() const;  // [bytes] of all files, about

 private:
  explicit BagWriter(const BagWriterOptions& options) : options_(options) {}
  Expected<void> begin_file();
  Expected<void> end_file();
  bool full(std::uint64_t log_time) const;

  const BagWriterOptions options_;
  BagMetadata metadata_;
  std::unique_ptr<StorageWriter> file_;
  std::uint64_t size_of_ended_ = 0;
};

// Replaces DIRECTORY/metadata.yaml: readers see the old one or the new one, never half of it.
Expected<void> write_bag_metadata(const std::string& directory, const BagMetadata& metadata, Distro distro);

}  // namespace goalnet::ros
