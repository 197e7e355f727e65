// The whole loop in simulation, goals given as predicates: planning, motion and physics without learning. One
// seed each here; tools/acceptance runs all of them over many.
#include <gmock/gmock-more-matchers.h>

#include "tests/closed_loop/run_json.h"

namespace goalnet {
namespace {

struct Case {
  const char* name;
  std::vector<std::string> goals;
  int seed;
  const char* room = "kitchen";
  std::vector<std::string> by = {};  // actions that the plan must have contained
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class ByGoal : public testing::TestWithParam<Case> {};

TEST_P(ByGoal, IsReachedInTheWorld) {
  std::vector<std::string> arguments = {"--scene", GetParam().room, "--seed",
                                        std::to_string(GetParam().seed)};
  for (const std::string& goal : GetParam().goals) arguments.insert(arguments.end(), {"--goal", goal});
  const RunResult result = run_json(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.json["message"];
  EXPECT_EQ(result.json["outcome"], "done");
  for (const std::string& goal : GetParam().goals) EXPECT_TRUE(result.holds(goal)) << goal;
  for (const std::string& action : GetParam().by) EXPECT_THAT(result.actions(), testing::Contains(action));
}

// Whoever runs two robots on one network puts each into a namespace; names may be changed as well.
TEST(Names, ARunInANamespaceReachesItsGoal) {
  const RunResult result = run_json({"--goal", "(state Microwave DoorIsOpen)", "--ros-args", "-r",
                                     "__ns:=/robot_1", "-r", "planner:__node:=brain"});
  EXPECT_EQ(result.exit_code, 0) << result.json["message"];
  EXPECT_TRUE(result.holds("(state Microwave DoorIsOpen)"));
}

INSTANTIATE_TEST_SUITE_P(
    Kitchen, ByGoal,
    testing::Values(
        Case{"mug_on_sink", {"(On Mug_1 Sink)"}, 1}, Case{"kettle_on_burner", {"(On Kettle StoveFire_1)"}, 2},
        Case{"tap_on", {"(state SinkKnob TapIsOn)"}, 3}, Case{"burner_2_on", {"(state Stove StoveFire2)"}, 4},
        Case{"microwave_open", {"(state Microwave DoorIsOpen)"}, 5},
        Case{"mug_in_microwave", {"(In Mug_1 Microwave)"}, 1},
        Case{"plates_in_sink", {"(On Plate_1 Sink)", "(On Plate_2 Sink)"}, 2},
        Case{"fridge_left_open", {"(state Fridge LeftDoorIsOpen)"}, 3},
        Case{"spoon_grasped", {"(Grasping Robot Spoon_1)"}, 4},
        Case{"coke_in_fridge", {"(In Coke_1 Fridge)"}, 5}, Case{"mug_with_water", {"(state Mug_1 Water)"}, 2},
        Case{"hot_kettle",
             {"(state Kettle Water)", "(On Kettle StoveFire_1)", "(state Stove StoveFire1)"},
             1}),
    [](const testing::TestParamInfo<Case>& one) { return std::string(one.param.name); });

// Every action of the household domain in physics; what one hand holds and the other works on included.
INSTANTIATE_TEST_SUITE_P(
    Contents, ByGoal,
    testing::Values(Case{"glass_and_mug_with_water", {"(state Glass_1 Water)", "(state Mug_1 Water)"}, 1},
                    Case{"disc_from_between_boards_onto_the_tray", {"(Held Cd_1 Tray)"}, 1, "living_room"},
                    Case{"kettle_carried_with_ramen_in_it",
                         {"(On Kettle Sink)", "(state Kettle Water)", "(state Kettle Ramen)"},
                         1},
                    Case{"tap_off_again",
                         {"(state Mug_1 Water)", "not (state SinkKnob TapIsOn)"},
                         2,
                         "kitchen",
                         {"turn-off SinkKnob"}},
                    Case{"coke_in_glass",
                         {"(state Glass_1 Coke)", "not (state Coke_1 Coke)"},
                         3,
                         "kitchen",
                         {"pour Coke_1 Glass_1"}},
                    Case{"dispenser",
                         {"(state Mug_1 Water)", "(state Fridge WaterDispenserIsOpen)"},
                         1,
                         "kitchen",
                         {"fill Mug_1 Fridge"}},
                    Case{"emptied", {"not (state Mug_1 Coffee)"}, 1, "kitchen", {"pour-out Mug_1"}},
                    Case{"salt", {"(state Bowl_1 Salt)"}, 2, "kitchen", {"add Salt_1 Bowl_1"}},
                    Case{"syrup", {"(state Plate_1 Chocolate)"}, 1, "kitchen", {"squeeze Syrup_2 Plate_1"}},
                    Case{"ice_cream",
                         {"(state Mug_1 IceCream)"},
                         3,
                         "kitchen",
                         {"scoop Spoon_1 IceCream_1", "add IceCreamScoop Mug_1"}},
                    Case{"ramen_in_kettle", {"(state Kettle Ramen)"}, 3, "kitchen", {"add Ramen_1 Kettle"}},
                    Case{"egg_on_plate", {"(state Plate_1 Egg)"}, 2, "kitchen", {"add BoiledEgg_1 Plate_1"}},
                    Case{"spoon_in_mug",
                         {"(state Mug_1 spoon)", "(In Spoon_1 Mug_1)"},
                         2,
                         "kitchen",
                         {"place-utensil Spoon_1 Mug_1"}},
                    Case{"fork_on_plate", {"(On Fork_1 Plate_1)"}, 1, "kitchen", {"keep-on Fork_1 Plate_1"}}),
    [](const testing::TestParamInfo<Case>& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(
    LivingRoom, ByGoal,
    testing::Values(
        Case{"chips_in_bin",
             {"(In BagOfChips_1 GarbageBin_1)"},
             1,
             "living_room",
             {"keep-in BagOfChips_1 GarbageBin_1"}},
        Case{"can_in_bag", {"(In Coke_1 GarbageBag_1)"}, 2, "living_room", {"keep-in Coke_1 GarbageBag_1"}},
        Case{"bag_in_bin", {"(In GarbageBag_1 GarbageBin_1)"}, 3, "living_room"},
        Case{"disc_in_xbox", {"(state Xbox_1 CD)"}, 1, "living_room"},
        Case{"bag_opened", {"(state BagOfChips_1 IsOpen)"}, 2, "living_room", {"open BagOfChips_1"}},
        Case{"remote",
             {"(Grasping Robot Tv_1Remote_1)", "(state Tv_1 IsOn)"},
             1,
             "living_room",
             {"press-on Tv_1Remote_1PowerButton"}},
        Case{"channel_4",
             {"(state Tv_1 IsOn)", "(state Tv_1 Channel4)"},
             1,
             "living_room",
             {"press Tv_1Remote_1ChannelUpButton"}}),
    [](const testing::TestParamInfo<Case>& one) { return std::string(one.param.name); });

// A grip from the sides is no press on a key.
TEST(RemoteControl, IsTakenWithoutPressingItsKeys) {
  const RunResult result =
      run_json({"--scene", "living_room", "tv on, channel 6, and then bring me the remote"});
  EXPECT_EQ(result.exit_code, 0) << result.json["message"];
  EXPECT_TRUE(result.holds("(Grasping Robot Tv_1Remote_1)"));
  EXPECT_TRUE(result.holds("(state Tv_1 Channel6)"));
}

// What is too large is known before anything moves.
TEST(TooLarge, IsRefusedBeforeAnythingMoves) {
  const RunResult result = run_json({"--scene", "living_room", "--goal", "(In Pillow_1 GarbageBin_1)"});
  EXPECT_EQ(result.exit_code, 12);
  EXPECT_THAT(result.json["message"].get<std::string>(),
              testing::HasSubstr("Pillow_1 does not fit into GarbageBin_1"));
  EXPECT_THAT(result.actions(), testing::IsEmpty());
}

}  // namespace
}  // namespace goalnet
