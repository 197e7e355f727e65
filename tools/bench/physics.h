// the simulator alone: cost of a physics step, real-time factor, how well joints follow
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Kitchen and default robot, no DDS: everything at rest, all joints moving, and scene loading.
nlohmann::json bench_physics(const BenchOptions& options);

}  // namespace goalnet::tools
