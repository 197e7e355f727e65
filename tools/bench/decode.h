// a whole decoded instruction by the shipped model: candidate runs, re-ranking, goals
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Keys: "robot" (load_model's default use), "benchmark" (the scored use): the instructions of one kitchen;
// "recorded" (the scored use): the sentences of DATA/val, where there is that folder. Each has summaries in ms
// of the wall's clock and in cpu_ms of the thread's; nothing is remembered between instructions.
nlohmann::json bench_decode(const BenchOptions& options);

}  // namespace goalnet::tools
