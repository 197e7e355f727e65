// Files that people name, read whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "components/core/outcome.h"

namespace goalnet {

// The file's bytes. kInvalidRequest if it cannot be read, is a folder or has more than `most` bytes; no more
// than that is ever read, also of a device that has no end.
Expected<std::string> read_file(const std::filesystem::path& path, std::size_t most);

}  // namespace goalnet
