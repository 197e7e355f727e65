// One file of a bag, being written. MCAP and SQLite fill this in.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"
#include "components/ros/bag/bag_topic.h"

namespace goalnet::ros {

// One thread. What was flushed can be read even if the process is killed afterwards. Errors are kInternal:
// the disk is full or gone.
class StorageWriter {
 public:
  virtual ~StorageWriter() = default;
  // Call it in order of the topics' indices, before the first message of each.
  virtual Expected<void> add_topic(const BagTopic& topic) = 0;
  // `topic` counts calls of add_topic(); `payload` with encapsulation; times in ns.
  virtual Expected<void> write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                               std::span<const std::uint8_t> payload) = 0;
  virtual Expected<void> flush() = 0;
  // Writes what makes the file complete, with the metadata that Jazzy wants inside; nothing can be written
  // afterwards. Messages that found no place on the disk are taken out of the counts of `metadata`, whose last
  // file is this one.
  virtual Expected<void> finish(BagMetadata& metadata) = 0;
  virtual std::uint64_t size() const = 0;  // [bytes] so far, about
};

struct StorageOptions {
  Distro distro = Distro::kJazzy;
  bool compress = false;  // MCAP: zstd
};

// Makes the file. kInvalidRequest if that is not possible. `metadata` is what is known at the start.
Expected<std::unique_ptr<StorageWriter>> create_mcap_writer(const std::string& path,
                                                            const BagMetadata& metadata,
                                                            const StorageOptions& options);
Expected<std::unique_ptr<StorageWriter>> create_sqlite_writer(const std::string& path,
                                                              const BagMetadata& metadata,
                                                              const StorageOptions& options);

}  // namespace goalnet::ros
