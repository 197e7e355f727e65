// The shipped network model: deterministic, refuses what it cannot read, allocates nothing once warm, and
// gives the scores that were stored when it was made.
#include "components/goalnet/network/network_model.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "components/goalnet/network/network_core.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet_network/example_episode.h"
#include "tests/unit/goalnet_network/heap_count.h"

namespace goalnet::inference {
namespace {

using ::testing::HasSubstr;

const std::string kModel = std::string(GOALNET_SOURCE_DIR) + "/tests/data/goalnet_network/small.safetensors";
const std::string kExpected =
    std::string(GOALNET_SOURCE_DIR) + "/tests/data/goalnet_network/small_expected.json";
const std::string kShipped = std::string(GOALNET_SOURCE_DIR) + "/config/models/goalnet_network.safetensors";

StepInput input_of(const ExampleEpisode& episode, std::size_t step, bool grounded) {
  return {episode.sentence, grounded ? &episode.grounding : nullptr,
          std::span(episode.states).first(step + 1), std::span(episode.goals).first(step)};
}

TEST(NetworkModel, GivesTheScoresThatLibtorchGave) {
  const auto file = SafeTensors::load(kModel);
  ASSERT_TRUE(file) << file.error().message;
  auto parts = network::load_parts(*file);
  ASSERT_TRUE(parts) << parts.error().message;
  std::ifstream stream(kExpected);
  const auto expected = nlohmann::json::parse(stream);
  network::NameTable names((*parts)->lexicon, (*parts)->weights.vectors);
  network::WorldEncoder worlds((*parts)->config, (*parts)->lexicon, (*parts)->grammar,
                               (*parts)->weights.vectors, names);
  network::Network eigen((*parts)->config, (*parts)->weights, names);
  std::size_t next = 0;
  for (const ExampleEpisode& episode : example_episodes()) {
    const auto texts = tokenize(episode.sentence);
    network::EncodedSentence sentence;
    for (const std::string& text : *texts) sentence.words.push_back((*parts)->lexicon.word(text));
    eigen.read_sentence(sentence.words);
    for (std::size_t t = 0; t < episode.states.size(); ++t) {
      network::EncodedWorld world;
      ASSERT_TRUE(worlds.encode(sentence, *texts, &episode.grounding, episode.states[t],
                                std::span(episode.goals).first(t), world));
      eigen.read_world(world);
      eigen.start();
      const auto wanted = expected.at(next++).get<std::vector<float>>();
      const network::Vector& scores = eigen.token_scores();
      ASSERT_EQ(wanted.size(), static_cast<std::size_t>(scores.size()));
      for (std::size_t i = 0; i < wanted.size(); ++i)
        EXPECT_NEAR(scores[static_cast<Eigen::Index>(i)], wanted[i], 1e-5);
    }
  }
  EXPECT_EQ(next, expected.size());
}

TEST(NetworkModel, TheSameInputGivesTheSameGoalInEveryOrder) {
  const auto file = SafeTensors::load(kShipped);
  ASSERT_TRUE(file) << file.error().message;
  const auto one = make_network_model(*file), other = make_network_model(*file);
  ASSERT_TRUE(one) << one.error().message;
  const auto episodes = example_episodes();
  std::vector<Goal> forward;
  for (const auto& episode : episodes) {
    for (std::size_t t = 0; t < episode.states.size(); ++t) {
      const auto goal = (*one)->infer(input_of(episode, t, t % 2 == 0));
      ASSERT_TRUE(goal) << goal.error().message;
      EXPECT_GE(goal->confidence, 0);
      EXPECT_LE(goal->confidence, 1);
      forward.push_back(*goal);
    }
  }
  std::size_t next = forward.size();
  for (std::size_t e = episodes.size(); e-- > 0;) {
    for (std::size_t t = episodes[e].states.size(); t-- > 0;) {
      const auto goal = (*other)->infer(input_of(episodes[e], t, t % 2 == 0));
      ASSERT_TRUE(goal);
      --next;
      EXPECT_EQ(goal->positive, forward[next].positive);
      EXPECT_EQ(goal->negative, forward[next].negative);
      EXPECT_EQ(goal->confidence, forward[next].confidence);
    }
  }
}

TEST(NetworkModel, PredictsOnlyWellFormedGoalsThatAreNotTrueYet) {
  const auto model = make_network_model(*SafeTensors::load(kShipped));
  ASSERT_TRUE(model);
  for (const auto& episode : example_episodes()) {
    for (std::size_t t = 0; t < episode.states.size(); ++t) {
      const auto goal = (*model)->infer(input_of(episode, t, true));
      ASSERT_TRUE(goal);
      for (const Predicate& fact : goal->positive)
        EXPECT_FALSE(episode.states[t].facts.contains(fact)) << to_string(fact);
      for (const Predicate& fact : goal->negative)
        EXPECT_TRUE(episode.states[t].facts.contains(fact)) << to_string(fact);
    }
  }
}

TEST(NetworkModel, OddWorlds) {
  const auto model = make_network_model(*SafeTensors::load(kShipped));
  ASSERT_TRUE(model);
  const auto infer = [&](const WorldState& state) {
    const std::vector<WorldState> states = {state};
    return (*model)->infer({"fill mug with water", nullptr, states, {}});
  };
  EXPECT_TRUE(infer({})->empty());  // nothing there, nothing to do
  WorldState unknown =
      example_state({"On Gadget_7 Thing_2", "state Gadget_7 Purple", "IsGraspable Gadget_7"});
  unknown.objects = {"Gadget_7", "Thing_2", "Robot", "Gadget_7"};
  EXPECT_TRUE(infer(unknown));
  WorldState contradictory = example_state(
      {"On Mug_1 Sink", "On Mug_1 Plate_1", "In Mug_1 Fridge", "On Sink Mug_1", "On Mug_1 Mug_1"});
  EXPECT_TRUE(infer(contradictory));
  WorldState crowd;
  for (int i = 0; i < 1000; ++i) crowd.objects.push_back("Mug_" + std::to_string(i));
  EXPECT_TRUE(infer(crowd));
  for (int i = 0; i < 5000; ++i) crowd.objects.push_back("Cup_" + std::to_string(i));
  const auto refused = infer(crowd);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().outcome, Outcome::kInvalidRequest);
}

TEST(NetworkModel, SentencesWithoutAKnownWordAreNotUnderstood) {
  const auto model = make_network_model(*SafeTensors::load(kShipped));
  ASSERT_TRUE(model);
  const std::vector<WorldState> states = {example_state({})};
  for (const char* sentence : {"", "   ", "xyzzy plugh", "ketle"}) {
    const auto goal = (*model)->infer({sentence, nullptr, states, {}});
    ASSERT_FALSE(goal) << sentence;
    EXPECT_EQ(goal.error().outcome, Outcome::kNotUnderstood);
  }
  EXPECT_THAT((*model)->infer({"ketle", nullptr, states, {}}).error().message, HasSubstr("\"kettle\""));
}

TEST(NetworkModel, BrokenModelsAreRefusedWithOneMessage) {
  const auto whole = SafeTensors::load(kModel);
  ASSERT_TRUE(whole);
  const auto with = [&](const std::string& key, const std::string& value,
                        const std::string& without_tensor = "") {
    SafeTensorsWriter writer;
    for (const auto& [name, entry] : whole->tensors()) {
      if (name == without_tensor) continue;
      EXPECT_TRUE(writer.add(name, entry.shape, whole->floats(name, entry.shape)->values));
    }
    for (const auto& [name, text] : whole->metadata()) writer.metadata(name, text);
    if (!key.empty()) writer.metadata(key, value);
    const auto model = make_network_model(*SafeTensors::parse(writer.bytes(), "broken.safetensors"));
    return model ? "accepted" : model.error().message;
  };
  EXPECT_EQ(with("", ""), "accepted");
  EXPECT_THAT(with("", "", "decoder.token"), HasSubstr("\"decoder.token\" is missing"));
  EXPECT_THAT(with("goalnet.network", "{}{"), HasSubstr("no JSON object"));
  EXPECT_THAT(with("goalnet.network", R"({"object": 0})"), HasSubstr("no usable size \"object\""));
  EXPECT_THAT(with("goalnet.network", R"({"object": 16})"), HasSubstr("shape"));
  EXPECT_THAT(with("goalnet.network", R"({"colour": 1})"), HasSubstr("unknown key"));
  EXPECT_THAT(with("goalnet.network", R"({"temporal": "maybe"})"), HasSubstr("unknown temporal"));
  EXPECT_THAT(with("goalnet.lexicon", R"({"words": 1})"), HasSubstr("lexicon"));
  EXPECT_THAT(
      with("goalnet.grammar", R"({"values": ["Water"], "main": {"Flying": []}, "second": {}, "value": {}})"),
      HasSubstr("grammar"));
  EXPECT_THAT(with("goalnet.calibration", "[1]"), HasSubstr("calibration"));
  for (const char* key : {"goalnet.network", "goalnet.lexicon", "goalnet.grammar"}) {
    EXPECT_THAT(with(key, "null"), HasSubstr("broken.safetensors"));
  }
}

TEST(NetworkModel, AStepAllocatesNothingOnceWarm) {
  if (!test::counts_heap_calls()) GTEST_SKIP() << "a sanitizer brings its own malloc";
  network::NetworkCore core(std::move(*network::load_parts(*SafeTensors::load(kShipped))));
  const auto episodes = example_episodes();
  const auto all = [&] {
    for (const auto& episode : episodes) {
      for (std::size_t t = 0; t < episode.states.size(); ++t) {
        core.encode_sentence();
        ASSERT_TRUE(core.step(input_of(episode, t, true)));
      }
    }
  };
  core.set_words(*tokenize(episodes[0].sentence));
  all();
  all();
  const auto before = test::heap_calls();
  all();
  EXPECT_EQ(test::heap_calls() - before, 0u);
}

}  // namespace
}  // namespace goalnet::inference
