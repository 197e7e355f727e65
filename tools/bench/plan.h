// planning time on the benchmark's problems, on growing worlds and of parsing
#pragma once

#include <nlohmann/json.hpp>

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Problems from the recorded demonstrations (each recorded state to the next difference; start to net
// difference), where options.data or ../shared/data/goalnet has them, and generated ones. Every plan is
// validated.
nlohmann::json bench_plan(const BenchOptions& options);

}  // namespace goalnet::tools
