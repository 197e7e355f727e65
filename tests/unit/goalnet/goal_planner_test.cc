#include "components/goalnet/goal_planner.h"

#include <gtest/gtest.h>

namespace goalnet::inference {
namespace {

class Planner : public testing::Test {
 protected:
  std::optional<std::vector<std::string>> plan(std::vector<const char*> facts,
                                               std::vector<const char*> positive,
                                               std::vector<const char*> negative = {}) {
    const auto parse = [](const std::vector<const char*>& texts) {
      std::vector<Predicate> list;
      for (const char* text : texts) list.push_back(*parse_predicate(text));
      return list;
    };
    const SymState state = to_sym_state(FactSet(parse(facts)), symbols);
    const SymGoal goal = to_sym_goal(Goal{parse(positive), parse(negative), 1}, symbols);
    const auto actions = GoalPlanner().plan(goal, state);
    if (!actions) return std::nullopt;
    std::vector<std::string> texts;
    for (const SymAction& action : *actions) texts.push_back(to_string(action, symbols));
    return texts;
  }
  using Texts = std::vector<std::string>;
  Symbols symbols;
};

TEST_F(Planner, NothingToDo) { EXPECT_EQ(plan({"(On Mug_1 Sink)"}, {"(On Mug_1 Sink)"}), Texts{}); }

TEST_F(Planner, OneAction) {
  EXPECT_EQ(
      plan({"(Grasping Robot Mug_1)", "(Near Robot Sink)"}, {"(On Mug_1 Sink)"}, {"(Grasping Robot Mug_1)"}),
      Texts{"keep Mug_1 On Sink"});
  EXPECT_EQ(plan({"(Grasping Robot Mug_1)"}, {}, {"(Grasping Robot Mug_1)"}), Texts{"release Mug_1"});
}

TEST_F(Planner, SeveralPredicates) {
  const auto run = plan({"(IsGraspable Mug_1)"}, {"(On Mug_1 Sink)", "(state SinkKnob TapIsOn)"});
  ASSERT_TRUE(run);
  EXPECT_EQ(run->size(), 5u);
}

TEST_F(Planner, SaysWhenThereIsNoPlan) {
  EXPECT_FALSE(plan({}, {"(Grasping Robot Sink)"}));
  EXPECT_FALSE(plan({"(IsGraspable Mug_1)"}, {"(Grasping Robot Mug_1)"}, {"(Grasping Robot Mug_1)"}));
}

}  // namespace
}  // namespace goalnet::inference
