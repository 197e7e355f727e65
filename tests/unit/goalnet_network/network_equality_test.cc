// The Eigen network equals the libtorch network that was trained, score by score, with every part on and off.
#include <cmath>

#include <gtest/gtest.h>

#include "components/goalnet/network/decoder.h"
#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/network/network.h"
#include "components/goalnet/tokenizer.h"
#include "components/goalnet/training/model_writer.h"
#include "components/goalnet/training/torch_network.h"
#include "tests/unit/goalnet_network/example_episode.h"

namespace goalnet::inference::training {
namespace {

using network::NetworkConfig;
using network::SentenceEncoding;
using network::TemporalContext;

constexpr double kTolerance = 1e-5;

std::vector<Episode> episodes() {
  std::vector<Episode> result;
  for (const ExampleEpisode& e : example_episodes()) {
    result.push_back({"1_1", "1", e.sentence, e.grounding, e.states, e.goals, e.goals});
  }
  return result;
}

// Largest difference between all scores of both networks along the demonstrated decisions.
double largest_difference(const NetworkConfig& config) {
  torch::set_num_threads(1);
  const auto vocabulary = make_vocabulary(
      episodes(), {{"mug", std::vector<float>(10, 0.3F)}, {"egg", std::vector<float>(10, -0.2F)}},
      config.word, "");
  EXPECT_TRUE(vocabulary);
  TorchNetwork torch_network(config, *vocabulary, 7);
  {
    torch::NoGradGuard no_gradients;  // biases and learned words start at zero: make them count
    for (auto& [name, tensor] : torch_network.parameters())
      tensor.add_(torch::rand_like(tensor).sub_(0.5), 0.2);
  }
  const auto file = make_model_file(config, *vocabulary, torch_network.tensors(), {});
  EXPECT_TRUE(file);
  const auto read = SafeTensors::parse(file->bytes(), "test");
  EXPECT_TRUE(read) << read.error().message;
  const auto parts = network::load_parts(*read);
  EXPECT_TRUE(parts) << parts.error().message;
  if (!parts) return 1;

  EpisodeEncoder encoder(config, *vocabulary);
  network::Network eigen((*parts)->config, (*parts)->weights, encoder.names());
  double largest = 0;
  int compared = 0;
  for (const Episode& episode : episodes()) {
    auto encoded = encoder.encode(episode, true);
    EXPECT_TRUE(encoded);
    if (config.encoding == SentenceEncoding::kExternal) {
      for (int i = 0; i < config.external; ++i)
        encoded->external.push_back(0.1F * static_cast<float>(i) - 0.2F);
    }
    const auto expected = torch_network.scores(*encoded, encoder.names());
    if (config.encoding == SentenceEncoding::kExternal) {
      eigen.read_sentence(
          network::Vector(Eigen::Map<network::Vector>(encoded->external.data(), config.external)));
    } else {
      eigen.read_sentence(encoded->words);
    }
    eigen.forget();
    for (std::size_t t = 0; t < encoded->steps.size(); ++t) {
      const StepExample& step = encoded->steps[t];
      eigen.read_world(step.world);
      if (config.temporal == TemporalContext::kState) eigen.remember_state();
      eigen.start();
      std::size_t decision = 0;
      const auto compare = [&](const network::Vector& scores, Eigen::Index count) {
        ASSERT_LT(decision, expected[t].scores.size());
        const auto& wanted = expected[t].scores[decision++];
        ASSERT_EQ(static_cast<Eigen::Index>(wanted.size()), count);
        for (Eigen::Index i = 0; i < count; ++i) {
          largest = std::max(largest, std::abs(static_cast<double>(scores[i]) -
                                               static_cast<double>(wanted[static_cast<std::size_t>(i)])));
          ++compared;
        }
      };
      for (const Target& target : step.targets) {
        compare(eigen.token_scores(), network::kTokens);
        if (target.token == network::kStopToken) break;
        compare(eigen.main_scores(target.token), step.world.objects);
        if (target.second >= 0) compare(eigen.second_scores(target.token, target.main), step.world.objects);
        if (target.value >= 0)
          compare(eigen.value_scores(target.token, target.main), vocabulary->grammar.values().size());
        eigen.advance(target.token, target.main, target.second, target.value);
      }
      EXPECT_EQ(decision, expected[t].scores.size());
    }
  }
  EXPECT_GT(compared, 50);
  return largest;
}

TEST(NetworkEquality, WithAllParts) { EXPECT_LT(largest_difference({}), kTolerance); }

TEST(NetworkEquality, WithEachPartSwitchedOff) {
  for (const auto member :
       {&NetworkConfig::relations, &NetworkConfig::instance_grounding, &NetworkConfig::instruction_attention,
        &NetworkConfig::goal_object_attention, &NetworkConfig::positive, &NetworkConfig::negative}) {
    NetworkConfig config;
    config.*member = false;
    EXPECT_LT(largest_difference(config), kTolerance) << network::to_json(config);
  }
}

TEST(NetworkEquality, WithEveryTemporalContext) {
  for (const auto temporal : {TemporalContext::kNone, TemporalContext::kPositive, TemporalContext::kBoth,
                              TemporalContext::kState}) {
    NetworkConfig config;
    config.temporal = temporal;
    EXPECT_LT(largest_difference(config), kTolerance) << network::to_json(config);
  }
}

TEST(NetworkEquality, WithEverySentenceEncoding) {
  for (const auto encoding :
       {SentenceEncoding::kRecurrent, SentenceEncoding::kWordMean, SentenceEncoding::kExternal}) {
    NetworkConfig config;
    config.encoding = encoding;
    config.external = encoding == SentenceEncoding::kExternal ? 12 : 0;
    EXPECT_LT(largest_difference(config), kTolerance) << network::to_json(config);
  }
}

}  // namespace
}  // namespace goalnet::inference::training
