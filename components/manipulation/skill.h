// A skill turns one symbolic action into phases: a motion each, planned from the world as it is when its turn
// comes, and a look whether it did what it should.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {

struct Phase {
  std::string stage;  // for people: drive, approach, grasp, ...
  // A trajectory without points: nothing to move. May change what the hands hold.
  std::function<Expected<JointTrajectory>(Workbench&)> plan;
  // Called once the motion is over and has settled; empty: nothing to look at.
  std::function<Expected<void>(Workbench&)> check;
  double settle = 0.0;    // [s] to wait after the motion, besides what the executor waits
  bool optional = false;  // if no motion is found, or it is blocked, go on without
};

using Phases = std::vector<Phase>;

// One action being done. Lives as long as the action.
class Skill {
 public:
  virtual ~Skill() = default;
  // The next way to do it, from the world as it is now; attempts count from 0 and differ from those that
  // failed. Fails with kMotionFailed when there is no (other) way, kInvalidRequest when the action makes no
  // sense now.
  virtual Expected<Phases> attempt(Workbench& bench, int number) = 0;
  // After the last of the phases: whether that was only a part, and attempt() has more to do.
  virtual bool unfinished() const { return false; }
};

// Fails with kInvalidRequest for an unknown action or a wrong number of arguments, kUnknownObject for a name
// that the scene does not have.
Expected<std::unique_ptr<Skill>> make_skill(const Workbench& bench, const Action& action);

// All action names with their numbers of arguments, for messages and tests.
const std::vector<std::pair<std::string, std::size_t>>& skill_names();

}  // namespace goalnet::manipulation
