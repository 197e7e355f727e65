// Whatever bytes a .db3 file holds: messages and at most one error, never harm.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/bag/storage_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  auto file = open_sqlite_in_memory({data, data + size});
  if (!file) {
    if (file.error().message.empty()) std::abort();
    return 0;
  }
  BagMessage message;
  for (;;) {
    const auto more = (*file)->next(message);
    if (!more && more.error().message.empty()) std::abort();
    if (!more || !*more) return 0;
    if (message.topic >= (*file)->topics().size()) std::abort();
  }
}
