// Whatever bytes an MCAP file holds: messages and at most one error, in bounded memory, never harm.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/bag/storage_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  auto file = open_mcap(bytes_in_memory({data, data + size}), "fuzz");
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
