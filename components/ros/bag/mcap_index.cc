#include "components/ros/bag/mcap_index.h"

#include <algorithm>
#include <cstring>

#include "components/ros/bag/offered_qos.h"

namespace goalnet::ros::mcap {
namespace {

constexpr std::uint64_t kLargestRecord = 64u << 20;  // [bytes] of a schema, channel or statistics
constexpr std::uint64_t kLongestRun = 1u << 20;      // [bytes] of messages outside of chunks, taken together

Expected<void> bad(const std::string& why) { return fail(Outcome::kInvalidRequest, why); }

}  // namespace

Error damaged(const std::string& name, std::uint64_t offset, const std::string& why) {
  return {Outcome::kInvalidRequest, name + " is damaged at byte " + std::to_string(offset) + ": " + why};
}

Expected<Index> Index::build(ByteSource& source, const std::string& name) {
  std::uint8_t magic[sizeof kMagic];
  if (!source.read(0, magic) || std::memcmp(magic, kMagic, sizeof kMagic) != 0) {
    return fail(Outcome::kInvalidRequest, name + " is no MCAP file");
  }
  Index index;
  if (auto walked = index.walk(source, name); !walked)
    return tl::unexpected<Error>(std::move(walked.error()));
  if (!index.finished_) {
    if (auto looked = index.look_into_chunks(source, name); !looked)
      return tl::unexpected<Error>(std::move(looked.error()));
  }
  for (const auto& [channel, count] : index.claimed_counts_) {
    if (const std::size_t* topic = index.topic_of(channel)) index.topics_[*topic].message_count += count;
  }
  return index;
}

const std::size_t* Index::topic_of(std::uint16_t channel) const {
  const auto found = topic_of_channel_.find(channel);
  return found == topic_of_channel_.end() ? nullptr : &found->second;
}

Expected<void> Index::walk(ByteSource& source, const std::string& name) {
  std::uint64_t at = sizeof kMagic;
  while (at < source.size()) {
    std::uint8_t head[kRecordHead];
    if (!source.read(at, head)) return {};  // cut off
    Parser parser(head);
    const auto opcode = parser.number<std::uint8_t>();
    const auto length = parser.number<std::uint64_t>();
    const std::uint64_t content = at + kRecordHead;
    if (length > source.size() - content) return {};  // cut off
    if (opcode == kFooter) {
      finished_ = true;
      return {};
    }
    const auto taken =
        opcode == kMessage ? take_message(source, at, length) : take_outer(source, opcode, content, length);
    if (!taken) return tl::unexpected(damaged(name, content, taken.error().message));
    in_run_ = opcode == kMessage;
    at = content + length;
  }
  return {};
}

// A record that lies in no chunk.
Expected<void> Index::take_outer(ByteSource& source, std::uint8_t opcode, std::uint64_t offset,
                                 std::uint64_t length) {
  if (opcode == kChunk) {
    Bytes head(std::min<std::uint64_t>(length, kLargestChunkHead));
    if (!source.read(offset, head)) return bad("it cannot be read");
    auto place = parse_chunk_head(head, offset, length);
    if (!place) return bad("a chunk: " + place.error().message);
    chunks_.push_back(std::move(*place));
    return {};
  }
  if (opcode != kSchema && opcode != kChannel && opcode != kStatistics) return {};
  if (length > kLargestRecord) return bad("a record is larger than 64 MiB");
  Bytes content(length);
  if (!source.read(offset, content)) return bad("it cannot be read");
  if (opcode == kStatistics) take_statistics(content);
  return take(opcode, content);
}

// `ros2 bag record --storage-preset-profile fastwrite` makes no chunks.
Expected<void> Index::take_message(ByteSource& source, std::uint64_t record, std::uint64_t length) {
  if (length > kLargestChunk) return bad("a message is larger than 256 MiB");
  std::uint8_t head[kMessageHead];
  if (length < sizeof head || !source.read(record + kRecordHead, head))
    return bad("a message without a head");
  Parser parser(std::span<const std::uint8_t>(head).subspan(2 + 4));
  const auto time = parser.number<std::uint64_t>();
  const std::uint64_t whole = kRecordHead + length;
  if (!in_run_ || chunks_.back().length + whole > kLongestRun)
    chunks_.push_back({time, time, record, 0, 0, 0, ""});
  ChunkPlace& run = chunks_.back();
  run.length += whole;
  run.size = run.length;
  run.start_time = std::min(run.start_time, time);
  run.end_time = std::max(run.end_time, time);
  return {};
}

Expected<void> Index::take(std::uint8_t opcode, std::span<const std::uint8_t> content) {
  if (opcode == kSchema) return take_schema(content);
  if (opcode == kChannel) return take_channel(content);
  return {};
}

Expected<void> Index::take_schema(std::span<const std::uint8_t> content) {
  Parser parser(content);
  const auto id = parser.number<std::uint16_t>();
  Schema schema;
  schema.name = parser.text();
  const std::string encoding = parser.text();
  schema.definition = parser.text();
  if (!parser.ok()) return bad("a schema is cut off");
  if (encoding != "ros2msg") schema.definition.clear();
  schemas_.try_emplace(id, std::move(schema));
  return {};
}

Expected<void> Index::take_channel(std::span<const std::uint8_t> content) {
  Parser parser(content);
  const auto id = parser.number<std::uint16_t>();
  const auto schema = schemas_.find(parser.number<std::uint16_t>());
  BagTopic topic;
  topic.name = parser.text();
  topic.serialization_format = parser.text();
  const auto about = parser.texts();
  if (!parser.ok()) return bad("a channel is cut off");
  if (topic_of_channel_.contains(id)) return {};  // repeated in the summary
  if (schema == schemas_.end()) return bad("a channel without a schema");
  topic.type = schema->second.name;
  topic.definition = schema->second.definition;
  if (const auto hash = about.find("topic_type_hash"); hash != about.end()) topic.type_hash = hash->second;
  if (const auto qos = about.find("offered_qos_profiles"); qos != about.end()) {
    auto offered = parse_offered_qos(qos->second);
    if (!offered) return tl::unexpected<Error>(std::move(offered.error()));
    topic.offered = std::move(*offered);
  }
  // Two channels of one name are one topic.
  const auto [known, is_new] = topic_ids_.try_emplace({topic.name, topic.type}, topics_.size());
  topic_of_channel_[id] = known->second;
  if (is_new) topics_.push_back(std::move(topic));
  return {};
}

void Index::take_statistics(std::span<const std::uint8_t> content) {
  Parser parser(content);
  parser.bytes(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8);
  Parser counts(parser.bytes(parser.number<std::uint32_t>()));
  while (!counts.rest().empty() && counts.ok()) {
    const auto channel = counts.number<std::uint16_t>();
    claimed_counts_[channel] = counts.number<std::uint64_t>();
  }
}

// Where the recorder was killed there is no summary, and schemas and channels are only in the chunks. What
// comes before the first damaged chunk is kept: the end of such a file may be anything.
Expected<void> Index::look_into_chunks(ByteSource& source, const std::string& name) {
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    auto records = load_chunk(source, chunks_[i]);
    Expected<void> taken;
    if (!records) {
      taken = bad("a chunk: " + records.error().message);
    } else {
      for_each_record(*records, [&](std::uint8_t opcode, std::span<const std::uint8_t> content) {
        if (taken) taken = take(opcode, content);
      });
    }
    if (taken) continue;
    if (i == 0) return tl::unexpected(damaged(name, chunks_[i].offset, taken.error().message));
    chunks_.resize(i);
  }
  return {};
}

}  // namespace goalnet::ros::mcap
