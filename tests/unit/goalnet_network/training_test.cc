// Training: the same seed gives the same bytes, also across an interruption; other seeds do not; it learns.
#include "components/goalnet/training/trainer.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/training/model_writer.h"
#include "components/goalnet/training/settings.h"
#include "components/goalnet/training/torch_network.h"
#include "tests/unit/goalnet_network/example_episode.h"

namespace goalnet::inference::training {
namespace {

std::vector<Demonstration> demonstrations() {
  std::vector<Demonstration> result;
  int number = 0;
  for (int copy = 0; copy < 4; ++copy) {
    for (const ExampleEpisode& e : example_episodes()) {
      Demonstration d;
      d.scenario = std::to_string(copy);
      d.id = d.scenario + "_" + std::to_string(number++);
      d.sentence = e.sentence;
      d.grounding = e.grounding;
      d.states = e.states;
      for (std::size_t t = 0; t + 1 < e.goals.size(); ++t) {
        d.steps.push_back(e.goals[t]);
        d.actions.push_back("moveto Sink");
      }
      result.push_back(d);
    }
  }
  return result;
}

Lexicon things() {
  Symbols symbols;
  return *Lexicon::load(std::string(GOALNET_SOURCE_DIR) + "/config/language/household.json", symbols);
}

TrainOptions options() {
  TrainOptions o;
  o.config.word = o.config.sentence = o.config.object = o.config.history = o.config.decoder = 8;
  o.epochs = 6;
  o.batch = 4;
  o.feeding_from = 2;
  o.compress = false;
  return o;
}

std::vector<std::byte> trained(const TrainOptions& o, std::vector<EpochReport>* curve = nullptr) {
  auto result = train_network(demonstrations(), {}, things(), {}, o, {});
  EXPECT_TRUE(result) << result.error().message;
  if (!result) return {};
  if (curve != nullptr) *curve = result->curve;
  return result->file.bytes();
}

TEST(Training, TheSameSeedGivesTheSameBytes) {
  TrainOptions other = options();
  other.seed = 2;
  const auto first = trained(options());
  EXPECT_EQ(first, trained(options()));
  EXPECT_NE(first, trained(other));
}

TEST(Training, AnInterruptedTrainingEndsWithTheSameBytes) {
  const std::string path =
      std::filesystem::temp_directory_path() / ("training_test_" + std::to_string(::getpid()));
  TrainOptions o = options();
  o.checkpoint = path;
  struct Interrupted {};
  try {
    static_cast<void>(train_network(demonstrations(), {}, things(), {}, o, [](const EpochReport& report) {
      if (report.epoch == 3) throw Interrupted();
    }));
    FAIL() << "the interruption did not come";
  } catch (const Interrupted&) {
  }
  ASSERT_TRUE(std::filesystem::exists(path));
  std::vector<EpochReport> curve;
  EXPECT_EQ(trained(o, &curve), trained(options()));
  EXPECT_EQ(curve.size(), 6u);
  o.learning_rate = 0.5;
  const auto refused = train_network(demonstrations(), {}, things(), {}, o, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("another training"));
  std::filesystem::remove(path);
}

TEST(Training, LearnsASmallSetByHeart) {
  TrainOptions o = options();
  o.config = {};
  o.epochs = 60;
  o.dropout = o.state_feeding = o.replacement = 0;
  o.learning_rate = 5e-3;
  std::vector<EpochReport> curve;
  trained(o, &curve);
  EXPECT_GT(curve.back().accuracy, 0.95);
  EXPECT_LT(curve.back().loss, 0.3 * curve.front().loss);
}

TEST(Training, SettingsByName) {
  TrainOptions o;
  EXPECT_TRUE(apply_settings(
      {{"relations", "false"}, {"temporal", "both"}, {"epochs", "3"}, {"simulator", "planner"}}, o));
  EXPECT_FALSE(o.config.relations);
  EXPECT_EQ(o.config.temporal, network::TemporalContext::kBoth);
  EXPECT_EQ(o.epochs, 3);
  EXPECT_TRUE(o.with_planner);
  for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{{"colour", "red"},
                                                                                    {"epochs", "many"},
                                                                                    {"dropout", "2"},
                                                                                    {"temporal", "maybe"},
                                                                                    {"object", "0"},
                                                                                    {"compress", "1"}}) {
    EXPECT_FALSE(apply_settings({{name, value}}, o)) << name;
  }
}

// tests/data/goalnet_network holds the scores that the default build, without libtorch, is held to. They are
// libtorch's; GOALNET_WRITE_REFERENCE=1 writes them anew after the network has changed.
TEST(Training, TheStoredReferenceIsLibtorchs) {
  torch::set_num_threads(1);
  std::vector<Episode> episodes;
  for (const ExampleEpisode& e : example_episodes())
    episodes.push_back({"1_1", "1", e.sentence, e.grounding, e.states, e.goals, e.goals});
  network::NetworkConfig config;
  config.word = config.sentence = config.object = config.history = config.decoder = 8;
  const auto vocabulary = make_vocabulary(episodes, {}, config.word, "");
  ASSERT_TRUE(vocabulary);
  TorchNetwork network(config, *vocabulary, 5);
  const std::string folder = std::string(GOALNET_SOURCE_DIR) + "/tests/data/goalnet_network/";
  const auto file = make_model_file(config, *vocabulary, network.tensors(), {});
  EpisodeEncoder encoder(config, *vocabulary);
  nlohmann::json scores = nlohmann::json::array();
  for (const Episode& episode : episodes) {
    for (const DecisionScores& step : network.scores(*encoder.encode(episode, true), encoder.names()))
      scores.push_back(step.scores[0]);
  }
  if (std::getenv("GOALNET_WRITE_REFERENCE") != nullptr) {
    ASSERT_TRUE(file->write(folder + "small.safetensors"));
    std::ofstream(folder + "small_expected.json") << scores.dump(1) << "\n";
  }
  std::ifstream stream(folder + "small_expected.json");
  const auto stored = nlohmann::json::parse(stream);
  ASSERT_EQ(stored.size(), scores.size());
  for (std::size_t step = 0; step < scores.size(); ++step) {
    for (std::size_t i = 0; i < scores[step].size(); ++i) {
      EXPECT_NEAR(stored[step][i].get<double>(), scores[step][i].get<double>(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace goalnet::inference::training
