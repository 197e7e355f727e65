// ROS 2 layer: latency between two processes beside plain Fast DDS, services, start to first message
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Starts goalnet-bench-peer (beside the running program) as the other process. Throws where it does not
// answer.
nlohmann::json bench_ros(const BenchOptions& options);

}  // namespace goalnet::tools
