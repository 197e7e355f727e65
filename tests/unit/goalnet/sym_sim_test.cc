#include "components/goalnet/sym_sim.h"

#include <gtest/gtest.h>

namespace goalnet::inference {
namespace {

class SymSim : public testing::Test {
 protected:
  SymState state(std::initializer_list<const char*> facts) {
    std::vector<Predicate> list;
    for (const char* fact : facts) list.push_back(*parse_predicate(fact));
    return to_sym_state(FactSet(list), symbols);
  }
  SymAction action(const char* text) { return *parse_action(text, symbols); }
  bool has(const SymState& s, const char* fact) {
    return to_fact_set(s, symbols).contains(*parse_predicate(fact));
  }
  std::vector<std::string> texts(const std::vector<SymAction>& run) {
    std::vector<std::string> list;
    for (const SymAction& a : run) list.push_back(to_string(a, symbols));
    return list;
  }
  Symbols symbols;
};

TEST_F(SymSim, GraspingTakesAwayWhatStoodOnIt) {
  SymState s =
      state({"(IsGraspable Plate_1)", "(Near Robot Plate_1)", "(On Egg_1 Plate_1)", "(On Plate_1 Sink)"});
  ASSERT_TRUE(applicable(action("grasp Plate_1"), s));
  apply(action("grasp Plate_1"), s);
  EXPECT_EQ(s, state({"(IsGraspable Plate_1)", "(Grasping Robot Plate_1)"}));
}

TEST_F(SymSim, FactsAboutThemselvesSurviveGrasping) {
  SymState s =
      state({"(IsGraspable GarbageBin_1)", "(Near Robot GarbageBin_1)", "(On GarbageBin_1 GarbageBin_1)"});
  apply(action("grasp GarbageBin_1"), s);
  EXPECT_TRUE(has(s, "(On GarbageBin_1 GarbageBin_1)"));
}

TEST_F(SymSim, TapFillsWhatStandsInTheSink) {
  SymState s = state({"(Near Robot Sink)", "(On Mug_1 Sink)"});
  apply(action("turn SinkKnob"), s);
  EXPECT_TRUE(has(s, "(state Mug_1 Water)"));
  apply(action("turn sinkknob"), s);
  EXPECT_FALSE(has(s, "(state SinkKnob TapIsOn)"));
  EXPECT_TRUE(has(s, "(state Mug_1 Water)"));
}

TEST_F(SymSim, BurnerObjectsAndFluentsAreDifferentThings) {
  SymState s = state({"(Near Robot Stove)", "(On Kettle StoveFire_2)", "(On Mug_1 StoveFire2)"});
  apply(action("turn stoveknob_2"), s);
  EXPECT_TRUE(has(s, "(state Stove StoveFire2)"));
  EXPECT_FALSE(has(s, "(state Kettle temperatureHigh)"));
  EXPECT_TRUE(has(s, "(state Mug_1 temperatureHigh)"));
}

TEST_F(SymSim, DoorsGuardPlaces) {
  EXPECT_FALSE(applicable(action("keep Mug_1 In Microwave"),
                          state({"(Grasping Robot Mug_1)", "(Near Robot Microwave)"})));
  SymState s = state({"(Near Robot Fridge)", "(state Fridge WaterDispenserIsOpen)"});
  apply(action("open FridgeLeftDoor"), s);
  EXPECT_FALSE(has(s, "(state Fridge WaterDispenserIsOpen)"));
  EXPECT_FALSE(applicable(action("open fridgeleftdoor"), s));
}

TEST_F(SymSim, ChannelsTurnRoundWhileTheSetIsOn) {
  SymState s = state({"(Near Robot Tv_1)", "(state Tv_1 IsOn)", "(state Tv_1 Channel1)"});
  apply(action("press Tv_1ChannelDownButton"), s);
  EXPECT_TRUE(has(s, "(state Tv_1 Channel6)"));
  EXPECT_FALSE(has(s, "(state Tv_1 Channel1)"));
}

TEST_F(SymSim, MeansComeInTheNaturalOrder) {
  const SymState s = state({"(IsGraspable Mug_1)"});
  EXPECT_EQ(texts(with_means(action("keep Mug_1 In Microwave"), s)),
            (std::vector<std::string>{"moveto Mug_1", "grasp Mug_1", "moveto Microwave", "open Microwave",
                                      "keep Mug_1 In Microwave"}));
  EXPECT_TRUE(with_means(action("grasp Sink"), s).empty()) << "what is not graspable has no run";
  EXPECT_TRUE(with_means(action("add Sink Mug_1"), s).empty());
}

TEST_F(SymSim, MalformedKeepsActAsRelease) {
  EXPECT_EQ(action("keep LongCup_1 Robot Fridge"), action("release LongCup_1"));
  EXPECT_FALSE(parse_action("fly Mug_1", symbols));
  EXPECT_FALSE(parse_action("grasp", symbols));
  EXPECT_FALSE(parse_action("", symbols));
}

TEST_F(SymSim, UnknownRelationsAreLeftOut) {
  EXPECT_EQ(state({"(Held Mug_1 LeftHand)", "(Grasping Robot Mug_1)"}), state({"(Grasping Robot Mug_1)"}));
}

}  // namespace
}  // namespace goalnet::inference
