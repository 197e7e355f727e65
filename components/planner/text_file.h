// Reads files. Internal to the planner.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>

#include "components/core/outcome.h"
#include "components/planner/arena.h"

namespace goalnet::planner {

inline constexpr std::size_t kLargestText = 256u << 20;  // [bytes] that a parser takes

struct FileText {
  Arena memory;
  std::string_view text;
};

// What is in the file, at most one piece longer than a parser takes; or kInvalidRequest, or kCancelled soon
// after `stop` asks.
Expected<FileText> read_text_file(const std::string& path, const std::stop_token& stop);

}  // namespace goalnet::planner
