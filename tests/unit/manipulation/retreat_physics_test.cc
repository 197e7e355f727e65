// Out from between boards again, and what is tried the second time.
#include <gtest/gtest.h>

#include "components/manipulation/phases.h"
#include "components/manipulation/skills.h"
#include "tests/unit/manipulation/physics_room.h"

namespace goalnet::manipulation {
namespace {

class Shelf : public PhysicsRoom {
 protected:
  Shelf() : PhysicsRoom("living_room", 0.3) {}
  void put(const std::string& name, const Eigen::Vector3d& at, double yaw) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() = at;
    PhysicsRoom::put(name, pose);
  }
};

// Deep between two boards, a cushion at each side: it comes out, and the arm with it folds.
TEST_F(Shelf, AThingFromBetweenBoardsIsCarriedAway) {
  put("Book_3", {2.82, 1.75, 0.853}, 0.0);
  put("Pillow_2", {2.78, 1.93, 0.853}, M_PI / 2);
  put("Pillow_3", {2.78, 1.57, 0.853}, M_PI / 2);
  harness_->wait(1.0);
  for (const char* step : {"moveto", "grasp"}) expect_done({step, {"Book_3"}});
  expect_done({"moveto", {"CoffeeTable_1"}});
  expect_done({"keep-on", {"Book_3", "CoffeeTable_1"}});
  EXPECT_TRUE(harness_->facts().contains({"On", "Book_3", "CoffeeTable_1"}));
}

TEST_F(Shelf, TheBaseSlidesStraightOnlyWhereItIsFree) {
  Workbench& bench = harness_->bench();
  bench.observe(harness_->view());
  EXPECT_TRUE(bench.can_slide(bench.now(), M_PI, 0.3));
  const auto motion = bench.slide(M_PI, 0.3);
  ASSERT_TRUE(motion) << motion.error().message;
  EXPECT_FALSE(motion->points.empty());
  EXPECT_FALSE(bench.can_slide(bench.now(), 0.0, 9.0)) << "beyond the floor";
  EXPECT_FALSE(bench.slide(0.0, 9.0));
}

// The grasp that failed is not the first choice again in the same instruction; in the next one it is.
TEST_F(Shelf, AFailedGraspIsTriedInAnotherWay) {
  Workbench& bench = harness_->bench();
  bench.observe(harness_->view());
  const std::string what = "grasp Coke_1";
  const auto choice = [&](bool done) {
    bench.tried().begin_action(what);
    Phases phases;
    const auto reach =
        add_way_there(phases, bench, grasp_reaches(bench, "Coke_1"), StandSearchOptions(), what, "Coke_1");
    EXPECT_TRUE(reach) << reach.error().message;
    bench.tried().end_action(done);
    return std::pair(reach->arm, reach->tool[1]);
  };
  const auto first = choice(false), second = choice(true);
  bench.tried().begin_instruction();
  const auto anew = choice(true);
  const auto same = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.matrix().isApprox(b.second.matrix(), 1e-9);
  };
  EXPECT_FALSE(same(first, second));
  EXPECT_TRUE(same(first, anew));
}

}  // namespace
}  // namespace goalnet::manipulation
