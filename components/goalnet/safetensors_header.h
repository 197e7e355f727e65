// The JSON header of a safetensors file, parsed strictly: known keys, no duplicates, bounded depth and
// counts.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "components/goalnet/safetensors.h"

namespace goalnet::inference {

struct TensorHeader {
  std::map<std::string, TensorEntry, std::less<>> tensors;
  std::map<std::string, std::string, std::less<>> metadata;
};

// Checks syntax, types and counts; offsets and overlaps are checked by check_layout. `name` starts every
// message.
Expected<TensorHeader> parse_header(std::string_view json, const std::string& name,
                                    const TensorLimits& limits);

// Every tensor lies inside `data_bytes`, is as long as its shape says, and all of them tile the data block
// without a gap or an overlap (the format demands it, and it leaves no place to hide anything).
Expected<void> check_layout(const TensorHeader& header, std::uint64_t data_bytes, const std::string& name);

}  // namespace goalnet::inference
