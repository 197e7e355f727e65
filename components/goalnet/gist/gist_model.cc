#include "components/goalnet/gist/gist_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "components/goalnet/gist/features.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference::gist {

Expected<GistModel> GistModel::load(const std::string& path) {
  auto file = SafeTensors::load(path, {.max_file_bytes = 4ull << 20});
  if (!file) return tl::unexpected(file.error());
  const std::uint64_t shape[] = {kFeatures};
  auto weights = file->floats("weights", shape);
  if (!weights) return tl::unexpected(weights.error());
  return GistModel(std::move(weights->values));
}

Expected<void> GistModel::save(const std::string& path, const std::string& made_by) const {
  SafeTensorsWriter writer;
  writer.metadata("format", "goalnet gist 1");
  writer.metadata("made_by", made_by);
  if (auto added = writer.add("weights", {kFeatures}, weights_); !added) return added;
  return writer.write(path);
}

float GistModel::score(std::span<const std::uint32_t> features) const {
  float sum = 0;
  for (const std::uint32_t feature : features) sum += weights_[feature];
  return sum;
}

Likely GistModel::likely(const Message& message, std::vector<Request> requests) const {
  struct Best {
    float score;
    const Request* request;
  };
  std::map<std::string, Best> by_what;
  for (const Request& request : requests) {
    const float value = score(features(message, request));
    const auto [at, fresh] = by_what.try_emplace(request.what, Best{value, &request});
    if (!fresh && value > at->second.score) at->second = {value, &request};
  }
  double log_probability = 0;
  std::vector<Request> asked;
  for (const auto& [what, best] : by_what) {
    log_probability -= std::log1p(std::exp(-std::abs(static_cast<double>(best.score))));
    if (best.score > 0) asked.push_back(*best.request);
  }
  std::stable_sort(asked.begin(), asked.end(), [](const Request& a, const Request& b) {
    return std::pair(a.ask, a.thing) < std::pair(b.ask, b.thing);
  });
  return {asked, asked.empty() ? 0 : std::exp(log_probability)};
}

}  // namespace goalnet::inference::gist
