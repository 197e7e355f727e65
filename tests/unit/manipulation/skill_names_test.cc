#include <gtest/gtest.h>

#include "components/manipulation/action_runner.h"
#include "components/manipulation/skill.h"

namespace goalnet::manipulation {
namespace {

class SkillNames : public testing::Test {
 protected:
  std::unique_ptr<Workbench> bench_ =
      Workbench::create(robot::load_robot("default").value(), scene::load_scene("kitchen").value(), {})
          .value();

  Outcome outcome(const Action& action) {
    const auto skill = make_skill(*bench_, action);
    return skill ? Outcome::kDone : skill.error().outcome;
  }
};

TEST_F(SkillNames, RefusesWhatMakesNoSense) {
  EXPECT_EQ(outcome({"fly", {"Mug_1"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"", {}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"grasp", {}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"grasp", {"Mug_1", "Sink"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"grasp", {"Unicorn_1"}}), Outcome::kUnknownObject);
  EXPECT_EQ(outcome({"grasp", {"Fridge"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"turn-on", {"Mug_1"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"open", {"SinkKnob"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"press-on", {"FridgeLeftDoor"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"keep-on", {"Mug_1", "SinkKnob"}}), Outcome::kInvalidRequest);
  EXPECT_EQ(outcome({"keep-in", {"Mug_1", "Microwave"}}), Outcome::kDone);
  EXPECT_EQ(outcome({"open", {"Microwave"}}), Outcome::kDone);
}

TEST_F(SkillNames, ImpossibleActionsFailWithAMessage) {
  WorldView view;
  view.robot = bench_->model().home();
  ActionRunner runner(*bench_);
  ASSERT_TRUE(runner.start({"keep-on", {"Mug_1", "Sink"}}));
  EXPECT_EQ(runner.start({"moveto", {"Sink"}}).error().outcome, Outcome::kBusy);
  runner.update(view, {});
  ASSERT_TRUE(runner.finished());
  EXPECT_EQ(runner.result().outcome, Outcome::kMotionFailed);
  EXPECT_NE(runner.result().message.find("not in a hand"), std::string::npos);
  // An object that cannot be seen cannot be grasped.
  ASSERT_TRUE(runner.start({"grasp", {"Mug_1"}}));
  runner.update(view, {});
  ASSERT_TRUE(runner.finished());
  EXPECT_EQ(runner.result().outcome, Outcome::kMotionFailed);
}

TEST_F(SkillNames, ACancelBeforePlanningEndsTheAction) {
  WorldView view;
  view.robot = bench_->model().home();
  ActionRunner runner(*bench_);
  ASSERT_TRUE(runner.start({"moveto", {"Sink"}}));
  runner.cancel();
  runner.update(view, {});
  ASSERT_TRUE(runner.finished());
  EXPECT_EQ(runner.result().outcome, Outcome::kCancelled);
}

TEST_F(SkillNames, AStopFlagEndsPlanning) {
  WorldView view;
  view.robot = bench_->model().home();
  bench_->set_stop_check([] { return true; });
  ActionRunner runner(*bench_);
  ASSERT_TRUE(runner.start({"moveto", {"Sink"}}));
  runner.update(view, {});
  ASSERT_TRUE(runner.finished());
  EXPECT_EQ(runner.result().outcome, Outcome::kCancelled);
}

}  // namespace
}  // namespace goalnet::manipulation
