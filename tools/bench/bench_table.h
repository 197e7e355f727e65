// All benchmarks of this build; the definition is generated from the files in this folder (CMakeLists.txt).
#pragma once

#include <span>

#include "tools/bench/bench.h"

namespace goalnet::tools {

struct Benchmark {
  const char* name;
  const char* summary;
  nlohmann::json (*run)(const BenchOptions&);
};

std::span<const Benchmark> benchmarks();

}  // namespace goalnet::tools
