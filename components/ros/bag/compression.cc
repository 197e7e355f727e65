#include "components/ros/bag/compression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <stdexcept>
#include <string>

namespace goalnet::ros {
namespace {

bool decompress_lz4(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) return false;
  std::size_t done = 0, left = 1;
  while (left != 0 && !bytes.empty()) {
    std::size_t written = out.size() - done, read = bytes.size();
    left = LZ4F_decompress(context, out.data() + done, &written, bytes.data(), &read, nullptr);
    if (LZ4F_isError(left) || (written == 0 && read == 0)) break;  // broken, or larger than it said
    done += written;
    bytes = bytes.subspan(read);
  }
  LZ4F_freeDecompressionContext(context);
  return left == 0 && done == out.size();
}

}  // namespace

std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));  // only for want of memory
  out.resize(size);
  return out;
}

Expected<std::vector<std::uint8_t>> decompress_frame(std::span<const std::uint8_t> bytes,
                                                     std::size_t largest) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR) return fail(Outcome::kInvalidRequest, "it is not compressed with zstd");
  if (size == ZSTD_CONTENTSIZE_UNKNOWN)
    return fail(Outcome::kInvalidRequest, "its zstd data do not tell their size");
  if (size > largest) return fail(Outcome::kInvalidRequest, "it decompresses to more than is read");
  return decompress("zstd", bytes, static_cast<std::size_t>(size));
}

Expected<std::vector<std::uint8_t>> decompress(std::string_view name, std::span<const std::uint8_t> bytes,
                                               std::size_t size) {
  if (name.empty()) {
    if (bytes.size() != size) return fail(Outcome::kInvalidRequest, "its size is not what it says");
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  }
  std::vector<std::uint8_t> out(size);
  if (name == "zstd") {
    const std::size_t done = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(done) || done != size)
      return fail(Outcome::kInvalidRequest, "its zstd data are damaged");
    return out;
  }
  if (name == "lz4") {
    if (!decompress_lz4(bytes, out)) return fail(Outcome::kInvalidRequest, "its lz4 data are damaged");
    return out;
  }
  return fail(Outcome::kInvalidRequest, "its compression \"" + std::string(name.substr(0, 20)) +
                                            "\" is unknown (zstd and lz4 are read)");
}

}  // namespace goalnet::ros
