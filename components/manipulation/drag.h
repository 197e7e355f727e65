// A thing that lies where no hand gets around it (flat on a table, against a wall) is pressed upon from above
// and dragged along: away from what is near, or so far over the edge of what it lies on that fingers reach
// below it.
#pragma once

#include <string>
#include <vector>

#include "components/manipulation/stand_search.h"

namespace goalnet::manipulation {

// Ways to do so with any empty hand, tool poses: at first one or two above, then pressing, where it was
// dragged to, above again. Only to places where a grasp has room that has none here, and where the thing does
// not fall. `tag`: from kDrag upwards.
constexpr std::size_t kDrag = 1'000'000;
std::vector<Reach> drag_reaches(Workbench& bench, const std::string& object);

}  // namespace goalnet::manipulation
