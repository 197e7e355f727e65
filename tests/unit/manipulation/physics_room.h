// A room in simulated physics whose things a test puts where it needs them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "components/manipulation/testing/physics_harness.h"

namespace goalnet::manipulation {

class PhysicsRoom : public testing::Test {
 protected:
  // `rest`: [s] simulated after each action.
  PhysicsRoom(const std::string& room, double rest)
      : harness_(std::move(PhysicsHarness::create(room, "default", 1).value())), rest_(rest) {}

  std::size_t index(const std::string& name) const {
    const auto& objects = harness_->bench().scene().objects;
    const auto found =
        std::find_if(objects.begin(), objects.end(), [&](const auto& o) { return o.name == name; });
    return static_cast<std::size_t>(found - objects.begin());
  }
  Pose pose(const std::string& name) const { return harness_->world().object_pose(index(name)); }
  void put(const std::string& name, const Pose& pose) {
    harness_->world().set_object_pose(index(name), pose);
  }
  void expect_done(const Action& action) {
    const auto result = harness_->run(action, 120.0);
    EXPECT_EQ(result.result.outcome, Outcome::kDone) << to_string(action) << ": " << result.result.message;
    harness_->wait(rest_);
  }

  std::unique_ptr<PhysicsHarness> harness_;

 private:
  double rest_;
};

}  // namespace goalnet::manipulation
