// MCAP messages in order of time: a chunk is opened when its first message is due, and chunks that overlap
// are merged.
#include <algorithm>
#include <deque>

#include "components/ros/bag/mcap_index.h"
#include "components/ros/bag/storage_reader.h"

namespace goalnet::ros {
namespace {

using namespace mcap;

constexpr std::size_t kMostCached = 4;                   // chunks kept in memory
constexpr std::size_t kMostMessagesAtOnce = 20'000'000;  // in chunks that overlap in time

class McapReader : public StorageReader {
 public:
  McapReader(std::unique_ptr<ByteSource> source, std::string name, Index index);
  const std::vector<BagTopic>& topics() const override { return index_.topics(); }
  bool finished() const override { return index_.finished(); }
  Expected<bool> next(BagMessage& message) override;

 private:
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
  Error damaged_chunk(std::size_t chunk, const std::string& why) const;
  Expected<const Bytes*> chunk(std::size_t index);
  Expected<void> open_cursor(std::size_t index);
  std::vector<Cursor>::iterator earliest();

  std::unique_ptr<ByteSource> source_;
  const std::string name_;
  Index index_;
  std::vector<std::size_t> order_;  // chunks by start time
  std::size_t next_chunk_ = 0;      // into order_
  std::vector<Cursor> cursors_;
  std::size_t waiting_ = 0;  // messages in cursors_
  std::deque<std::pair<std::size_t, Bytes>> cache_;
};

McapReader::McapReader(std::unique_ptr<ByteSource> source, std::string name, Index index)
    : source_(std::move(source)), name_(std::move(name)), index_(std::move(index)) {
  const auto& chunks = index_.chunks();
  for (std::size_t i = 0; i < chunks.size(); ++i) order_.push_back(i);
  std::stable_sort(order_.begin(), order_.end(), [&chunks](std::size_t a, std::size_t b) {
    return chunks[a].start_time < chunks[b].start_time;
  });
}

Error McapReader::damaged_chunk(std::size_t chunk, const std::string& why) const {
  return damaged(name_, index_.chunks()[chunk].offset, "a chunk: " + why);
}

Expected<const Bytes*> McapReader::chunk(std::size_t index) {
  const auto found =
      std::find_if(cache_.begin(), cache_.end(), [&](const auto& one) { return one.first == index; });
  if (found != cache_.end()) return &found->second;
  auto records = load_chunk(*source_, index_.chunks()[index]);
  if (!records) return tl::unexpected(damaged_chunk(index, records.error().message));
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
        if (taken) taken = index_.take(opcode, content);
        if (opcode != kMessage || !taken) return;
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
  if (taken && !whole) taken = fail(Outcome::kInvalidRequest, "a record is cut off");
  if (!taken) return tl::unexpected(damaged_chunk(index, taken.error().message));
  waiting_ += cursor.entries.size();
  if (waiting_ > kMostMessagesAtOnce) return tl::unexpected(damaged_chunk(index, "too many overlap in time"));
  std::stable_sort(cursor.entries.begin(), cursor.entries.end(),
                   [](const Entry& a, const Entry& b) { return a.time < b.time; });
  if (!cursor.entries.empty()) cursors_.push_back(std::move(cursor));
  return {};
}

std::vector<McapReader::Cursor>::iterator McapReader::earliest() {
  return std::min_element(cursors_.begin(), cursors_.end(), [](const Cursor& a, const Cursor& b) {
    return a.time() != b.time() ? a.time() < b.time() : a.chunk < b.chunk;
  });
}

Expected<bool> McapReader::next(BagMessage& message) {
  auto cursor = earliest();
  while (next_chunk_ < order_.size() &&
         (cursor == cursors_.end() || index_.chunks()[order_[next_chunk_]].start_time <= cursor->time())) {
    if (auto ok = open_cursor(order_[next_chunk_++]); !ok) return tl::unexpected(ok.error());
    cursor = earliest();
  }
  if (cursor == cursors_.end()) return false;
  const std::size_t place = cursor->chunk;
  const auto records = chunk(place);
  if (!records) return tl::unexpected(records.error());
  const Entry entry = cursor->entries[cursor->position++];
  if (cursor->position == cursor->entries.size()) {
    waiting_ -= cursor->entries.size();
    cursors_.erase(cursor);
  }
  Parser parser(std::span<const std::uint8_t>(**records).subspan(entry.at, entry.length));
  const std::size_t* topic = index_.topic_of(parser.number<std::uint16_t>());
  if (topic == nullptr) return tl::unexpected(damaged_chunk(place, "a message of no known channel"));
  parser.number<std::uint32_t>();
  message.topic = *topic;
  message.log_time = parser.number<std::uint64_t>();
  message.publish_time = parser.number<std::uint64_t>();
  message.payload.assign(parser.rest().begin(), parser.rest().end());
  return true;
}

}  // namespace

Expected<std::unique_ptr<StorageReader>> open_mcap(std::unique_ptr<ByteSource> source,
                                                   const std::string& name) {
  auto index = Index::build(*source, name);
  if (!index) return tl::unexpected<Error>(std::move(index.error()));
  return std::unique_ptr<StorageReader>(new McapReader(std::move(source), name, std::move(*index)));
}

}  // namespace goalnet::ros
