// The world model looking at the simulated rooms: what physics settles into is what the facts say, and they
// stay.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.h"
#include "tests/unit/world_model/test_world.h"

namespace goalnet::world_model {
namespace {

using test::default_robot;
using test::kitchen;
using test::living_room;

class SimulatedRoom {
 public:
  SimulatedRoom(const scene::Scene& scene, std::uint64_t seed)
      : scene_(scene), model_(scene, default_robot()) {
    sim::WorldOptions options;
    options.seed = seed;
    world_ = test::value_or_throw(sim::World::create(scene_, default_robot(), options));
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
    for (std::size_t i = 0; i < scene_.objects.size(); ++i)
      poses.objects.push_back({scene_.objects[i].name, world_->object_pose(i)});
    model_.observe(joints);
    model_.observe(poses);
    return model_.update().facts;
  }
  sim::World& world() { return *world_; }

 private:
  const scene::Scene& scene_;
  std::unique_ptr<sim::World> world_;
  WorldModel model_;
};

TEST(WorldModelOfTheSimulator, SettlesAndStays) {
  for (const scene::Scene* scene : {&kitchen(), &living_room()})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const std::string where = scene->name + " seed " + std::to_string(seed);
      SimulatedRoom room(*scene, seed);
      for (int n = 0; n < 10; ++n) room.look();
      const FactSet settled = room.look();
      for (const scene::Object& object : scene->objects) {
        const scene::Region* region = scene->find_region(object.placement.on);
        if (region == nullptr) continue;  // stands on the floor
        const std::string relation = region->relation == scene::RegionRelation::kIn ? "In" : "On";
        EXPECT_TRUE(settled.contains({relation, object.name, region->name})) << object.name << ' ' << where;
      }
      for (int n = 0; n < 30; ++n) {
        const FactSet& now = room.look();
        for (const Predicate& fact : difference(now, settled))
          ADD_FAILURE() << where << ": came " << to_string(fact);
        for (const Predicate& fact : difference(settled, now))
          ADD_FAILURE() << where << ": went " << to_string(fact);
      }
    }
}

TEST(WorldModelOfTheSimulator, SeesThingsDropAndLand) {
  SimulatedRoom room(kitchen(), 1);
  for (int n = 0; n < 10; ++n) room.look();
  const scene::Object* mug = kitchen().find_object("Mug_1");
  const scene::Region* sink = kitchen().find_region("Sink");
  scene::Pose above = kitchen().find_fixture("Sink")->pose * sink->supports[0].frame;
  above.translation().z() += 0.15;
  room.world().set_object_pose(static_cast<std::size_t>(mug - kitchen().objects.data()), above);
  int changes = 0;
  bool was = false;
  for (int n = 0; n < 30; ++n) {
    const bool now = room.look().contains({"On", "Mug_1", "Sink"});
    changes += now != was;
    was = now;
  }
  EXPECT_TRUE(was);
  EXPECT_EQ(changes, 1);
}

}  // namespace
}  // namespace goalnet::world_model
