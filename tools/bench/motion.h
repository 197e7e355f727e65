// motion planning per action: stands, inverse kinematics, paths and timing of everyday actions in the kitchen
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Runs action sequences in physics (executor included, no DDS) and reports the wall time spent planning per action,
// how long actions take in simulated time, and how many of them are done.
nlohmann::json bench_motion(const BenchOptions& options);

}  // namespace goalnet::tools
