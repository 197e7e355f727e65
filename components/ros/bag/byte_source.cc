#include "components/ros/bag/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace goalnet::ros {
namespace {

// Small reads come from a window of the file, so that walking over many records costs few calls.
class File : public ByteSource {
 public:
  File(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  ~File() override { ::close(descriptor_); }
  File(const File&) = delete;
  std::uint64_t size() const override { return size_; }
  bool read(std::uint64_t offset, std::span<std::uint8_t> out) override {
    if (out.size() > kWindow) return fetch(offset, out);
    if (offset > size_ || out.size() > size_ - offset) return false;
    if (offset < at_ || offset + out.size() > at_ + window_.size()) {
      window_.resize(std::min<std::uint64_t>(kWindow, size_ - offset));
      at_ = offset;
      if (!fetch(at_, window_)) {
        window_.clear();
        return false;
      }
    }
    std::copy_n(window_.begin() + static_cast<std::ptrdiff_t>(offset - at_), out.size(), out.begin());
    return true;
  }

 private:
  static constexpr std::size_t kWindow = 16 * 1024;  // [bytes]

  bool fetch(std::uint64_t offset, std::span<std::uint8_t> out) const {
    while (!out.empty()) {
      const ssize_t got = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      offset += static_cast<std::uint64_t>(got);
      out = out.subspan(static_cast<std::size_t>(got));
    }
    return true;
  }

  const int descriptor_;
  const std::uint64_t size_;
  std::vector<std::uint8_t> window_;
  std::uint64_t at_ = 0;
};

class Memory : public ByteSource {
 public:
  explicit Memory(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  bool read(std::uint64_t offset, std::span<std::uint8_t> out) override {
    if (offset > bytes_.size() || out.size() > bytes_.size() - offset) return false;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
    return true;
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

Expected<std::unique_ptr<ByteSource>> open_file(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    const std::string why = descriptor < 0 ? std::strerror(errno) : "it is no regular file";
    if (descriptor >= 0) ::close(descriptor);
    return fail(Outcome::kInvalidRequest, "cannot read " + path + ": " + why);
  }
  return std::unique_ptr<ByteSource>(new File(descriptor, static_cast<std::uint64_t>(status.st_size)));
}

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::uint8_t> bytes) {
  return std::make_unique<Memory>(std::move(bytes));
}

}  // namespace goalnet::ros
