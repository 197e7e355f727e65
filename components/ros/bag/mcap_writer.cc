#include "components/ros/bag/mcap_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace goalnet::ros {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kMagic[] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
constexpr std::size_t kChunkBytes = 1u << 20;
enum Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndexRecord = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

template <class T>
void number(Bytes& out, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
}

void text(Bytes& out, const std::string& value) {
  number<std::uint32_t>(out, static_cast<std::uint32_t>(value.size()));
  out.insert(out.end(), value.begin(), value.end());
}

template <class Key, class Value>
void table(Bytes& out, const std::map<Key, Value>& values) {
  number<std::uint32_t>(out, static_cast<std::uint32_t>(values.size() * (sizeof(Key) + sizeof(Value))));
  for (const auto& [key, value] : values) {
    number<Key>(out, key);
    number<Value>(out, value);
  }
}

void record(Bytes& out, Opcode opcode, const Bytes& content) {
  out.push_back(opcode);
  number<std::uint64_t>(out, content.size());
  out.insert(out.end(), content.begin(), content.end());
}

}  // namespace

Expected<std::unique_ptr<McapWriter>> McapWriter::create(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr)
    return fail(Outcome::kInvalidRequest, "cannot make " + path + ": " + std::strerror(errno));
  std::unique_ptr<McapWriter> writer(new McapWriter(file));
  Bytes start(std::begin(kMagic), std::end(kMagic));
  Bytes header;
  text(header, "ros2");
  text(header, "goalnet");
  record(start, kHeader, header);
  if (auto ok = writer->put(start); !ok) return tl::unexpected(ok.error());
  return writer;
}

McapWriter::~McapWriter() {
  static_cast<void>(close());
  std::fclose(file_);
}

Expected<void> McapWriter::put(const Bytes& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    return fail(Outcome::kInternal, std::string("cannot write the recording: ") + std::strerror(errno));
  }
  offset_ += bytes.size();
  return {};
}

std::uint16_t McapWriter::add_channel(const std::string& topic, const std::string& type,
                                      const std::string& definition, const std::string& qos,
                                      const std::string& type_hash) {
  const auto next_schema = static_cast<std::uint16_t>(schema_ids_.size() + 1);
  const auto [schema, is_new] = schema_ids_.try_emplace(type, next_schema);
  Bytes records;
  if (is_new) {
    Bytes content;
    number<std::uint16_t>(content, schema->second);
    text(content, type);
    text(content, "ros2msg");
    text(content, definition);
    record(records, kSchema, content);
    schemas_.insert(schemas_.end(), records.begin(), records.end());
  }
  const auto id = static_cast<std::uint16_t>(counts_.size() + 1);
  Bytes metadata;
  text(metadata, "offered_qos_profiles");
  text(metadata, qos);
  text(metadata, "topic_type_hash");
  text(metadata, type_hash);
  Bytes content;
  number<std::uint16_t>(content, id);
  number<std::uint16_t>(content, schema->second);
  text(content, topic);
  text(content, "cdr");
  number<std::uint32_t>(content, static_cast<std::uint32_t>(metadata.size()));
  content.insert(content.end(), metadata.begin(), metadata.end());
  Bytes channel;
  record(channel, kChannel, content);
  channels_.insert(channels_.end(), channel.begin(), channel.end());
  // In the chunk too, so that a file without a summary can be read.
  chunk_.insert(chunk_.end(), records.begin(), records.end());
  chunk_.insert(chunk_.end(), channel.begin(), channel.end());
  counts_[id] = 0;
  return id;
}

Expected<void> McapWriter::write(std::uint16_t channel, std::uint64_t log_time, std::uint64_t publish_time,
                                 std::span<const std::uint8_t> payload) {
  if (closed_) return fail(Outcome::kInternal, "the recording is closed");
  if (chunk_index_.empty()) chunk_start_ = chunk_end_ = log_time;
  if (message_count_ == 0) first_time_ = last_time_ = log_time;
  chunk_start_ = std::min(chunk_start_, log_time);
  chunk_end_ = std::max(chunk_end_, log_time);
  first_time_ = std::min(first_time_, log_time);
  last_time_ = std::max(last_time_, log_time);
  chunk_index_[channel].emplace_back(log_time, chunk_.size());
  chunk_.push_back(kMessage);
  number<std::uint64_t>(chunk_, 2 + 4 + 8 + 8 + payload.size());
  number<std::uint16_t>(chunk_, channel);
  number<std::uint32_t>(chunk_, sequences_[channel]++);
  number<std::uint64_t>(chunk_, log_time);
  number<std::uint64_t>(chunk_, publish_time);
  chunk_.insert(chunk_.end(), payload.begin(), payload.end());
  ++message_count_;
  ++counts_[channel];
  return chunk_.size() >= kChunkBytes ? flush() : Expected<void>();
}

Expected<void> McapWriter::flush() {
  if (chunk_index_.empty()) return {};
  ChunkIndex index{chunk_start_, chunk_end_, offset_, 0, 0, chunk_.size(), {}};
  Bytes content;
  number<std::uint64_t>(content, chunk_start_);
  number<std::uint64_t>(content, chunk_end_);
  number<std::uint64_t>(content, chunk_.size());
  number<std::uint32_t>(content, 0);  // no checksum
  text(content, "");                  // no compression
  number<std::uint64_t>(content, chunk_.size());
  content.insert(content.end(), chunk_.begin(), chunk_.end());
  Bytes out;
  record(out, kChunk, content);
  index.length = out.size();
  for (auto& [channel, entries] : chunk_index_) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    index.index_offsets[channel] = offset_ + out.size();
    Bytes list;
    number<std::uint16_t>(list, channel);
    number<std::uint32_t>(list, static_cast<std::uint32_t>(entries.size() * 16));
    for (const auto& [time, at] : entries) {
      number<std::uint64_t>(list, time);
      number<std::uint64_t>(list, at);
    }
    record(out, kMessageIndex, list);
  }
  index.index_length = out.size() - index.length;
  if (auto ok = put(out); !ok) return ok;
  if (std::fflush(file_) != 0)
    return fail(Outcome::kInternal, std::string("cannot write the recording: ") + std::strerror(errno));
  chunks_.push_back(std::move(index));
  chunk_.clear();
  chunk_index_.clear();
  return {};
}

McapWriter::Bytes McapWriter::summary(std::uint64_t start) const {
  Bytes out;
  std::vector<std::pair<Opcode, std::pair<std::uint64_t, std::uint64_t>>> groups;
  const auto group = [&](Opcode opcode, const Bytes& records) {
    if (records.empty()) return;
    groups.push_back({opcode, {start + out.size(), records.size()}});
    out.insert(out.end(), records.begin(), records.end());
  };
  group(kSchema, schemas_);
  group(kChannel, channels_);
  Bytes indexes;
  for (const ChunkIndex& chunk : chunks_) {
    Bytes content;
    number<std::uint64_t>(content, chunk.start_time);
    number<std::uint64_t>(content, chunk.end_time);
    number<std::uint64_t>(content, chunk.offset);
    number<std::uint64_t>(content, chunk.length);
    table(content, chunk.index_offsets);
    number<std::uint64_t>(content, chunk.index_length);
    text(content, "");
    number<std::uint64_t>(content, chunk.size);
    number<std::uint64_t>(content, chunk.size);
    record(indexes, kChunkIndexRecord, content);
  }
  group(kChunkIndexRecord, indexes);
  Bytes content;
  number<std::uint64_t>(content, message_count_);
  number<std::uint16_t>(content, static_cast<std::uint16_t>(schema_ids_.size()));
  number<std::uint32_t>(content, static_cast<std::uint32_t>(counts_.size()));
  number<std::uint32_t>(content, 0);
  number<std::uint32_t>(content, 0);
  number<std::uint32_t>(content, static_cast<std::uint32_t>(chunks_.size()));
  number<std::uint64_t>(content, first_time_);
  number<std::uint64_t>(content, last_time_);
  table(content, counts_);
  Bytes statistics;
  record(statistics, kStatistics, content);
  group(kStatistics, statistics);
  const std::uint64_t offsets_start = start + out.size();
  for (const auto& [opcode, place] : groups) {
    Bytes offset;
    offset.push_back(opcode);
    number<std::uint64_t>(offset, place.first);
    number<std::uint64_t>(offset, place.second);
    record(out, kSummaryOffset, offset);
  }
  Bytes footer;
  number<std::uint64_t>(footer, start);
  number<std::uint64_t>(footer, offsets_start);
  number<std::uint32_t>(footer, 0);
  record(out, kFooter, footer);
  out.insert(out.end(), std::begin(kMagic), std::end(kMagic));
  return out;
}

Expected<void> McapWriter::close() {
  if (closed_) return {};
  if (auto ok = flush(); !ok) return ok;
  closed_ = true;
  Bytes end;
  Bytes content;
  number<std::uint32_t>(content, 0);
  record(end, kDataEnd, content);
  if (auto ok = put(end); !ok) return ok;
  if (auto ok = put(summary(offset_)); !ok) return ok;
  if (std::fflush(file_) != 0)
    return fail(Outcome::kInternal, std::string("cannot write the recording: ") + std::strerror(errno));
  return {};
}

}  // namespace goalnet::ros
