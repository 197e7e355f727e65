// The type hash in the USER_DATA of an endpoint that somebody announces.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/detail/user_data.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros::detail;
  const auto hash = type_hash_of({data, size});
  if (hash.empty()) return 0;
  if (hash.size() != 71 || !hash.starts_with("RIHS01_")) std::abort();
  // What was found is written and found again.
  const std::string text = "typehash=" + hash + ";";
  if (type_hash_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}) != hash) std::abort();
  return 0;
}
