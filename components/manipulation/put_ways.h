// Ways to let go of something so that it comes to be in or on another movable thing: dropped through the
// mouth of a bin or cup, laid on a plate, slid into a slot, a spoon stood into a mug.
#pragma once

#include <string>
#include <vector>

#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {

struct PutWay {
  std::vector<Pose> object;  // map frame: the first is reached freely; at the last the fingers open
  double gap = 0.003;        // [m] how near the thing may come to the receiver on the way
  double preference = 0;     // [s] lower is better
};

// For a pose of the receiver (map frame), other things as they are now; deterministic. kNoPlan if the
// thing does not fit, whatever the robot does; kMotionFailed if the receiver does not stand upright.
Expected<std::vector<PutWay>> put_ways(const Workbench& bench, const std::string& object,
                                       const std::string& receiver, const Pose& pose);

}  // namespace goalnet::manipulation
