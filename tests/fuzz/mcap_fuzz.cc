// Whatever bytes an MCAP file holds: messages and at most one error, in bounded memory, never harm.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/read_all.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  return read_all(open_mcap(bytes_in_memory({data, data + size}), "fuzz"));
}
