// One file of a bag, being read. MCAP and SQLite fill this in.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"
#include "components/ros/bag/bag_topic.h"
#include "components/ros/bag/byte_source.h"

namespace goalnet::ros {

// One thread. Whatever the file holds, memory stays bounded and errors are kInvalidRequest with one message.
class StorageReader {
 public:
  virtual ~StorageReader() = default;
  // With their definitions; message counts are those that the file claims, 0 where it does not.
  virtual const std::vector<BagTopic>& topics() const = 0;
  // The next message in order of log time; false at the end.
  virtual Expected<bool> next(BagMessage& message) = 0;
  // False where the recorder did not get to finish the file: "goalnet record --repair" makes it whole.
  virtual bool finished() const = 0;
};

// `name` is for messages to people.
Expected<std::unique_ptr<StorageReader>> open_mcap(std::unique_ptr<ByteSource> source,
                                                   const std::string& name);
Expected<std::unique_ptr<StorageReader>> open_sqlite(const std::string& path);
// The same for a database in memory, which may be anything.
Expected<std::unique_ptr<StorageReader>> open_sqlite_in_memory(std::vector<std::uint8_t> bytes);

}  // namespace goalnet::ros
