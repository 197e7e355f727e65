// Whatever a demonstration file holds: a demonstration whose parts fit together, or one message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/goalnet/demonstration.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::inference;
  const auto demonstration = parse_demonstration({reinterpret_cast<const char*>(data), size}, "1_fuzz.json");
  if (!demonstration) {
    if (demonstration.error().message.empty()) std::abort();
    return 0;
  }
  if (demonstration->states.size() != demonstration->actions.size() + 1) std::abort();
  if (demonstration->steps.size() != demonstration->actions.size()) std::abort();
  return 0;
}
