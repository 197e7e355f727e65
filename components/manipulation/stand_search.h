// Where to stand and which way to reach: the first combination of base pose, lift height, arm, and way of
// reaching that inverse kinematics can follow without touching anything.
#pragma once

#include <optional>
#include <vector>

#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {

// One way to do something with one hand.
struct Reach {
  std::size_t arm = 0;
  std::vector<Pose> tool;  // map frame: the first is reached freely, the others along straight lines in order
  Tolerances tolerances;   // contacts that belong to the doing
  double opening = 0.0;    // [m] between the fingers meanwhile
  double width = 0.0;      // [m] of what the fingers are to close upon; 0: nothing
  double preference = 0.0;  // [s] lower is better
  std::size_t tag = 0;      // the caller's own number for this way
};

struct ReachSolution {
  Stand stand;
  bool drives = false;              // the base has to move
  std::size_t reach = 0;            // index into the list given
  std::vector<ArmPositions> along;  // from the first tool pose to the last
};

struct StandSearchOptions {
  bool may_drive = true;
  bool may_lift = true;
  bool stand_only = false;          // to stand where it is in reach is enough: both hands are full
  bool looks_for_obstacles = true;  // says what is in the way where there is none (add_way_there)
  bool backwards = false;           // hands may point back over the robot: to its tray
  // Extra check of a whole solution, for example a door that swings through the robot; empty: none.
  std::function<bool(const Configuration& start, const Reach&, const std::vector<ArmPositions>&)> accept;
  std::size_t most_reaches = 60;   // per stand
  std::size_t most_tries = 6'000;  // in all: bounds the time of a search in vain (about 0.1 ms each)
  int iterations = PlannerLimits{}.iterations;  // of the free motion from the stand to the first pose
};

// Looks at the present stand first, then at others by how soon they are reached; hindered arms only if no
// other arm can. kMotionFailed if none works.
Expected<ReachSolution> find_stand(Workbench& bench, const std::vector<Reach>& reaches,
                                   const StandSearchOptions& options);

}  // namespace goalnet::manipulation
