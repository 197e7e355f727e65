// The frame of `goalnet bench`: every part that makes a promise about speed measures it here.
//
// A benchmark NAME is a pair tools/bench/NAME.{h,cc} that declares
//     nlohmann::json bench_NAME(const BenchOptions&);
// in namespace goalnet::tools; the first line of the header, after "// ", is its summary in `goalnet bench
// --help`. The build finds it by its file name. It returns one object whose keys carry their units
// (median_us, …), and either measures or throws std::runtime_error with the reason; it never reports a number
// that it did not measure.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace goalnet::tools {

struct BenchOptions {
  bool quick = false;  // fewer repetitions, for trying out
  std::uint64_t seed = 1;
  std::string data;  // folder of demonstrations; empty: ../shared/data/goalnet beside the source, if there
};

// Order statistics of a sample: {"count", "median_UNIT", "p90_UNIT", "p99_UNIT", "max_UNIT", "mean_UNIT"}.
nlohmann::json summary(std::vector<double> sample, const std::string& unit);

}  // namespace goalnet::tools
