// MCAP: chunked and indexed. A chunk is written out before it exceeds 1 MiB, and at flush().
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <vector>

#include "components/ros/bag/compression.h"
#include "components/ros/bag/mcap_format.h"
#include "components/ros/bag/offered_qos.h"
#include "components/ros/bag/storage_writer.h"

namespace goalnet::ros {
namespace {

using namespace mcap;

constexpr std::size_t kChunkBytes = 1u << 20;
constexpr std::size_t kMostChannels = 65'000;  // ids have 16 bits

class McapWriter : public StorageWriter {
 public:
  McapWriter(std::FILE* file, const StorageOptions& options) : file_(file), options_(options) {}
  ~McapWriter() override { std::fclose(file_); }
  McapWriter(const McapWriter&) = delete;

  Expected<void> begin(const BagMetadata& metadata);
  Expected<void> add_topic(const BagTopic& topic) override;
  Expected<void> write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                       std::span<const std::uint8_t> payload) override;
  Expected<void> flush() override;
  Expected<void> finish(BagMetadata& metadata) override;
  std::uint64_t size() const override { return offset_ + chunk_.size(); }

 private:
  struct ChunkPlace {
    std::uint64_t start_time, end_time, offset, length, index_length, compressed, size;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
  };
  struct MetadataPlace {
    std::uint64_t offset, length;
  };
  Expected<void> put(const Bytes& bytes);
  void drop_chunk(BagMetadata& metadata);
  Expected<void> put_metadata(const BagMetadata& metadata);
  Bytes summary(std::uint64_t start) const;
  Bytes chunk_indexes() const;
  Bytes metadata_indexes() const;
  Bytes statistics() const;

  std::FILE* file_;
  const StorageOptions options_;
  std::uint64_t offset_ = 0;
  Bytes schemas_, channels_;  // their records, repeated in the summary
  std::map<std::string, std::uint16_t> schema_ids_;
  std::map<std::uint16_t, std::uint64_t> counts_;  // messages by channel
  std::map<std::uint16_t, std::uint32_t> sequences_;
  Bytes chunk_;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;  // time, offset
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;
  std::vector<ChunkPlace> chunks_;
  std::vector<MetadataPlace> metadata_;
  std::uint64_t message_count_ = 0, first_time_ = 0, last_time_ = 0;
};

Expected<void> McapWriter::put(const Bytes& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    const std::string why = std::strerror(errno);
    // Half a record would make what follows unreadable; without it there is room for the file's end.
    std::clearerr(file_);
    if (::ftruncate(::fileno(file_), static_cast<off_t>(offset_)) == 0)
      std::fseek(file_, static_cast<long>(offset_), SEEK_SET);
    return fail(Outcome::kInternal, "cannot write the recording: " + why);
  }
  offset_ += bytes.size();
  return {};
}

Expected<void> McapWriter::begin(const BagMetadata& metadata) {
  Bytes start(std::begin(kMagic), std::end(kMagic));
  Bytes header;
  text(header, "ros2");
  text(header, "goalnet");
  record(start, kHeader, header);
  if (auto ok = put(start); !ok) return ok;
  return put_metadata(metadata);
}

// Without this record Jazzy takes the file for one of an older version, whose QoS are numbers. It comes first
// too, so that it is there if the recorder is killed.
Expected<void> McapWriter::put_metadata(const BagMetadata& metadata) {
  std::map<std::string, std::string> values{
      {"ROS_DISTRO", options_.distro == Distro::kHumble ? "humble" : "jazzy"}};
  if (options_.distro == Distro::kJazzy) {
    values = {{"serialized_metadata", embedded_metadata_yaml(metadata, options_.distro)}};
  }
  Bytes content, out;
  text(content, "rosbag2");
  texts(content, values);
  record(out, kMetadata, content);
  metadata_.push_back({offset_, out.size()});
  return put(out);
}

Expected<void> McapWriter::add_topic(const BagTopic& topic) {
  if (counts_.size() >= kMostChannels) return fail(Outcome::kInternal, "a recording cannot hold more topics");
  const auto next_schema = static_cast<std::uint16_t>(schema_ids_.size() + 1);
  const auto [schema, is_new] = schema_ids_.try_emplace(topic.type, next_schema);
  Bytes records;
  if (is_new) {
    Bytes content;
    number<std::uint16_t>(content, schema->second);
    text(content, topic.type);
    text(content, topic.definition.empty() ? "" : "ros2msg");
    text(content, topic.definition);
    record(records, kSchema, content);
    schemas_.insert(schemas_.end(), records.begin(), records.end());
  }
  const auto id = static_cast<std::uint16_t>(counts_.size() + 1);
  Bytes content;
  number<std::uint16_t>(content, id);
  number<std::uint16_t>(content, schema->second);
  text(content, topic.name);
  text(content, topic.serialization_format);
  std::map<std::string, std::string> about{
      {"offered_qos_profiles", offered_qos_yaml(topic.offered, options_.distro)}};
  if (options_.distro == Distro::kJazzy) about["topic_type_hash"] = topic.type_hash;
  texts(content, about);
  Bytes channel;
  record(channel, kChannel, content);
  channels_.insert(channels_.end(), channel.begin(), channel.end());
  // In the chunk too, so that a file without a summary can be read.
  chunk_.insert(chunk_.end(), records.begin(), records.end());
  chunk_.insert(chunk_.end(), channel.begin(), channel.end());
  counts_[id] = 0;
  return {};
}

Expected<void> McapWriter::write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                                 std::span<const std::uint8_t> payload) {
  const auto channel = static_cast<std::uint16_t>(topic + 1);
  if (chunk_.size() + payload.size() >= kChunkBytes) {
    if (auto ok = flush(); !ok) return ok;
  }
  if (chunk_index_.empty()) chunk_start_ = chunk_end_ = log_time;
  if (message_count_ == 0) first_time_ = last_time_ = log_time;
  chunk_start_ = std::min(chunk_start_, log_time);
  chunk_end_ = std::max(chunk_end_, log_time);
  first_time_ = std::min(first_time_, log_time);
  last_time_ = std::max(last_time_, log_time);
  chunk_index_[channel].emplace_back(log_time, chunk_.size());
  chunk_.push_back(kMessage);
  number<std::uint64_t>(chunk_, kMessageHead + payload.size());
  number<std::uint16_t>(chunk_, channel);
  number<std::uint32_t>(chunk_, sequences_[channel]++);
  number<std::uint64_t>(chunk_, log_time);
  number<std::uint64_t>(chunk_, publish_time);
  chunk_.insert(chunk_.end(), payload.begin(), payload.end());
  ++message_count_;
  ++counts_[channel];
  return {};
}

Expected<void> McapWriter::flush() {
  if (chunk_index_.empty()) return {};
  const Bytes compressed = options_.compress ? compress_zstd(chunk_) : Bytes();
  const Bytes& records = options_.compress ? compressed : chunk_;
  ChunkPlace place{chunk_start_, chunk_end_, offset_, 0, 0, records.size(), chunk_.size(), {}};
  Bytes content;
  number<std::uint64_t>(content, chunk_start_);
  number<std::uint64_t>(content, chunk_end_);
  number<std::uint64_t>(content, chunk_.size());
  number<std::uint32_t>(content, crc32(chunk_));
  text(content, options_.compress ? "zstd" : "");
  number<std::uint64_t>(content, records.size());
  content.insert(content.end(), records.begin(), records.end());
  Bytes out;
  record(out, kChunk, content);
  place.length = out.size();
  for (auto& [channel, entries] : chunk_index_) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    place.index_offsets[channel] = offset_ + out.size();
    Bytes list;
    number<std::uint16_t>(list, channel);
    number<std::uint32_t>(list, static_cast<std::uint32_t>(entries.size() * 16));
    for (const auto& [time, at] : entries) {
      number<std::uint64_t>(list, time);
      number<std::uint64_t>(list, at);
    }
    record(out, kMessageIndex, list);
  }
  place.index_length = out.size() - place.length;
  if (auto ok = put(out); !ok) return ok;
  chunks_.push_back(std::move(place));
  chunk_.clear();
  chunk_index_.clear();
  return {};
}

Bytes McapWriter::chunk_indexes() const {
  Bytes out;
  for (const ChunkPlace& chunk : chunks_) {
    Bytes content;
    number<std::uint64_t>(content, chunk.start_time);
    number<std::uint64_t>(content, chunk.end_time);
    number<std::uint64_t>(content, chunk.offset);
    number<std::uint64_t>(content, chunk.length);
    table(content, chunk.index_offsets);
    number<std::uint64_t>(content, chunk.index_length);
    text(content, options_.compress ? "zstd" : "");
    number<std::uint64_t>(content, chunk.compressed);
    number<std::uint64_t>(content, chunk.size);
    record(out, kChunkIndex, content);
  }
  return out;
}

Bytes McapWriter::metadata_indexes() const {
  Bytes out;
  for (const MetadataPlace& place : metadata_) {
    Bytes content;
    number<std::uint64_t>(content, place.offset);
    number<std::uint64_t>(content, place.length);
    text(content, "rosbag2");
    record(out, kMetadataIndex, content);
  }
  return out;
}

Bytes McapWriter::statistics() const {
  Bytes content, out;
  number<std::uint64_t>(content, message_count_);
  number<std::uint16_t>(content, static_cast<std::uint16_t>(schema_ids_.size()));
  number<std::uint32_t>(content, static_cast<std::uint32_t>(counts_.size()));
  number<std::uint32_t>(content, 0);  // attachments
  number<std::uint32_t>(content, static_cast<std::uint32_t>(metadata_.size()));
  number<std::uint32_t>(content, static_cast<std::uint32_t>(chunks_.size()));
  number<std::uint64_t>(content, first_time_);
  number<std::uint64_t>(content, last_time_);
  table(content, counts_);
  record(out, kStatistics, content);
  return out;
}

Bytes McapWriter::summary(std::uint64_t start) const {
  Bytes out, offsets;
  const auto group = [&](Opcode opcode, const Bytes& records) {
    if (records.empty()) return;
    Bytes content;
    content.push_back(opcode);
    number<std::uint64_t>(content, start + out.size());
    number<std::uint64_t>(content, records.size());
    record(offsets, kSummaryOffset, content);
    out.insert(out.end(), records.begin(), records.end());
  };
  group(kSchema, schemas_);
  group(kChannel, channels_);
  group(kChunkIndex, chunk_indexes());
  group(kMetadataIndex, metadata_indexes());
  group(kStatistics, statistics());
  const std::uint64_t offsets_start = start + out.size();
  out.insert(out.end(), offsets.begin(), offsets.end());
  // The checksum covers the summary and the footer up to itself.
  out.push_back(kFooter);
  number<std::uint64_t>(out, 8 + 8 + 4);
  number<std::uint64_t>(out, start);
  number<std::uint64_t>(out, offsets_start);
  number<std::uint32_t>(out, crc32(out));
  out.insert(out.end(), std::begin(kMagic), std::end(kMagic));
  return out;
}

Expected<void> McapWriter::finish(BagMetadata& metadata) {
  auto flushed = flush();
  if (!flushed) drop_chunk(metadata);
  if (auto ok = put_metadata(metadata); !ok) return flushed ? ok : flushed;
  Bytes end, content;
  number<std::uint32_t>(content, 0);  // no checksum of the data: the chunks have their own
  record(end, kDataEnd, content);
  if (auto ok = put(end); !ok) return flushed ? ok : flushed;
  const auto ended = put(summary(offset_));
  return flushed ? ended : flushed;
}

void McapWriter::drop_chunk(BagMetadata& metadata) {
  for (const auto& [channel, entries] : chunk_index_) {
    counts_[channel] -= entries.size();
    message_count_ -= entries.size();
    metadata.topics.at(channel - 1u).message_count -= entries.size();
    metadata.files.back().message_count -= entries.size();
  }
  BagFile& file = metadata.files.back();
  if (chunks_.empty()) first_time_ = 0;
  last_time_ = first_time_;
  for (const ChunkPlace& chunk : chunks_) last_time_ = std::max(last_time_, chunk.end_time);
  file.start = chunks_.empty() ? kNoStart : first_time_;
  file.duration = last_time_ - first_time_;
  chunk_.clear();
  chunk_index_.clear();
}

}  // namespace

Expected<std::unique_ptr<StorageWriter>> create_mcap_writer(const std::string& path,
                                                            const BagMetadata& metadata,
                                                            const StorageOptions& options) {
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr)
    return fail(Outcome::kInvalidRequest, "cannot make " + path + ": " + std::strerror(errno));
  std::setvbuf(file, nullptr, _IONBF, 0);  // whole records or nothing
  // Says that somebody is writing, also to other processes, and ends with this one: nobody repairs a living
  // file.
  ::flock(::fileno(file), LOCK_EX | LOCK_NB);
  auto writer = std::make_unique<McapWriter>(file, options);
  if (auto ok = writer->begin(metadata); !ok) return tl::unexpected<Error>(std::move(ok.error()));
  return std::unique_ptr<StorageWriter>(std::move(writer));
}

}  // namespace goalnet::ros
