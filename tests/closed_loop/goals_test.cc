// The whole loop in simulation, goals given as predicates: planning, motion and physics without learning. One
// seed each here; tools/acceptance runs all of them over many.
#include <gmock/gmock.h>

#include "tests/closed_loop/run_json.h"

namespace goalnet {
namespace {

struct Case {
  const char* name;
  std::vector<std::string> goals;
  int seed;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class ByGoal : public testing::TestWithParam<Case> {};

TEST_P(ByGoal, IsReachedInTheWorld) {
  std::vector<std::string> arguments = {"--seed", std::to_string(GetParam().seed)};
  for (const std::string& goal : GetParam().goals) arguments.insert(arguments.end(), {"--goal", goal});
  const RunResult result = run_json(arguments, 84);
  EXPECT_EQ(result.exit_code, 0) << result.json["message"];
  EXPECT_EQ(result.json["outcome"], "done");
  for (const std::string& goal : GetParam().goals) EXPECT_TRUE(result.holds(goal)) << goal;
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

}  // namespace
}  // namespace goalnet
