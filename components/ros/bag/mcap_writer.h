// Writes MCAP files (https://mcap.dev/spec): chunked, indexed, uncompressed. Knows nothing of DDS.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::ros {

// One thread. A chunk is written out when it reaches 1 MiB or when flush() is called; what was flushed can be
// read even if the program dies before close().
class McapWriter {
 public:
  // Makes the file. kInvalidRequest if that is not possible.
  static Expected<std::unique_ptr<McapWriter>> create(const std::string& path);
  ~McapWriter();  // closes
  McapWriter(const McapWriter&) = delete;

  // Returns the channel's id. `definition` is the ros2msg text with dependencies; `qos` the offered profiles
  // as YAML.
  std::uint16_t add_channel(const std::string& topic, const std::string& type, const std::string& definition,
                            const std::string& qos, const std::string& type_hash);
  // `payload` with encapsulation; times in ns. kInternal when the disk is full.
  Expected<void> write(std::uint16_t channel, std::uint64_t log_time, std::uint64_t publish_time,
                       std::span<const std::uint8_t> payload);
  Expected<void> flush();
  // Writes the summary; nothing can be written afterwards.
  Expected<void> close();

  std::uint64_t message_count() const { return message_count_; }
  std::uint64_t size() const { return offset_; }  // [bytes] written out

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct ChunkIndex {
    std::uint64_t start_time, end_time, offset, length, index_length, size;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
  };
  explicit McapWriter(std::FILE* file) : file_(file) {}
  Expected<void> put(const Bytes& bytes);
  Bytes summary(std::uint64_t start) const;

  std::FILE* file_;
  std::uint64_t offset_ = 0;
  Bytes schemas_, channels_;  // their records, repeated in the summary
  std::map<std::string, std::uint16_t> schema_ids_;
  std::map<std::uint16_t, std::uint64_t> counts_;  // messages by channel
  std::map<std::uint16_t, std::uint32_t> sequences_;
  Bytes chunk_;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;  // time, offset
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;
  std::vector<ChunkIndex> chunks_;
  std::uint64_t message_count_ = 0, first_time_ = 0, last_time_ = 0;
  bool closed_ = false;
};

}  // namespace goalnet::ros
