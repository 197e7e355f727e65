// Whatever text metadata.yaml holds: what is accepted can be written and read again, the rest is one message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "components/ros/bag/bag_metadata.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  const auto metadata = parse_bag_metadata(std::string(reinterpret_cast<const char*>(data), size));
  if (!metadata) {
    if (metadata.error().message.empty()) std::abort();
    return 0;
  }
  for (const Distro distro : {Distro::kHumble, Distro::kJazzy}) {
    const auto again = parse_bag_metadata(bag_metadata_yaml(*metadata, distro));
    if (!again || again->topics.size() != metadata->topics.size()) std::abort();
    for (std::size_t i = 0; i < again->topics.size(); ++i) {
      if (again->topics[i].name != metadata->topics[i].name) std::abort();
    }
  }
  return 0;
}
