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

Likely GistModel::likely(const Views& views) const {
  if (weights_.empty()) return {};
  struct Best {
    float score;
    const Request* request;
  };
  std::map<std::string, std::vector<Best>> by_what;  // one of each view that has it
  for (const View& view : views)
    for (const Request& request : view.requests) {
      const float value = score(features(view.message, request));
      std::vector<Best>& best = by_what[request.what];
      if (best.empty() || best.back().request->view != request.view)
        best.push_back({value, &request});
      else if (value > best.back().score)
        best.back() = {value, &request};
    }
  double log_probability = 0;
  std::vector<Request> asked;
  for (const auto& [what, best] : by_what) {
    double mean = 0;
    for (const Best& one : best) mean += one.score / static_cast<double>(best.size());
    log_probability -= std::log1p(std::exp(-std::abs(mean)));
    if (mean > 0) asked.push_back(*best.front().request);
  }
  std::stable_sort(asked.begin(), asked.end(), [](const Request& a, const Request& b) {
    return std::pair(a.ask, a.thing) < std::pair(b.ask, b.thing);
  });
  return {asked, asked.empty() ? 0 : std::exp(log_probability)};
}

}  // namespace goalnet::inference::gist
