#include "components/goalnet/network/network_core.h"

#include <algorithm>

namespace goalnet::inference::network {
namespace {

constexpr std::size_t kMaxNames = 20000;  // a stream of ever new names must not fill the memory

}  // namespace

NetworkCore::NetworkCore(std::unique_ptr<ModelParts> parts)
    : parts_(std::move(parts)),
      names_(parts_->lexicon, parts_->weights.vectors),
      world_encoder_(parts_->config, parts_->lexicon, parts_->grammar, parts_->weights.vectors, names_),
      network_(parts_->config, parts_->weights, names_),
      decoder_(parts_->config, parts_->grammar) {}

int NetworkCore::set_words(std::vector<std::string> texts) {
  texts_ = std::move(texts);
  sentence_.words.clear();
  for (const std::string& word : texts_) sentence_.words.push_back(parts_->lexicon.word(word));
  return sentence_.known();
}

Expected<void> NetworkCore::read_world(const StepInput& input, std::size_t step) {
  const auto goals = input.goals.first(std::min(step, input.goals.size()));
  auto encoded = world_encoder_.encode(sentence_, texts_, input.grounding, input.states[step], goals, world_);
  if (encoded) network_.read_world(world_);
  return encoded;
}

Expected<const DecodedGoal*> NetworkCore::step(const StepInput& input) {
  if (names_.size() > kMaxNames) {
    names_.clear();
    network_.forget();
  }
  if (parts_->config.temporal == TemporalContext::kState) {
    // The memory reads every state so far, the present one last.
    network_.forget();
    for (std::size_t i = 0; i < input.states.size(); ++i) {
      if (auto read = read_world(input, i); !read) return tl::unexpected(read.error());
      network_.remember_state();
    }
  } else if (auto read = read_world(input, input.states.size() - 1); !read) {
    return tl::unexpected(read.error());
  }
  network_.start();
  decoder_.decode(network_, world_, decoded_);
  return &decoded_;
}

}  // namespace goalnet::inference::network
