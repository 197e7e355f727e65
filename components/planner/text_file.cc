#include "components/planner/text_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace goalnet::planner {

Expected<FileText> read_text_file(const std::string& path, const std::stop_token& stop) {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file)
    return fail(Outcome::kInvalidRequest, path + ": cannot be opened; does it exist and may it be read?");
  // In pieces, so that a huge file, or one that never ends, does not keep us.
  constexpr std::size_t kPiece = 1u << 16;
  const auto cancelled = [&] { return fail(Outcome::kCancelled, path + ": reading was cancelled"); };
  std::error_code unknown;
  const auto size_told = std::filesystem::file_size(path, unknown);
  std::size_t room = unknown ? kPiece : std::min<std::size_t>(size_told, kLargestText) + kPiece;
  FileText result;
  char* text = result.memory.allocate<char>(room);
  std::size_t size = 0;
  while (size <= kLargestText) {
    if (stop.stop_requested()) return cancelled();
    if (room - size < kPiece) {  // longer than we were told
      FileText larger;
      char* const more = larger.memory.allocate<char>(room *= 2);
      for (std::size_t at = 0; at < size; at += kPiece) {
        if (stop.stop_requested()) return cancelled();
        std::copy_n(text + at, std::min(kPiece, size - at), more + at);
      }
      result = std::move(larger);
      text = more;
    }
    const std::size_t got = std::fread(text + size, 1, kPiece, file.get());
    size += got;
    if (std::ferror(file.get()) != 0) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
    if (got < kPiece) break;
  }
  result.text = {text, size};
  return result;
}

}  // namespace goalnet::planner
