// The world model looking at the simulated kitchen: what physics settles into is what the facts say, and they
// stay.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.h"
#include "tests/unit/world_model/test_world.h"

namespace goalnet::world_model {
namespace {

using test::default_robot;
using test::kitchen;

class SimulatedKitchen {
 public:
  explicit SimulatedKitchen(std::uint64_t seed) : model_(kitchen(), default_robot()) {
    sim::WorldOptions options;
    options.seed = seed;
    world_ = test::value_or_throw(sim::World::create(kitchen(), default_robot(), options));
  }

  // 50 ms of physics, then a look.
  const FactSet& look() {
    const double until = world_->time() + 0.05;
    while (world_->time() < until) world_->step();
    const auto now = static_cast<std::int64_t>(std::llround(1e9 * world_->time()));
    ObservedJoints joints{now, {}, {}};
    for (std::size_t j = 0; j < world_->robot_joint_count(); ++j) {
      joints.names.push_back(default_robot().joints[j].name);
      joints.positions.push_back(world_->robot_joint(j).position);
    }
    for (std::size_t j = 0; j < world_->fixture_joint_count(); ++j) {
      joints.names.push_back(world_->fixture_joint_name(j));
      joints.positions.push_back(world_->fixture_joint(j).position);
    }
    ObservedPoses poses{now, {}};
    for (std::size_t i = 0; i < kitchen().objects.size(); ++i)
      poses.objects.push_back({kitchen().objects[i].name, world_->object_pose(i)});
    model_.observe(joints);
    model_.observe(poses);
    return model_.update().facts;
  }
  sim::World& world() { return *world_; }

 private:
  std::unique_ptr<sim::World> world_;
  WorldModel model_;
};

TEST(WorldModelOfTheSimulator, SettlesAndStays) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SimulatedKitchen kitchen_now(seed);
    for (int n = 0; n < 10; ++n) kitchen_now.look();
    const FactSet settled = kitchen_now.look();
    for (const scene::Object& object : kitchen().objects) {
      const scene::Region* region = kitchen().find_region(object.placement.on);
      const std::string relation = region->relation == scene::RegionRelation::kIn ? "In" : "On";
      EXPECT_TRUE(settled.contains({relation, object.name, region->name})) << object.name << " seed " << seed;
    }
    for (int n = 0; n < 30; ++n) {
      const FactSet& now = kitchen_now.look();
      EXPECT_TRUE(now == settled) << "seed " << seed << ": " << difference(now, settled).size() << " more, "
                                  << difference(settled, now).size() << " less";
    }
  }
}

TEST(WorldModelOfTheSimulator, SeesThingsDropAndLand) {
  SimulatedKitchen kitchen_now(1);
  for (int n = 0; n < 10; ++n) kitchen_now.look();
  const scene::Object* mug = kitchen().find_object("Mug_1");
  const scene::Region* sink = kitchen().find_region("Sink");
  scene::Pose above = kitchen().find_fixture("Sink")->pose * sink->supports[0].frame;
  above.translation().z() += 0.15;
  kitchen_now.world().set_object_pose(static_cast<std::size_t>(mug - kitchen().objects.data()), above);
  int changes = 0;
  bool was = false;
  for (int n = 0; n < 30; ++n) {
    const bool now = kitchen_now.look().contains({"On", "Mug_1", "Sink"});
    changes += now != was;
    was = now;
  }
  EXPECT_TRUE(was);
  EXPECT_EQ(changes, 1);
}

}  // namespace
}  // namespace goalnet::world_model
