// One chunk of an MCAP file in memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/bag/byte_source.h"
#include "components/ros/bag/mcap_format.h"

namespace goalnet::ros::mcap {

// Where a chunk lies: known after a look at its head. A run of messages outside of any chunk is handled as an
// uncompressed chunk without a head.
struct ChunkPlace {
  std::uint64_t start_time = 0, end_time = 0;  // [ns] as it claims
  std::uint64_t offset = 0, length = 0;        // [bytes] of its records as they lie in the file
  std::uint64_t size = 0;                      // [bytes] uncompressed
  std::uint32_t checksum = 0;                  // 0: none
  std::string compression;
};

inline constexpr std::uint64_t kLargestChunk = 256u << 20;  // [bytes] what is read into memory at once

// From the first bytes of a chunk record's content; `offset` is where the content begins, `length` how long
// it is.
Expected<ChunkPlace> parse_chunk_head(std::span<const std::uint8_t> head, std::uint64_t offset,
                                      std::uint64_t length);
inline constexpr std::size_t kLargestChunkHead = 8 + 8 + 8 + 4 + 4 + 32 + 8;

// Its records, uncompressed and checked.
Expected<Bytes> load_chunk(ByteSource& source, const ChunkPlace& place);

// Calls `visit(opcode, content)` for each record; stops at a record that is cut off. Returns whether none
// was.
template <class Visit>
bool for_each_record(std::span<const std::uint8_t> records, const Visit& visit) {
  Parser parser(records);
  while (!parser.rest().empty()) {
    const auto opcode = parser.number<std::uint8_t>();
    const auto content = parser.bytes(parser.number<std::uint64_t>());
    if (!parser.ok()) return false;
    visit(opcode, content);
  }
  return true;
}

}  // namespace goalnet::ros::mcap
