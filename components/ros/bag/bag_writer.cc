#include "components/ros/bag/bag_writer.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace goalnet::ros {
namespace {

namespace fs = std::filesystem;

// The directory's own name, also for "." and "bags/today/".
std::string base_name(const std::string& directory) {
  std::error_code ignored;
  fs::path path = fs::absolute(directory, ignored).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.filename().string();
}

}  // namespace

Expected<void> write_bag_metadata(const std::string& directory, const BagMetadata& metadata, Distro distro) {
  const fs::path path = fs::path(directory) / "metadata.yaml";
  const std::string fresh = path.string() + ".new";
  {
    std::ofstream file(fresh, std::ios::trunc | std::ios::binary);
    file << bag_metadata_yaml(metadata, distro);
    if (!file.flush()) return fail(Outcome::kInternal, "cannot write " + fresh);
  }
  std::error_code error;
  fs::rename(fresh, path, error);
  if (error) return fail(Outcome::kInternal, "cannot write " + path.string() + ": " + error.message());
  return {};
}

Expected<std::unique_ptr<BagWriter>> BagWriter::create(const BagWriterOptions& options) {
  std::error_code error;
  if (options.directory.empty()) return fail(Outcome::kInvalidRequest, "the recording needs a directory");
  if (fs::exists(options.directory, error)) {
    return fail(Outcome::kInvalidRequest,
                "the recording " + options.directory + " exists already; choose another name");
  }
  fs::create_directories(options.directory, error);
  if (error)
    return fail(Outcome::kInvalidRequest, "cannot make " + options.directory + ": " + error.message());
  std::unique_ptr<BagWriter> writer(new BagWriter(options));
  writer->metadata_.storage = options.storage;
  if (auto begun = writer->begin_file(); !begun) return tl::unexpected<Error>(std::move(begun.error()));
  auto written = write_bag_metadata(options.directory, writer->metadata_, options.file.distro);
  if (!written) return tl::unexpected<Error>(std::move(written.error()));
  return writer;
}

BagWriter::~BagWriter() { static_cast<void>(close()); }

Expected<void> BagWriter::begin_file() {
  const std::string name = base_name(options_.directory) + "_" + std::to_string(metadata_.files.size()) +
                           std::string(bag_file_extension(options_.storage));
  metadata_.files.push_back({name, kNoStart, 0, 0});
  const std::string path = (fs::path(options_.directory) / name).string();
  const auto create = options_.storage == BagStorage::kMcap ? create_mcap_writer : create_sqlite_writer;
  auto file = create(path, metadata_, options_.file);
  if (!file) return tl::unexpected<Error>(std::move(file.error()));
  file_ = std::move(*file);
  for (const BagTopic& topic : metadata_.topics) {
    if (auto added = file_->add_topic(topic); !added) return added;
  }
  return {};
}

Expected<void> BagWriter::end_file() {
  size_of_ended_ += file_->size();
  auto done = file_->finish(metadata_);
  file_.reset();
  return done;
}

Expected<std::size_t> BagWriter::add_topic(const BagTopic& topic) {
  if (file_ == nullptr) return fail(Outcome::kInternal, "the recording is closed");
  if (auto added = file_->add_topic(topic); !added) return tl::unexpected<Error>(std::move(added.error()));
  metadata_.topics.push_back(topic);
  metadata_.topics.back().message_count = 0;
  return metadata_.topics.size() - 1;
}

void BagWriter::set_offered(std::size_t topic, std::vector<OfferedQos> offered) {
  metadata_.topics.at(topic).offered = std::move(offered);
}

bool BagWriter::full(std::uint64_t log_time) const {
  const BagFile& file = metadata_.files.back();
  if (file.message_count == 0) return false;
  if (options_.split_bytes > 0 && file_->size() >= options_.split_bytes) return true;
  const auto span = static_cast<std::uint64_t>(options_.split_duration.count());
  return span > 0 && log_time > file.start && log_time - file.start >= span;
}

Expected<void> BagWriter::write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                                std::span<const std::uint8_t> payload) {
  if (file_ == nullptr) return fail(Outcome::kInternal, "the recording is closed");
  if (full(log_time)) {
    if (auto ended = end_file(); !ended) return ended;
    if (auto begun = begin_file(); !begun) return begun;
  }
  if (auto written = file_->write(topic, log_time, publish_time, payload); !written) return written;
  BagFile& file = metadata_.files.back();
  const std::uint64_t end =
      file.message_count == 0 ? log_time : std::max(file.start + file.duration, log_time);
  file.start = std::min(file.start, log_time);
  file.duration = end - file.start;
  ++file.message_count;
  ++metadata_.topics.at(topic).message_count;
  return {};
}

Expected<void> BagWriter::flush() {
  if (file_ == nullptr) return {};
  if (auto flushed = file_->flush(); !flushed) return flushed;
  return write_bag_metadata(options_.directory, metadata_, options_.file.distro);
}

Expected<void> BagWriter::close() {
  if (file_ == nullptr) return {};
  auto done = end_file();
  auto described = write_bag_metadata(options_.directory, metadata_, options_.file.distro);
  return done ? described : done;
}

std::uint64_t BagWriter::size() const { return size_of_ended_ + (file_ ? file_->size() : 0); }

}  // namespace goalnet::ros
