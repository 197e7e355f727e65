// What a message is most likely about, by its words and what they name, where the grammar cannot read it: for
// each request that is possible here a log-linear probability that it is asked for (Berant & Liang 2014 rank
// canonical sentences in that way). Learned from instructions with known goals (goalnet_fit_gist).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "components/goalnet/gist/request.h"

namespace goalnet::inference::gist {

struct Likely {
  std::vector<Request> requests;  // in the order in which they are done
  double probability = 0;         // that they are asked for, and nothing else; 0 where there are none
};

class GistModel {
 public:
  // A safetensors file with one tensor "weights". Fails with kInvalidRequest.
  static Expected<GistModel> load(const std::string& path);
  explicit GistModel(std::vector<float> weights) : weights_(std::move(weights)) {}
  Expected<void> save(const std::string& path, const std::string& made_by) const;

  // Of each view the likeliest request of those that want the same; the views' scores are averaged.
  Likely likely(const Views& views) const;
  float score(std::span<const std::uint32_t> features) const;

 private:
  std::vector<float> weights_;  // kFeatures; none: nothing is likely
};

}  // namespace goalnet::inference::gist
