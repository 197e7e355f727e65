// Bytes that can be read from anywhere: a file, or memory in tests and fuzzers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::ros {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;  // [bytes] when opened
  // Fills all of `out` from `offset`; false if there is not that much.
  virtual bool read(std::uint64_t offset, std::span<std::uint8_t> out) = 0;
};

// kInvalidRequest if it cannot be opened.
Expected<std::unique_ptr<ByteSource>> open_file(const std::string& path);
std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::uint8_t> bytes);

}  // namespace goalnet::ros
