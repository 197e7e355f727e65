#include <memory>

#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/network/network_model.h"
#include "components/goalnet/training/torch_network.h"
#include "tools/bench/infer/peer.h"

namespace goalnet::tools {

using namespace inference;

namespace {

// Everything the forward pass needs, encoded beforehand: libtorch is not charged for strings.
struct Peer {
  network::NetworkConfig config;
  training::Vocabulary vocabulary;
  training::TorchNetwork network;
  training::EpisodeEncoder encoder;
  std::vector<training::EncodedEpisode> episodes;

  Peer(const network::ModelParts& parts, const SafeTensors& file)
      : config(parts.config),
        vocabulary{parts.lexicon, parts.grammar, parts.weights.vectors},
        network(config, vocabulary, 1),
        encoder(config, vocabulary) {
    torch::NoGradGuard no_gradients;
    for (auto& [name, tensor] : network.parameters()) {
      const std::vector<std::uint64_t> shape = {static_cast<std::uint64_t>(tensor.size(0)),
                                                static_cast<std::uint64_t>(tensor.size(1))};
      const auto values = file.floats(name, shape);
      if (values)
        std::memcpy(tensor.data_ptr<float>(), values->values.data(), values->values.size() * sizeof(float));
    }
  }
};

}  // namespace

std::function<void(std::size_t)> make_infer_peer(const SafeTensors& file,
                                                 const std::vector<InferStep>& steps) {
  torch::set_num_threads(1);
  const auto parts = network::load_parts(file);
  const auto model = make_network_model(file);
  if (!parts || !model) return {};
  const auto peer = std::make_shared<Peer>(**parts, file);
  for (const InferStep& step : steps) {
    const auto goal = (*model)->infer(step.input());
    training::Episode episode{"1_1", "1", step.sentence, {}, step.states, step.goals, step.goals};
    episode.goals.push_back(goal ? *goal : Goal{});
    episode.pursued.push_back({});
    auto encoded = peer->encoder.encode(episode, false);
    if (!encoded) return {};
    // Only the last step is decoded; the memory reads the goals before it.
    training::StepExample last = encoded->steps.back();
    last.goals_before = 0;
    encoded->steps.assign(1, last);
    encoded->past.clear();
    peer->episodes.push_back(std::move(*encoded));
  }
  return [peer](std::size_t i) { peer->network.scores(peer->episodes[i], peer->encoder.names()); };
}

}  // namespace goalnet::tools
