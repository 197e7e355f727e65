#include "components/ros/bag/bag_reader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "components/ros/bag/compression.h"

namespace goalnet::ros {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestMessage = std::size_t{256} << 20;  // [bytes], as of chunks

}  // namespace

Expected<std::unique_ptr<StorageReader>> open_bag_file(const std::string& path, BagStorage storage) {
  if (storage == BagStorage::kSqlite) return open_sqlite(path);
  auto source = open_file(path);
  if (!source) return tl::unexpected<Error>(std::move(source.error()));
  return open_mcap(std::move(*source), path);
}

Expected<BagMetadata> read_bag_metadata(const std::string& directory) {
  const std::string path = (fs::path(directory) / "metadata.yaml").string();
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return fail(Outcome::kInvalidRequest,
                directory + " is no bag: it has no metadata.yaml (\"goalnet record --repair " + directory +
                    "\" makes one from the bag's files)");
  }
  std::stringstream text;
  text << file.rdbuf();
  auto metadata = parse_bag_metadata(text.str());
  if (!metadata) return fail(Outcome::kInvalidRequest, path + ": " + metadata.error().message);
  return metadata;
}

Expected<std::unique_ptr<BagReader>> BagReader::open(const std::string& path) {
  std::error_code error;
  std::vector<File> files;
  auto compression = BagCompression::kNone;
  if (fs::is_directory(path, error)) {
    const auto metadata = read_bag_metadata(path);
    if (!metadata) return tl::unexpected(metadata.error());
    const auto found = bag_compression(*metadata);
    if (!found) return fail(Outcome::kInvalidRequest, path + ": " + found.error().message);
    compression = *found;
    for (const BagFile& file : metadata->files)
      files.push_back({(fs::path(path) / file.path).string(), metadata->storage});
    if (files.empty()) return fail(Outcome::kInvalidRequest, path + " lists no files");
  } else if (path.ends_with(".mcap") || path.ends_with(".db3")) {
    files.push_back({path, path.ends_with(".mcap") ? BagStorage::kMcap : BagStorage::kSqlite});
  } else {
    return fail(Outcome::kInvalidRequest,
                path + (fs::exists(path, error)
                            ? " is no bag: a directory with metadata.yaml, or an .mcap or .db3 file"
                            : " does not exist"));
  }
  std::unique_ptr<BagReader> reader(new BagReader(std::move(files), compression));
  // All files once, so that all topics are known and a missing file is told before anything is played.
  for (std::size_t i = reader->files_.size(); i-- > 0;) {
    if (auto opened = reader->open_file_at(i); !opened)
      return tl::unexpected<Error>(std::move(opened.error()));
  }
  return reader;
}

Expected<void> BagReader::open_file_at(std::size_t index) {
  const File& file = files_[index];
  std::unique_ptr<TemporaryFile> plain;
  // A crash may leave the last file as it was, not compressed yet.
  if (compression_ == BagCompression::kFiles && file.path.ends_with(".zstd")) {
    auto made = decompress_file(file.path, file.storage == BagStorage::kMcap ? ".mcap" : ".db3");
    if (!made) return tl::unexpected<Error>(std::move(made.error()));
    plain = std::move(*made);
  }
  auto reader = open_bag_file(plain ? plain->path() : file.path, file.storage);
  if (!reader) {
    Error error = std::move(reader.error());
    if (plain) error.message = file.path + ", decompressed: " + error.message;
    return tl::unexpected<Error>(std::move(error));
  }
  reader_ = std::move(*reader);
  plain_ = std::move(plain);
  current_ = index;
  finished_ = finished_ && reader_->finished();
  topic_map_.clear();
  for (const BagTopic& topic : reader_->topics()) {
    const auto known = std::find_if(topics_.begin(), topics_.end(), [&](const BagTopic& other) {
      return other.name == topic.name && other.type == topic.type;
    });
    topic_map_.push_back(static_cast<std::size_t>(known - topics_.begin()));
    if (known == topics_.end()) topics_.push_back(topic);
  }
  return {};
}

Expected<bool> BagReader::next(BagMessage& message) {
  for (;;) {
    auto more = reader_->next(message);
    if (!more) return more;
    if (*more) {
      message.topic = topic_map_[message.topic];
      if (compression_ != BagCompression::kMessages) return true;
      auto payload = decompress_frame(message.payload, kLargestMessage);
      if (!payload) {
        return fail(Outcome::kInvalidRequest, files_[current_].path + ": a message of " +
                                                  topics_[message.topic].name + ": " +
                                                  payload.error().message);
      }
      message.payload = std::move(*payload);
      return true;
    }
    if (current_ + 1 >= files_.size()) return false;
    if (auto opened = open_file_at(current_ + 1); !opened)
      return tl::unexpected<Error>(std::move(opened.error()));
  }
}

Expected<void> BagReader::rewind() { return open_file_at(0); }

}  // namespace goalnet::ros
