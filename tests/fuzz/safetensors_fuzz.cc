// Whatever bytes a model file holds: a checked file or one message, never harm.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/goalnet/network/network_model.h"
#include "components/goalnet/safetensors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::inference;
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  const auto file = SafeTensors::parse({bytes, bytes + size}, "fuzz");
  if (!file) {
    if (file.error().message.empty()) std::abort();
    return 0;
  }
  for (const auto& [name, entry] : file->tensors()) static_cast<void>(file->floats(name, entry.shape));
  static_cast<void>(make_network_model(*file));
  return 0;
}
