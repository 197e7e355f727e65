#include "components/ros/bag/mcap_chunk.h"

#include "components/ros/bag/compression.h"

namespace goalnet::ros::mcap {

Expected<ChunkPlace> parse_chunk_head(std::span<const std::uint8_t> head, std::uint64_t offset,
                                      std::uint64_t length) {
  Parser parser(head);
  ChunkPlace place;
  place.start_time = parser.number<std::uint64_t>();
  place.end_time = parser.number<std::uint64_t>();
  place.size = parser.number<std::uint64_t>();
  place.checksum = parser.number<std::uint32_t>();
  place.compression = parser.text();
  place.length = parser.number<std::uint64_t>();
  const std::uint64_t head_size = head.size() - parser.rest().size();
  if (!parser.ok() || head_size > length || place.length != length - head_size) {
    return fail(Outcome::kInvalidRequest, "its head makes no sense");
  }
  if (place.size > kLargestChunk || place.length > kLargestChunk) {
    return fail(Outcome::kInvalidRequest, "it is larger than 256 MiB");
  }
  place.offset = offset + head_size;
  return place;
}

Expected<Bytes> load_chunk(ByteSource& source, const ChunkPlace& place) {
  Bytes stored(place.length);
  if (!source.read(place.offset, stored)) return fail(Outcome::kInvalidRequest, "it cannot be read");
  auto records = decompress(place.compression, stored, place.size);
  if (records && place.checksum != 0 && crc32(*records) != place.checksum) {
    return fail(Outcome::kInvalidRequest, "its checksum is wrong");
  }
  return records;
}

}  // namespace goalnet::ros::mcap
