// The way of a received sample, for every type of idl/: check, decode, encode. The first two bytes choose the
// type. What the check lets through must decode, must not have grown beyond its bytes, and encodes to what
// decodes again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "components/ros/detail/cyclone_service.h"
#include "components/ros/detail/message_type.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet;
  static const std::vector<const idl::TypeSupport*> kTypes = [] {
    std::vector<const idl::TypeSupport*> all;
    for (const auto& type : idl::all_types()) {
      if (const auto* support = idl::find_type_support(type.name)) all.push_back(support);
    }
    return all;
  }();
  if (size < 2) return 0;
  const auto& support = *kTypes[(data[0] | data[1] << 8) % kTypes.size()];
  const std::span<const std::uint8_t> payload(data + 2, size - 2);
  // As a server reads a request of rmw_cyclonedds: what is taken out, put back in, is the same.
  const std::vector<std::uint8_t> whole(payload.begin(), payload.end());
  auto without = whole;
  if (const auto header = ros::detail::take_cyclone_header(without)) {
    if (payload[1] != 0 && ros::detail::with_cyclone_header(without, *header) != whole) std::abort();
  } else if (without != whole || payload.size() >= 20) {
    std::abort();
  }
  const auto& layout = ros::detail::layout_of(support);
  const std::shared_ptr<void> message(support.create(), support.destroy);
  const bool good = layout.check(payload) == nullptr;
  const char* fault = ros::detail::decode(support, layout, payload, message.get());
  if (good != (fault == nullptr)) std::abort();  // the decoder refuses what the check let through
  if (good != !layout.data_mask(payload).empty()) std::abort();
  if (!good) return 0;
  const auto again = ros::detail::encode(support, message.get());
  if (again.empty()) std::abort();
  const std::shared_ptr<void> second(support.create(), support.destroy);
  if (ros::detail::decode(support, layout, again, second.get()) != nullptr) std::abort();
  if (ros::detail::encode(support, second.get()) != again) std::abort();
  return 0;
}
