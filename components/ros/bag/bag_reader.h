// A rosbag2 directory, or one file of a bag, being read in order of time. Knows nothing of DDS.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"
#include "components/ros/bag/compressed_file.h"
#include "components/ros/bag/storage_reader.h"

namespace goalnet::ros {

// One thread. Errors are kInvalidRequest: one message with the file, the place and what is wrong there.
class BagReader {
 public:
  // `path`: a directory with metadata.yaml, or an .mcap or .db3 file. Reads what both distributions record,
  // MCAP and SQLite, also with rosbag2's own compression of whole files or of messages (zstd).
  static Expected<std::unique_ptr<BagReader>> open(const std::string& path);

  const std::vector<BagTopic>& topics() const { return topics_; }
  // The next message; files follow each other. False at the end.
  Expected<bool> next(BagMessage& message);
  // Starts again at the first message.
  Expected<void> rewind();
  // False where a recorder was killed, or still runs.
  bool finished() const { return finished_; }

 private:
  struct File {
    std::string path;
    BagStorage storage;
  };
  BagReader(std::vector<File> files, BagCompression compression)
      : files_(std::move(files)), compression_(compression) {}
  Expected<void> open_file_at(std::size_t index);

  std::vector<File> files_;
  BagCompression compression_;
  std::unique_ptr<TemporaryFile> plain_;  // the current file, where it was compressed
  std::vector<BagTopic> topics_;
  std::size_t current_ = 0;
  std::unique_ptr<StorageReader> reader_;
  std::vector<std::size_t> topic_map_;  // of the current file's topics into ours
  bool finished_ = true;
};

// Opens one file of a bag.
Expected<std::unique_ptr<StorageReader>> open_bag_file(const std::string& path, BagStorage storage);

// metadata.yaml of a directory; kInvalidRequest names the file.
Expected<BagMetadata> read_bag_metadata(const std::string& directory);

}  // namespace goalnet::ros
