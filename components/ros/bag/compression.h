// Compression of MCAP chunks, zstd and lz4 (frame format), and of single messages.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::ros {

std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t> bytes);

// `name` is "", "zstd" or "lz4"; the result has exactly `size` bytes. kInvalidRequest for what does not
// decompress to that.
Expected<std::vector<std::uint8_t>> decompress(std::string_view name, std::span<const std::uint8_t> bytes,
                                               std::size_t size);

// One zstd frame of any size up to `largest`; kInvalidRequest for anything else.
Expected<std::vector<std::uint8_t>> decompress_frame(std::span<const std::uint8_t> bytes,
                                                     std::size_t largest);

}  // namespace goalnet::ros
