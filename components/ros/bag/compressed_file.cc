#include "components/ros/bag/compressed_file.h"

#include <unistd.h>
#include <zstd.h>

#include <cstdio>
#include <filesystem>
#include <vector>

namespace goalnet::ros {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

struct FreeStream {
  void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
};

}  // namespace

Expected<BagCompression> bag_compression(const BagMetadata& metadata) {
  std::string mode = metadata.compression_mode;
  for (char& c : mode) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (mode.empty() || mode == "NONE") return BagCompression::kNone;
  if (mode != "FILE" && mode != "MESSAGE") {
    return fail(Outcome::kInvalidRequest,
                "compression_mode \"" + mode.substr(0, 20) + "\" is unknown (file and message are read)");
  }
  if (metadata.compression_format != "zstd") {
    return fail(Outcome::kInvalidRequest, "compression_format \"" +
                                              metadata.compression_format.substr(0, 20) +
                                              "\" is not read (zstd is); \"ros2 bag convert\" undoes it");
  }
  return mode == "FILE" ? BagCompression::kFiles : BagCompression::kMessages;
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Expected<std::unique_ptr<TemporaryFile>> decompress_file(const std::string& path, const std::string& suffix,
                                                         std::uint64_t largest) {
  const File in(std::fopen(path.c_str(), "rb"));
  if (!in) return fail(Outcome::kInvalidRequest, path + " cannot be read; is it there?");
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  std::string name = (error ? std::filesystem::path("/tmp") : folder) / ("goalnet_bag_XXXXXX" + suffix);
  const int descriptor = mkstemps(name.data(), static_cast<int>(suffix.size()));
  if (descriptor < 0) return fail(Outcome::kInternal, "no temporary file can be made in " + folder.string());
  auto made = std::make_unique<TemporaryFile>(name);
  const File out(fdopen(descriptor, "wb"));
  const std::unique_ptr<ZSTD_DStream, FreeStream> stream(ZSTD_createDStream());
  if (!out || !stream) return fail(Outcome::kInternal, "no memory to decompress " + path);
  std::vector<char> compressed(ZSTD_DStreamInSize()), plain(ZSTD_DStreamOutSize());
  std::uint64_t total = 0;
  std::size_t left = 0;  // 0: at the end of a frame
  while (const std::size_t got = std::fread(compressed.data(), 1, compressed.size(), in.get())) {
    ZSTD_inBuffer input{compressed.data(), got, 0};
    while (input.pos < input.size) {
      ZSTD_outBuffer output{plain.data(), plain.size(), 0};
      left = ZSTD_decompressStream(stream.get(), &output, &input);
      if (ZSTD_isError(left)) return fail(Outcome::kInvalidRequest, path + ": its zstd data are damaged");
      total += output.pos;
      if (total > largest) {
        return fail(Outcome::kInvalidRequest, path + " decompresses to more than " +
                                                  std::to_string(largest >> 20) +
                                                  " MB, the most that is read");
      }
      if (std::fwrite(plain.data(), 1, output.pos, out.get()) != output.pos)
        return fail(Outcome::kInternal, name + " cannot be written; is the disk full?");
    }
  }
  if (left != 0 || total == 0) return fail(Outcome::kInvalidRequest, path + ": its zstd data are cut short");
  if (std::fflush(out.get()) != 0)
    return fail(Outcome::kInternal, name + " cannot be written; is the disk full?");
  return made;
}

}  // namespace goalnet::ros
