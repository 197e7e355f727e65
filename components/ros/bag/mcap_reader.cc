// MCAP, read without trusting it: the places of all chunks come from walking the file, never from its index,
// so that a file whose recorder was killed is read as far as it goes.
#include <algorithm>
#include <cstring>
#include <deque>
#include <map>

#include "components/ros/bag/mcap_chunk.h"
#include "components/ros/bag/offered_qos.h"
#include "components/ros/bag/storage_reader.h"

namespace goalnet::ros {
namespace {

using namespace mcap;

constexpr std::size_t kMostCached = 4;                   // chunks kept in memory
constexpr std::size_t kMostMessagesAtOnce = 20'000'000;  // in chunks that overlap in time
constexpr std::uint64_t kLargestRecord = 64u << 20;      // [bytes] of a schema, channel or statistics
constexpr std::uint64_t kLongestRun = 1u << 20;  // [bytes] of messages outside of chunks, taken together

Error broken(const std::string& name, std::uint64_t offset, const std::string& why) {
  return {Outcome::kInvalidRequest, name + " is damaged at byte " + std::to_string(offset) + ": " + why};
}

class McapReader : public StorageReader {
 public:
  McapReader(std::unique_ptr<ByteSource> source, std::string name)
      : source_(std::move(source)), name_(std::move(name)) {}

  Expected<void> open();
  const std::vector<BagTopic>& topics() const override { return topics_; }
  bool finished() const override { return finished_; }
  Expected<bool> next(BagMessage& message) override;

 private:
  struct Schema {
    std::string name, definition;
  };
  // Where one message lies in its chunk.
  struct Entry {
    std::uint64_t time;
    std::size_t at, length;
  };
  // A chunk whose messages are being handed out, in order of time.
  struct Cursor {
    std::size_t chunk;
    std::vector<Entry> entries;
    std::size_t position = 0;
    std::uint64_t time() const { return entries[position].time; }
  };

  Expected<void> walk();
  Expected<void> take_record(std::uint8_t opcode, std::uint64_t offset, std::uint64_t length);
  Expected<void> take_message(std::uint64_t record, std::uint64_t content, std::uint64_t length);
  Expected<void> take_schema(std::span<const std::uint8_t> content);
  Expected<void> take_channel(std::span<const std::uint8_t> content);
  void take_statistics(std::span<const std::uint8_t> content);
  Expected<void> look_into_chunks();
  Expected<const Bytes*> chunk(std::size_t index);
  Expected<void> open_cursor(std::size_t index);

  std::unique_ptr<ByteSource> source_;
  const std::string name_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, std::size_t> topic_of_channel_;
  std::map<std::pair<std::string, std::string>, std::size_t> topic_ids_;  // by name and type
  std::vector<BagTopic> topics_;
  std::map<std::uint16_t, std::uint64_t> claimed_counts_;
  std::vector<ChunkPlace> chunks_;
  bool in_run_ = false;  // the last record was a message outside of any chunk
  bool finished_ = false;
  std::vector<std::size_t> order_;  // chunks by start time
  std::size_t next_chunk_ = 0;      // into order_
  std::vector<Cursor> cursors_;
  std::size_t waiting_ = 0;  // messages in cursors_
  std::deque<std::pair<std::size_t, Bytes>> cache_;
};

Expected<void> McapReader::open() {
  std::uint8_t magic[sizeof kMagic];
  if (!source_->read(0, magic) || std::memcmp(magic, kMagic, sizeof kMagic) != 0) {
    return fail(Outcome::kInvalidRequest, name_ + " is no MCAP file");
  }
  if (auto walked = walk(); !walked) return walked;
  if (!finished_) {
    if (auto looked = look_into_chunks(); !looked) return looked;
  }
  for (const auto& [channel, count] : claimed_counts_) {
    if (const auto topic = topic_of_channel_.find(channel); topic != topic_of_channel_.end())
      topics_[topic->second].message_count += count;
  }
  for (std::size_t i = 0; i < chunks_.size(); ++i) order_.push_back(i);
  std::stable_sort(order_.begin(), order_.end(), [this](std::size_t a, std::size_t b) {
    return chunks_[a].start_time < chunks_[b].start_time;
  });
  return {};
}

// Over all records, looking only at the heads of chunks.
Expected<void> McapReader::walk() {
  std::uint64_t at = sizeof kMagic;
  while (at < source_->size()) {
    std::uint8_t head[kRecordHead];
    if (!source_->read(at, head)) return {};  // cut off
    Parser parser(head);
    const auto opcode = parser.number<std::uint8_t>();
    const auto length = parser.number<std::uint64_t>();
    const std::uint64_t content = at + kRecordHead;
    if (length > source_->size() - content) return {};  // cut off
    if (opcode == kFooter) {
      finished_ = true;
      return {};
    }
    if (opcode == kMessage) {
      if (auto ok = take_message(at, content, length); !ok) return ok;
    } else {
      in_run_ = false;
      if (auto ok = take_record(opcode, content, length); !ok) return ok;
    }
    at = content + length;
  }
  return {};
}

Expected<void> McapReader::take_record(std::uint8_t opcode, std::uint64_t offset, std::uint64_t length) {
  if (opcode == kChunk) {
    Bytes head(std::min<std::uint64_t>(length, kLargestChunkHead));
    if (!source_->read(offset, head)) return tl::unexpected(broken(name_, offset, "it cannot be read"));
    auto place = parse_chunk_head(head, offset, length);
    if (!place) return tl::unexpected(broken(name_, offset, "a chunk: " + place.error().message));
    chunks_.push_back(std::move(*place));
    return {};
  }
  if (opcode != kSchema && opcode != kChannel && opcode != kStatistics) return {};
  if (length > kLargestRecord) return tl::unexpected(broken(name_, offset, "a record is larger than 64 MiB"));
  Bytes content(length);
  if (!source_->read(offset, content)) return tl::unexpected(broken(name_, offset, "it cannot be read"));
  Expected<void> taken;
  if (opcode == kSchema) taken = take_schema(content);
  if (opcode == kChannel) taken = take_channel(content);
  if (opcode == kStatistics) take_statistics(content);
  if (!taken) return tl::unexpected(broken(name_, offset, taken.error().message));
  return {};
}

// `ros2 bag record --storage-preset-profile fastwrite` makes no chunks.
Expected<void> McapReader::take_message(std::uint64_t record, std::uint64_t content, std::uint64_t length) {
  if (length > kLargestChunk)
    return tl::unexpected(broken(name_, content, "a message is larger than 256 MiB"));
  std::uint8_t head[kMessageHead];
  if (length < sizeof head || !source_->read(content, head)) {
    return tl::unexpected(broken(name_, content, "a message without a head"));
  }
  Parser parser(std::span<const std::uint8_t>(head).subspan(2 + 4));
  const auto time = parser.number<std::uint64_t>();
  const std::uint64_t whole = kRecordHead + length;
  if (!in_run_ || chunks_.back().length + whole > kLongestRun) {
    chunks_.push_back({time, time, record, 0, 0, 0, ""});
    in_run_ = true;
  }
  ChunkPlace& run = chunks_.back();
  run.length += whole;
  run.size = run.length;
  run.start_time = std::min(run.start_time, time);
  run.end_time = std::max(run.end_time, time);
  return {};
}

Expected<void> McapReader::take_schema(std::span<const std::uint8_t> content) {
  Parser parser(content);
  const auto id = parser.number<std::uint16_t>();
  Schema schema;
  schema.name = parser.text();
  const std::string encoding = parser.text();
  schema.definition = parser.text();
  if (!parser.ok()) return fail(Outcome::kInvalidRequest, "a schema is cut off");
  if (encoding != "ros2msg") schema.definition.clear();
  schemas_.try_emplace(id, std::move(schema));
  return {};
}

Expected<void> McapReader::take_channel(std::span<const std::uint8_t> content) {
  Parser parser(content);
  const auto id = parser.number<std::uint16_t>();
  const auto schema = schemas_.find(parser.number<std::uint16_t>());
  BagTopic topic;
  topic.name = parser.text();
  topic.serialization_format = parser.text();
  const auto about = parser.texts();
  if (!parser.ok()) return fail(Outcome::kInvalidRequest, "a channel is cut off");
  if (topic_of_channel_.contains(id)) return {};  // repeated in the summary
  if (schema == schemas_.end()) return fail(Outcome::kInvalidRequest, "a channel without a schema");
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

void McapReader::take_statistics(std::span<const std::uint8_t> content) {
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
Expected<void> McapReader::look_into_chunks() {
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    auto records = load_chunk(*source_, chunks_[i]);
    Expected<void> taken;
    if (!records) {
      taken = fail(Outcome::kInvalidRequest, "a chunk: " + records.error().message);
    } else {
      for_each_record(*records, [&](std::uint8_t opcode, std::span<const std::uint8_t> content) {
        if (!taken) return;
        if (opcode == kSchema) taken = take_schema(content);
        if (opcode == kChannel) taken = take_channel(content);
      });
    }
    if (taken) continue;
    if (i == 0) return tl::unexpected(broken(name_, chunks_[i].offset, taken.error().message));
    chunks_.resize(i);
  }
  return {};
}

Expected<const Bytes*> McapReader::chunk(std::size_t index) {
  const auto found =
      std::find_if(cache_.begin(), cache_.end(), [&](const auto& one) { return one.first == index; });
  if (found != cache_.end()) return &found->second;
  auto records = load_chunk(*source_, chunks_[index]);
  if (!records)
    return tl::unexpected(broken(name_, chunks_[index].offset, "a chunk: " + records.error().message));
  if (cache_.size() >= kMostCached) cache_.pop_front();
  return &cache_.emplace_back(index, std::move(*records)).second;
}

Expected<void> McapReader::open_cursor(std::size_t index) {
  const auto records = chunk(index);
  if (!records) return tl::unexpected(records.error());
  Cursor cursor{index, {}, 0};
  const std::uint8_t* const begin = (*records)->data();
  Expected<void> taken;
  const bool whole =
      for_each_record(**records, [&](std::uint8_t opcode, std::span<const std::uint8_t> content) {
        if (!taken) return;
        if (opcode == kSchema) taken = take_schema(content);
        if (opcode == kChannel) taken = take_channel(content);
        if (opcode != kMessage) return;
        Parser parser(content);
        parser.bytes(2 + 4);
        const auto time = parser.number<std::uint64_t>();
        parser.bytes(8);
        if (!parser.ok()) {
          taken = fail(Outcome::kInvalidRequest, "a message without a head");
        } else {
          cursor.entries.push_back({time, static_cast<std::size_t>(content.data() - begin), content.size()});
        }
      });
  if (taken && !whole) taken = fail(Outcome::kInvalidRequest, "a record is cut off inside a chunk");
  if (!taken) return tl::unexpected(broken(name_, chunks_[index].offset, taken.error().message));
  waiting_ += cursor.entries.size();
  if (waiting_ > kMostMessagesAtOnce) {
    return tl::unexpected(broken(name_, chunks_[index].offset, "too many chunks overlap in time"));
  }
  std::stable_sort(cursor.entries.begin(), cursor.entries.end(),
                   [](const Entry& a, const Entry& b) { return a.time < b.time; });
  if (!cursor.entries.empty()) cursors_.push_back(std::move(cursor));
  return {};
}

Expected<bool> McapReader::next(BagMessage& message) {
  const auto earliest = [this] {
    return std::min_element(cursors_.begin(), cursors_.end(), [](const Cursor& a, const Cursor& b) {
      return a.time() != b.time() ? a.time() < b.time() : a.chunk < b.chunk;
    });
  };
  auto cursor = earliest();
  while (next_chunk_ < order_.size() &&
         (cursor == cursors_.end() || chunks_[order_[next_chunk_]].start_time <= cursor->time())) {
    if (auto ok = open_cursor(order_[next_chunk_++]); !ok) return tl::unexpected(ok.error());
    cursor = earliest();
  }
  if (cursor == cursors_.end()) return false;
  const auto records = chunk(cursor->chunk);
  if (!records) return tl::unexpected(records.error());
  const Entry entry = cursor->entries[cursor->position++];
  const std::uint64_t place = chunks_[cursor->chunk].offset;
  if (cursor->position == cursor->entries.size()) {
    waiting_ -= cursor->entries.size();
    cursors_.erase(cursor);
  }
  Parser parser(std::span<const std::uint8_t>(**records).subspan(entry.at, entry.length));
  const auto topic = topic_of_channel_.find(parser.number<std::uint16_t>());
  if (topic == topic_of_channel_.end())
    return tl::unexpected(broken(name_, place, "a message of no known channel"));
  parser.number<std::uint32_t>();
  message.topic = topic->second;
  message.log_time = parser.number<std::uint64_t>();
  message.publish_time = parser.number<std::uint64_t>();
  message.payload.assign(parser.rest().begin(), parser.rest().end());
  return true;
}

}  // namespace

Expected<std::unique_ptr<StorageReader>> open_mcap(std::unique_ptr<ByteSource> source,
                                                   const std::string& name) {
  auto reader = std::make_unique<McapReader>(std::move(source), name);
  if (auto ok = reader->open(); !ok) return tl::unexpected<Error>(std::move(ok.error()));
  return std::unique_ptr<StorageReader>(std::move(reader));
}

}  // namespace goalnet::ros
