// Starts the processes of a plan, watches them, starts them again where the plan says so, and ends them in
// order.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "tools/goalnet/launch/child_process.h"
#include "tools/goalnet/launch/launch_file.h"

namespace goalnet::tools {

// Something happened to a process.
struct LaunchEvent {
  enum class Kind { kStarted, kSilent, kEnded, kRestarting, kGivenUp, kStopping, kKilled } kind;
  std::string process;
  int pid = 0;               // kStarted, kSilent, kStopping, kKilled
  int exit_code = 0;         // kEnded: 128 + signal where one ended it
  double delay = 0.0;        // [s] kRestarting
  std::string message = {};  // kGivenUp: why; kSilent: since when
};
const char* to_string(LaunchEvent::Kind kind);

struct LaunchCallbacks {
  std::function<void(const LaunchEvent& event)> on_event;
  std::function<void(const std::string& process, const std::string& line, bool error)> on_line;
  std::function<bool()> stop_asked;
  // When a node last gave a sign of life [s of the steady clock]; may be empty.
  std::function<double(const std::string& node)> last_sign = {};
};

// A component that gives no sign of life for restart.silent_after is killed, which counts as a failure. Runs
// until stop_asked(), until a required process is given up, or until all have ended for good. Then whatever
// runs is stopped, the last started first: SIGTERM, after `patience` SIGKILL. Returns kDone, or why not:
// kComponentLost. One thread; it sleeps while there is nothing to do.
Expected<void> launch(const LaunchPlan& plan, const LaunchCallbacks& callbacks);

}  // namespace goalnet::tools
