// What an MCAP file holds and where, found by walking over its records: its own index is not believed, so
// that a file whose recorder was killed is read as far as it goes.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_topic.h"
#include "components/ros/bag/byte_source.h"
#include "components/ros/bag/mcap_chunk.h"

namespace goalnet::ros::mcap {

class Index {
 public:
  // `name` is for messages. Reads only the heads of chunks where the file is finished, all of them where it
  // is not. kInvalidRequest for what is damaged.
  static Expected<Index> build(ByteSource& source, const std::string& name);

  const std::vector<BagTopic>& topics() const { return topics_; }
  const std::vector<ChunkPlace>& chunks() const { return chunks_; }  // as they lie in the file
  bool finished() const { return finished_; }
  // Into topics(); nullptr for a channel that was not declared.
  const std::size_t* topic_of(std::uint16_t channel) const;

  // A record from inside a chunk; only schemas and channels are taken, and each only once.
  Expected<void> take(std::uint8_t opcode, std::span<const std::uint8_t> content);

 private:
  struct Schema {
    std::string name, definition;
  };
  Expected<void> walk(ByteSource& source, const std::string& name);
  Expected<void> take_outer(ByteSource& source, std::uint8_t opcode, std::uint64_t offset,
                            std::uint64_t length);
  Expected<void> take_message(ByteSource& source, std::uint64_t record, std::uint64_t length);
  Expected<void> take_schema(std::span<const std::uint8_t> content);
  Expected<void> take_channel(std::span<const std::uint8_t> content);
  void take_statistics(std::span<const std::uint8_t> content);
  Expected<void> look_into_chunks(ByteSource& source, const std::string& name);

  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, std::size_t> topic_of_channel_;
  std::map<std::pair<std::string, std::string>, std::size_t> topic_ids_;  // by name and type
  std::vector<BagTopic> topics_;
  std::map<std::uint16_t, std::uint64_t> claimed_counts_;
  std::vector<ChunkPlace> chunks_;
  bool in_run_ = false;  // the last record was a message outside of any chunk
  bool finished_ = false;
};

// "FILE is damaged at byte N: why".
Error damaged(const std::string& name, std::uint64_t offset, const std::string& why);

}  // namespace goalnet::ros::mcap
