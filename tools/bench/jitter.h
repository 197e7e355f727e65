// the 1 kHz control thread: how late it wakes beside cyclictest in the same run, and what a cycle costs
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Wake-up lateness of executor::CyclicThread and of cyclictest (package rt-tests), in alternating blocks with
// the same period, priority and CPU, so that both see the same machine; and the time of
// TrajectoryExecutor::cycle() for 22 moving joints. Maxima depend on the host and are reported, not judged.
nlohmann::json bench_jitter(const BenchOptions& options);

}  // namespace goalnet::tools
