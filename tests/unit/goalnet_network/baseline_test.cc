// The baseline of She et al.: frames, hypotheses over arguments, and that it learns what a verb means.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/goalnet/baseline/she_model.h"
#include "tests/unit/goalnet_network/example_episode.h"

namespace goalnet::inference::baseline {
namespace {

network::Lexicon lexicon() {
  return network::Lexicon(
      {"and", "drop", "fill", "kettle", "mug", "put", "sink"}, {"Kettle", "Mug", "Sink"},
      {{"mug", {{"Mug", 0.9F}}}, {"kettle", {{"Kettle", 0.9F}}}, {"sink", {{"Sink", 0.9F}}}});
}

TEST(VerbFrame, TheVerbIsTheFirstWordThatNamesNothing) {
  const Grounding grounding = {{"mug", {"Mug_1"}}, {"sink", {"Sink"}}};
  const VerbFrame frame = find_frame("and then put mug in sink", &grounding, lexicon(), example_state({}));
  EXPECT_EQ(frame.verb, "put");
  ASSERT_EQ(frame.candidates.size(), 2u);
  EXPECT_THAT(frame.candidates[0], ::testing::ElementsAre("Mug_1"));
}

TEST(VerbFrame, WithoutAGroundingWordsMeanWhatTheyHaveMeant) {
  const VerbFrame frame = find_frame("fill kettle", nullptr, lexicon(), example_state({}));
  EXPECT_EQ(frame.verb, "fill");
  ASSERT_EQ(frame.candidates.size(), 1u);
  EXPECT_THAT(frame.candidates[0], ::testing::ElementsAre("Kettle"));
  EXPECT_TRUE(find_frame("", nullptr, lexicon(), example_state({})).verb.empty());
}

TEST(Hypothesis, GeneralisesAndComesBack) {
  const VerbFrame frame{"put", {{"Mug_1"}, {"Sink"}}};
  const Goal goal{{fact("On Mug_1 Sink"), fact("state Mug_1 Water")}, {fact("Grasping Robot Mug_1")}, 1};
  const Hypothesis hypothesis = generalise(goal, frame);
  ASSERT_EQ(hypothesis.size(), 3u);
  Goal other;
  ASSERT_TRUE(instantiate(hypothesis, {"Kettle", "Sink"}, other));
  EXPECT_THAT(other.positive,
              ::testing::UnorderedElementsAre(fact("On Kettle Sink"), fact("state Kettle Water")));
  EXPECT_THAT(other.negative, ::testing::ElementsAre(fact("Grasping Robot Kettle")));
  EXPECT_FALSE(instantiate(hypothesis, {"Kettle"}, other));
}

TEST(SheModel, TransfersAVerbToAnotherObject) {
  std::vector<Demonstration> demonstrations;
  for (int i = 0; i < 8; ++i) {
    Demonstration d;
    d.scenario = std::to_string(i);
    d.sentence = "put mug in sink";
    d.grounding = {{"mug", {"Mug_1"}}, {"sink", {"Sink"}}};
    d.states = {example_state({}), example_state({"On Mug_1 Sink"})};
    demonstrations.push_back(d);
  }
  const auto parts = train_she(demonstrations, lexicon());
  const auto model = make_she_model(parts);
  const Grounding grounding = {{"kettle", {"Kettle"}}, {"sink", {"Sink"}}};
  const std::vector<WorldState> states = {example_state({})};
  const auto goal = model->infer({"put kettle in sink", &grounding, states, {}});
  ASSERT_TRUE(goal);
  EXPECT_THAT(goal->positive, ::testing::ElementsAre(fact("On Kettle Sink")));
  const std::vector<WorldState> two = {states[0], states[0]};
  const std::vector<Goal> before = {*goal};
  EXPECT_TRUE(model->infer({"put kettle in sink", &grounding, two, before})->empty());
  EXPECT_FALSE(make_she_model(train_she({}, lexicon()))->infer({"put", nullptr, states, {}}));
}

TEST(NetChange, LeavesOutMeansWhereThereAreEnds) {
  Demonstration d;
  d.states = {example_state({"Near Robot Sink"}),
              example_state({"Near Robot Kettle", "Grasping Robot Kettle"})};
  const Goal change = net_change(d);
  EXPECT_THAT(change.positive, ::testing::ElementsAre(fact("Grasping Robot Kettle")));
  EXPECT_TRUE(change.negative.empty());
}

}  // namespace
}  // namespace goalnet::inference::baseline
