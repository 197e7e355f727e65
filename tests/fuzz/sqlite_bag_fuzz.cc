// Whatever bytes a .db3 file holds: messages and at most one error, never harm.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/read_all.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  return read_all(open_sqlite_in_memory({data, data + size}));
}
