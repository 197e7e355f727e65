// Whether components still live that have not ended: asks each for its lifecycle state, again and again. One
// whose event loop hangs, or whose process was stopped, does not answer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "tools/goalnet/launch/launch_file.h"

namespace goalnet::tools {

// Runs a thread of its own; last() may be called from any.
class LifeSigns {
 public:
  // Asks the components of the plan. Errors as of ros::Context and ros::Node.
  static Expected<std::unique_ptr<LifeSigns>> watch(const LaunchPlan& plan);
  ~LifeSigns();

  // Before they are started: one of them that is up already, started by somebody else; empty: none, after a
  // while.
  std::string up_already() const;

  // When the node with this full name last answered [s of the steady clock]; 0: never.
  double last(const std::string& node) const;

 private:
  struct Impl;
  explicit LifeSigns(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::tools
