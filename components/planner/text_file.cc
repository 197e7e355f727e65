#include "components/planner/text_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace goalnet::planner {

Expected<std::string> read_text_file(const std::string& path, const std::stop_token& stop) {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file)
    return fail(Outcome::kInvalidRequest, path + ": cannot be opened; does it exist and may it be read?");
  // In pieces, so that a huge file, or one that never ends, does not keep us.
  std::string text;
  constexpr std::size_t kPiece = 1u << 16;
  std::error_code unknown;
  const auto size_told = std::filesystem::file_size(path, unknown);
  if (!unknown) text.reserve(std::min<std::size_t>(size_told, kLargestText) + kPiece);
  for (std::size_t size = 0; size <= kLargestText;) {
    if (stop.stop_requested()) return fail(Outcome::kCancelled, path + ": reading was cancelled");
    text.resize(size + kPiece);
    const std::size_t got = std::fread(text.data() + size, 1, kPiece, file.get());
    size += got;
    text.resize(size);
    if (std::ferror(file.get()) != 0) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
    if (got < kPiece) break;
  }
  return text;
}

}  // namespace goalnet::planner
