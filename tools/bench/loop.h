// the closed loop end to end: real-time factor, wall-clock time per action
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

nlohmann::json bench_loop(const BenchOptions& options);

}  // namespace goalnet::tools
