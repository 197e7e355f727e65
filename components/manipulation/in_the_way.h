// When no hand gets at something: which movable things, were they gone, would let it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/manipulation/stand_search.h"

namespace goalnet::manipulation {

// While it lives, everything that may be put aside is taken for gone: what no hand holds, what does not ride
// on the robot's tray, and what Workbench::staying() does not name.
class ThingsAway {
 public:
  explicit ThingsAway(Workbench& bench);
  ~ThingsAway();
  ThingsAway(const ThingsAway&) = delete;
  ThingsAway& operator=(const ThingsAway&) = delete;

 private:
  CollisionChecker& checker_;
};

// For ways that find_stand() found nothing among: the few things that stand in one of them. Nothing if it
// would not work without them either, or if too many would have to go.
std::optional<InTheWay> find_in_the_way(Workbench& bench, const std::vector<Reach>& reaches,
                                        const StandSearchOptions& options);

}  // namespace goalnet::manipulation
