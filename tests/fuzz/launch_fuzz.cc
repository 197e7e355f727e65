// Launch files: any text gives commands that can be executed, or one message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tools/goalnet/launch/launch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::tools;
  const LaunchSurroundings surroundings{"/bin/goalnet", {"simulator", "planner"}, "/usr/bin:/bin"};
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto plan = parse_launch(text, "fuzz.yaml", "/folder", {}, surroundings);
  if (!plan) {
    if (!plan.error().message.starts_with("fuzz.yaml")) std::abort();
    return 0;
  }
  if (plan->processes.empty()) std::abort();
  for (const LaunchedProcess& process : plan->processes)
    if (process.name.empty() || process.command.empty() || process.command[0][0] != '/') std::abort();
  return 0;
}
