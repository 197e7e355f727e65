#include "components/ros/bag/bag_repair.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "components/ros/bag/bag_reader.h"
#include "components/ros/bag/bag_writer.h"
#include "components/ros/bag/sqlite_database.h"

namespace goalnet::ros {
namespace {

namespace fs = std::filesystem;

// The number at the end of "name_12.mcap"; files are played in its order.
int file_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  const auto at = stem.find_last_of('_');
  int number = 0;
  if (at != std::string::npos) std::from_chars(stem.data() + at + 1, stem.data() + stem.size(), number);
  return number;
}

Expected<std::vector<fs::path>> bag_files(const std::string& directory) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const auto extension = entry.path().extension();
    if (extension == ".mcap" || extension == ".db3") files.push_back(entry.path());
  }
  if (error) return fail(Outcome::kInvalidRequest, "cannot read " + directory + ": " + error.message());
  if (files.empty()) return fail(Outcome::kInvalidRequest, directory + " has no .mcap or .db3 file");
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return file_number(a) != file_number(b) ? file_number(a) < file_number(b) : a < b;
  });
  if (files.front().extension() != files.back().extension()) {
    return fail(Outcome::kInvalidRequest, directory + " has both .mcap and .db3 files; a bag has one kind");
  }
  return files;
}

// Nobody may be writing the file any more. SQLite's write-ahead log is folded in at this occasion.
Expected<void> check_not_recording(const std::string& path, BagStorage storage) {
  const auto busy = [&] {
    return fail(Outcome::kInvalidRequest, path + " is still being recorded; end the recorder first");
  };
  if (storage == BagStorage::kMcap) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return fail(Outcome::kInvalidRequest, "cannot read " + path);
    const bool alone = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return alone ? Expected<void>() : busy();
  }
  auto database = SqliteDatabase::open(path, SQLITE_OPEN_READWRITE);
  if (!database) return tl::unexpected<Error>(std::move(database.error()));
  if (database->run("PRAGMA journal_mode=DELETE;")) return {};
  const int why = sqlite3_errcode(database->handle());
  if (why == SQLITE_BUSY || why == SQLITE_LOCKED) return busy();
  return fail(Outcome::kInvalidRequest, path + ": " + sqlite3_errmsg(database->handle()));
}

// Adds what a file holds to the metadata of the bag; fills `topic_map` from the file's topics to the bag's.
void take_topics(const StorageReader& reader, BagMetadata& bag, std::vector<std::size_t>& topic_map) {
  for (const BagTopic& topic : reader.topics()) {
    const auto known = std::find_if(bag.topics.begin(), bag.topics.end(),
                                    [&](const BagTopic& other) { return other.name == topic.name; });
    topic_map.push_back(static_cast<std::size_t>(known - bag.topics.begin()));
    if (known != bag.topics.end()) continue;
    bag.topics.push_back(topic);
    bag.topics.back().message_count = 0;
  }
}

// Reads all of one file and, where `copy` is given, writes it there.
Expected<void> go_through(StorageReader& reader, BagMetadata& bag, StorageWriter* copy) {
  std::vector<std::size_t> topic_map;
  take_topics(reader, bag, topic_map);
  if (copy != nullptr) {
    for (const BagTopic& topic : reader.topics()) {
      if (auto added = copy->add_topic(topic); !added) return added;
    }
  }
  BagMessage message;
  for (;;) {
    auto more = reader.next(message);
    if (!more) return tl::unexpected<Error>(std::move(more.error()));
    if (!*more) break;
    BagFile& file = bag.files.back();
    const std::uint64_t end =
        std::max(file.message_count == 0 ? 0 : file.start + file.duration, message.log_time);
    file.start = std::min(file.start, message.log_time);
    file.duration = end - file.start;
    ++file.message_count;
    ++bag.topics[topic_map[message.topic]].message_count;
    if (copy == nullptr) continue;
    auto written = copy->write(message.topic, message.log_time, message.publish_time, message.payload);
    if (!written) return written;
  }
  return copy != nullptr ? copy->finish(bag) : Expected<void>();
}

// Writes the file again, with its index, and lets it take the old one's name.
Expected<void> rewrite_mcap(const fs::path& path, StorageReader& reader, const StorageOptions& options,
                            BagMetadata& bag) {
  const std::string whole = path.string() + ".repaired";
  std::error_code error;
  fs::remove(whole, error);
  auto copy = create_mcap_writer(whole, bag, options);
  if (!copy) return tl::unexpected<Error>(std::move(copy.error()));
  if (auto done = go_through(reader, bag, copy->get()); !done) {
    fs::remove(whole, error);
    return done;
  }
  fs::rename(whole, path, error);
  if (error) return fail(Outcome::kInternal, "cannot write " + path.string() + ": " + error.message());
  return {};
}

Expected<void> take_file(const fs::path& path, const StorageOptions& options, BagMetadata& bag) {
  if (auto alone = check_not_recording(path.string(), bag.storage); !alone) return alone;
  auto reader = open_bag_file(path.string(), bag.storage);
  if (!reader) return tl::unexpected<Error>(std::move(reader.error()));
  bag.files.push_back({path.filename().string(), kNoStart, 0, 0});
  return (*reader)->finished() ? go_through(**reader, bag, nullptr)
                               : rewrite_mcap(path, **reader, options, bag);
}

}  // namespace

Expected<BagMetadata> repair_bag(const std::string& directory, Distro distro) {
  const auto files = bag_files(directory);
  if (!files) return tl::unexpected(files.error());
  BagMetadata bag;
  bag.storage = files->front().extension() == ".mcap" ? BagStorage::kMcap : BagStorage::kSqlite;
  const StorageOptions options{distro, false};
  for (const fs::path& file : *files) {
    if (auto taken = take_file(file, options, bag); !taken)
      return tl::unexpected<Error>(std::move(taken.error()));
  }
  auto written = write_bag_metadata(directory, bag, distro);
  if (!written) return tl::unexpected<Error>(std::move(written.error()));
  return bag;
}

}  // namespace goalnet::ros
