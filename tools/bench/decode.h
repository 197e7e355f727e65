// a whole decoded instruction by the shipped model: candidate runs, re-ranking, goals
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Keys: "robot" (load_model's default use), "benchmark" (the scored use): summaries in ms over the
// instructions of one kitchen; nothing is remembered between them.
nlohmann::json bench_decode(const BenchOptions& options);

}  // namespace goalnet::tools
