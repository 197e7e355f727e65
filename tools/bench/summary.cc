#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/bench/bench.h"

namespace goalnet::tools {

nlohmann::json summary(std::vector<double> sample, const std::string& unit) {
  nlohmann::json result = {{"count", sample.size()}};
  if (sample.empty()) return result;
  std::sort(sample.begin(), sample.end());
  // Nearest rank: the smallest value that at least this part of the sample does not exceed.
  const auto quantile = [&sample](double part) {
    const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(sample.size())));
    return sample[std::max<std::size_t>(rank, 1) - 1];
  };
  result["median_" + unit] = quantile(0.5);
  result["p90_" + unit] = quantile(0.9);
  result["p99_" + unit] = quantile(0.99);
  result["max_" + unit] = sample.back();
  result["mean_" + unit] =
      std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
  return result;
}

}  // namespace goalnet::tools
