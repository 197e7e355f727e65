// The shipped model in worlds that nobody recorded: an answer or one message, in bounded time.
#include <gtest/gtest.h>

#include <chrono>
#include <map>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

class OddWorlds : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto loaded = load_model(GOALNET_SOURCE_DIR "/config/models/goalnet.safetensors");
    ASSERT_TRUE(loaded) << loaded.error().message;
    model = std::move(*loaded);
  }
  static void TearDownTestSuite() { model.reset(); }
  static WorldState world(std::vector<std::string> objects, std::initializer_list<const char*> facts) {
    std::vector<Predicate> list;
    for (const char* fact : facts) list.push_back(*parse_predicate(fact));
    return {std::move(objects), FactSet(list)};
  }
  static Expected<Goal> ask(std::string_view sentence, const WorldState& state) {
    const std::vector<WorldState> states = {state};
    return model->infer({.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
  }
  inline static std::unique_ptr<GoalModel> model;
};

TEST_F(OddWorlds, NoStateIsRefused) {
  EXPECT_EQ(model->infer({.sentence = "grab the mug", .grounding = nullptr, .states = {}, .goals = {}})
                .error()
                .outcome,
            Outcome::kInvalidRequest);
}

TEST_F(OddWorlds, NoObjects) { EXPECT_EQ(ask("grab the mug", {}).error().outcome, Outcome::kUnknownObject); }

TEST_F(OddWorlds, EmptyInstruction) {
  for (const char* text : {"", "   ", ".", "!!!"})
    EXPECT_EQ(ask(text, world({"Mug_1"}, {"(IsGraspable Mug_1)"})).error().outcome, Outcome::kNotUnderstood);
}

TEST_F(OddWorlds, TextThatIsNoText) {
  const auto state = world({"Mug_1"}, {"(IsGraspable Mug_1)"});
  EXPECT_EQ(ask(std::string(100000, 'x'), state).error().outcome, Outcome::kInvalidRequest);
  EXPECT_EQ(ask("grab the mug \xff", state).error().outcome, Outcome::kInvalidRequest);
  EXPECT_EQ(ask("возьми кружку", state).error().outcome, Outcome::kNotUnderstood);
}

TEST_F(OddWorlds, ControlCharactersAreRefused) {
  EXPECT_EQ(ask(std::string("grab\0the mug", 12), world({"Mug_1"}, {"(IsGraspable Mug_1)"})).error().outcome,
            Outcome::kInvalidRequest);
}

TEST_F(OddWorlds, AsMuchGarbageAsIsReadTakesBoundedTime) {
  std::string text;  // 250 words that are nearly known
  for (int i = 0; i < 250; ++i)
    text += "putx" + std::string(1, static_cast<char>('a' + i % 26)) + "thesinkk ";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(ask(text, world({"Mug_1", "Sink"}, {"(IsGraspable Mug_1)"})));
  text.clear();
  for (int i = 0; i < 80; ++i) text += "and the mug ";
  (void)ask("put " + text + "in the sink", world({"Mug_1", "Sink"}, {"(IsGraspable Mug_1)"}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(OddWorlds, PicturesInTheTextDoNotMatter) {
  const auto goal = ask("grab the mug \U0001F642!", world({"Robot", "Mug_1"}, {"(IsGraspable Mug_1)"}));
  ASSERT_TRUE(goal) << goal.error().message;
}

// Of two equal things the nearest is taken; without distances the first by name.
TEST_F(OddWorlds, TheNearestOfEqualThings) {
  const std::vector<WorldState> states = {
      world({"Robot", "Plate_1", "Plate_2"}, {"(IsGraspable Plate_1)", "(IsGraspable Plate_2)"})};
  const std::map<std::string, double> distances = {{"Plate_1", 2.0}, {"Plate_2", 0.5}};
  const auto taken = [&](const char* sentence, const std::map<std::string, double>* far) {
    const auto goal = model->infer(
        {.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}, .distances = far});
    return goal ? goal->positive.front().object : goal.error().message;
  };
  EXPECT_EQ(taken("grab a plate", nullptr), "Plate_1");
  EXPECT_EQ(taken("grab a plate", &distances), "Plate_2");
  EXPECT_EQ(taken("grab the farthest plate", &distances), "Plate_1");
  EXPECT_EQ(taken("grab plate 1", &distances), "Plate_1");
}

TEST_F(OddWorlds, RefusalsNameTheNearestThingKnown) {
  const auto state = world({"Robot", "Mug_1", "Sink"}, {"(IsGraspable Mug_1)"});
  const std::string unknown = ask("bring me the spoonzzz", state).error().message;
  EXPECT_NE(unknown.find("spoonzzz"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("\"spoon\""), std::string::npos) << unknown;
  EXPECT_NE(ask("bring me the bowl", state).error().message.find("Mug_1"), std::string::npos);
  EXPECT_NE(ask("pick up the sink", state).error().message.find("cannot be picked up"), std::string::npos);
}

TEST_F(OddWorlds, UnknownClassesCanBeNamed) {
  const auto goal = ask("grab the vase", world({"Robot", "Vase_2"}, {"(IsGraspable Vase_2)"}));
  ASSERT_TRUE(goal) << goal.error().message;
  EXPECT_EQ(goal->positive, (std::vector<Predicate>{{"Grasping", "Robot", "Vase_2"}}));
}

TEST_F(OddWorlds, ContradictoryFactsStillHaveAnAnswer) {
  const auto goal = ask("put the mug in the sink",
                        world({"Robot", "Mug_1", "Sink", "Counter_1"},
                              {"(IsGraspable Mug_1)", "(Grasping Robot Mug_1)", "(On Mug_1 Counter_1)",
                               "(On Mug_1 Mug_1)", "(In Mug_1 Microwave)", "(Near Mug_1 Mug_1)"}));
  ASSERT_TRUE(goal) << goal.error().message;
  EXPECT_EQ(goal->positive, (std::vector<Predicate>{{"On", "Mug_1", "Sink"}}));
}

TEST_F(OddWorlds, FactsFromElsewhereAreIgnored) {
  const auto goal = ask(
      "grab the mug",
      world({"Robot", "Mug_1"}, {"(IsGraspable Mug_1)", "(Held Spoon_1 LeftHand)", "(Colour Mug_1 Red)"}));
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->positive.front().object, "Mug_1");
}

TEST_F(OddWorlds, AThousandObjects) {
  WorldState state;
  std::vector<Predicate> facts;
  for (int i = 0; i < 1000; ++i) {
    state.objects.push_back("Box_" + std::to_string(i));
    facts.push_back({"IsGraspable", state.objects.back(), ""});
  }
  state.objects.insert(state.objects.end(), {"Robot", "Mug_1", "Sink"});
  facts.push_back({"IsGraspable", "Mug_1", ""});
  state.facts = FactSet(facts);
  const auto begin = std::chrono::steady_clock::now();
  const auto goal = ask("put the mug in the sink", state);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  ASSERT_TRUE(goal) << goal.error().message;
  EXPECT_EQ(goal->positive, (std::vector<Predicate>{{"On", "Mug_1", "Sink"}}));
}

}  // namespace
}  // namespace goalnet::inference
