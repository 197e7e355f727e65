// What lies where no hand gets around it is dragged to where one does.
#include <gtest/gtest.h>

#include "components/manipulation/drag.h"
#include "components/manipulation/phases.h"
#include "tests/unit/manipulation/physics_room.h"

namespace goalnet::manipulation {
namespace {

// `x`, `y`, `z` [m] in a fixture's frame, `yaw` [rad] as well.
Pose at(const Workbench& bench, const std::string& fixture, double x, double y, double z, double yaw) {
  return bench.scene().find_fixture(fixture)->pose * Eigen::Translation3d(x, y, z) *
         Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

class DragInKitchen : public PhysicsRoom {
 protected:
  DragInKitchen() : PhysicsRoom("kitchen", 0.3) {}
};

class DragInLivingRoom : public PhysicsRoom {
 protected:
  DragInLivingRoom() : PhysicsRoom("living_room", 0.3) {}
};

// Along the wall behind a worktop: no finger fits between spoon and wall.
TEST_F(DragInKitchen, ASpoonAlongAWallIsDraggedAwayFromIt) {
  put("Spoon_1", at(harness_->bench(), "Counter_1", 0.589, 0.95, 0.852, M_PI / 2));
  harness_->wait(0.5);
  for (const char* step : {"moveto", "grasp"}) expect_done({step, {"Spoon_1"}});
  EXPECT_TRUE(harness_->facts().contains({"Grasping", "Robot", "Spoon_1"}));
}

// A cushion that lies flat is wider than a hand opens, all but its thickness.
TEST_F(DragInLivingRoom, ALyingCushionIsDraggedOverTheEdgeAndTakenThere) {
  Pose lying = at(harness_->bench(), "Armchair_1", 0.25, 0.10, 0.505, 0.4);
  lying.linear() = lying.linear() * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  put("Pillow_2", lying);
  harness_->wait(0.5);
  for (const char* step : {"moveto", "grasp"}) expect_done({step, {"Pillow_2"}});
  EXPECT_TRUE(harness_->facts().contains({"Grasping", "Robot", "Pillow_2"}));
  // Held by its foot, it is put onto its other end.
  expect_done({"keep-on", {"Pillow_2", "Loveseat_1"}});
  EXPECT_TRUE(harness_->facts().contains({"On", "Pillow_2", "Loveseat_1"}));
  EXPECT_LT(pose("Pillow_2").linear()(2, 2), -0.95);
}

// Two walls and a board keep the hand from it.
TEST_F(DragInLivingRoom, ABookInALowCornerIsDraggedOut) {
  put("Book_1", at(harness_->bench(), "Shelf_2", 0.26, -0.27, 0.453, -2.3));
  harness_->wait(0.5);
  for (const char* step : {"moveto", "grasp"}) expect_done({step, {"Book_1"}});
  EXPECT_TRUE(harness_->facts().contains({"Grasping", "Robot", "Book_1"}));
}

// Nothing is dragged to where it would fall, and nothing that stands there with something in it.
TEST_F(DragInLivingRoom, WhatIsDraggedStaysUpAndKeepsWhatIsInIt) {
  Workbench& bench = harness_->bench();
  put("Book_1", at(bench, "CoffeeTable_1", 0.25, -0.30, 0.603, 0.0));
  bench.observe(harness_->view());
  for (const Reach& reach : drag_reaches(bench, "Book_1")) {
    const Eigen::Vector3d by = reach.tool.end()[-2].translation() - reach.tool.end()[-3].translation();
    const Eigen::Vector3d in =
        bench.scene().find_fixture("CoffeeTable_1")->pose.inverse() * (pose("Book_1").translation() + by);
    EXPECT_LT(std::abs(in.x() - 0.25), 0.24);
    EXPECT_LT(std::abs(in.y()), 0.44);
  }
  ASSERT_TRUE(harness_->facts().contains({"state", "Coke_1", "Coke"}));
  EXPECT_TRUE(drag_reaches(bench, "Coke_1").empty());
}

}  // namespace
}  // namespace goalnet::manipulation
