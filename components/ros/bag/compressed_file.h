// rosbag2's own compression, beside what a storage does inside: whole files (x_0.mcap.zstd), or each
// message's payload.
#pragma once

#include <memory>
#include <string>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"

namespace goalnet::ros {

enum class BagCompression { kNone, kFiles, kMessages };

// What metadata.yaml says; kInvalidRequest for formats and modes that are not read.
Expected<BagCompression> bag_compression(const BagMetadata& metadata);

// A file that is deleted with this object.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// Decompresses a zstd file into the folder for temporary files ($TMPDIR), piece by piece; `suffix` ends the
// new name. kInvalidRequest where it is damaged, cut short, or grows beyond kLargestFile.
inline constexpr std::uint64_t kLargestFile = std::uint64_t{64} << 30;  // [bytes]
Expected<std::unique_ptr<TemporaryFile>> decompress_file(const std::string& path, const std::string& suffix,
                                                         std::uint64_t largest = kLargestFile);

}  // namespace goalnet::ros
