// Parameter files: any text gives parameters or one message; what was read survives being dumped and read
// again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "components/ros/parameter_file.h"
#include "components/ros/parameter_value.h"
#include "components/ros/parameters.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  const auto read = parse_parameters(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml");
  if (!read) {
    if (read.error().message.find("fuzz.yaml:") != 0) std::abort();
    return 0;
  }
  Parameters parameters;
  for (const ParameterOverride& one : *read) parameters.declare(one.name, one.value, {});
  const auto again = parse_parameters(parameters.dump("/node"), "dump");
  if (!again || again->size() != parameters.names().size()) std::abort();
  for (const ParameterOverride& one : *again) {
    const ParameterValue* value = parameters.find(one.name);
    if (value == nullptr || to_string(*value) != to_string(one.value)) std::abort();
  }
  return 0;
}
