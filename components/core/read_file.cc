#include "components/core/read_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace goalnet {

Expected<std::string> read_file(const std::filesystem::path& path, std::size_t most) {
  const auto bad = [&](const std::string& what) {
    return fail(Outcome::kInvalidRequest, path.string() + ": " + what);
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return bad("is a folder; a file is expected");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return bad(std::string("cannot be read: ") + std::strerror(errno));
  std::string text;
  constexpr std::size_t kPiece = 1 << 16;
  while (file && text.size() <= most) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    file.read(text.data() + before, kPiece);
    text.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) return bad("cannot be read to its end");
  if (text.size() > most) return bad("is larger than " + std::to_string(most >> 20) + " MB");
  return text;
}

}  // namespace goalnet
