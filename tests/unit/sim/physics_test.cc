// The room at rest, the robot in motion, faults.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

TEST(Physics, NothingMovesByItself) {
  WorldOptions options;
  options.seed = 3;
  auto world = make_world(options);
  std::vector<scene::Pose> start;
  for (std::size_t i = 0; i < world->scene().objects.size(); ++i) start.push_back(world->object_pose(i));
  run(*world, 2.0);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const scene::Pose now = world->object_pose(i);
    EXPECT_LT((now.translation() - start[i].translation()).norm(), 0.0005) << world->scene().objects[i].name;
    EXPECT_GT((now.linear().transpose() * start[i].linear()).trace(), 2.9999)
        << world->scene().objects[i].name;
    EXPECT_TRUE(world->at_rest(i)) << world->scene().objects[i].name;
  }
  for (std::size_t i = 0; i < world->fixture_joint_count(); ++i) {
    EXPECT_NEAR(world->fixture_joint(i).position, 0.0, 1e-4) << world->fixture_joint_name(i);
  }
}

TEST(Physics, JointsTrackWhatTheyAreTold) {
  auto world = make_world();
  const double dt = world->options().physics_step;
  std::vector<double> start;
  for (std::size_t i = 0; i < world->robot_joint_count(); ++i)
    start.push_back(world->robot_joint(i).position);
  double worst = 0.0;
  for (int k = 1; k <= 1000; ++k) {
    const double t = k * dt;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto& limits = world->robot().joints[i].limits;
      const double range = std::isfinite(limits.lower) ? 0.3 * (limits.upper - limits.lower) : 1.0;
      const double size = std::min({0.25, range, 0.4 * limits.acceleration / 4.0}) / 2.0;
      const double sign = start[i] + 2 * size > limits.upper ? -1.0 : 1.0;
      world->command(i, start[i] + sign * size * (1 - std::cos(2 * t)), sign * size * 2 * std::sin(2 * t));
    }
    world->step();
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto& limits = world->robot().joints[i].limits;
      const double range = std::isfinite(limits.lower) ? 0.3 * (limits.upper - limits.lower) : 1.0;
      const double size = std::min({0.25, range, 0.4 * limits.acceleration / 4.0}) / 2.0;
      const double sign = start[i] + 2 * size > limits.upper ? -1.0 : 1.0;
      worst = std::max(
          worst, std::abs(world->robot_joint(i).position - start[i] - sign * size * (1 - std::cos(2 * t))));
    }
  }
  EXPECT_LT(worst, 1e-4);  // [rad, m]; the demand is below 1e-3
}

TEST(Physics, EffortStaysWithinItsLimitAgainstAWall) {
  auto world = make_world();
  const auto base_x = static_cast<std::size_t>(world->robot().index_of("base_x"));
  // Into the counter at walking speed; the command goes on to 0.3 m inside of it.
  for (int k = 0; k < 1500; ++k) {
    world->command(base_x, std::min(1.2, 0.8 * k * 0.002), k * 0.002 * 0.8 < 1.2 ? 0.8 : 0.0);
    world->step();
    EXPECT_LE(std::abs(world->robot_joint(base_x).effort),
              world->robot().joints[base_x].limits.effort + 1e-9);
  }
  EXPECT_LT(world->robot_joint(base_x).position, 0.93);  // front of the base at 0.25 m, counter at 1.17 m
  EXPECT_LT(std::abs(world->robot_joint(base_x).velocity), 0.05);
  bool touches = false;
  for (const auto& contact : world->contacts()) {
    touches |= contact.b == "Counter_1" && contact.a.starts_with("robot/");
    touches |= contact.a == "Counter_1" && contact.b.starts_with("robot/");
  }
  EXPECT_TRUE(touches);
}

TEST(Physics, BadCommandsAreIgnored) {
  auto world = make_world();
  const double before = world->robot_joint(3).position;
  world->command(3, std::nan(""), 0.0);
  world->command(3, before, INFINITY);
  run(*world, 0.1);
  EXPECT_NEAR(world->robot_joint(3).position, before, 1e-6);
}

TEST(Physics, CommandsBeyondTheLimitStopAtIt) {
  auto world = make_world();
  const auto lift = static_cast<std::size_t>(world->robot().index_of("lift"));
  world->command(lift, 5.0, 0.0);
  run(*world, 3.0);
  EXPECT_NEAR(world->robot_joint(lift).position, world->robot().joints[lift].limits.upper, 1e-3);
}

TEST(Physics, APushedThingSlidesAndFalls) {
  auto world = make_world();
  const std::size_t coke = object_index(*world, "Coke_1");
  const double height = world->object_pose(coke).translation().z();
  for (int k = 0; k < 300; ++k) {
    world->push_object(coke, {-2.5, 0, 0});  // over the front edge
    world->step();
  }
  run(*world, 2.0);
  EXPECT_LT(world->object_pose(coke).translation().z(), height - 0.5);
  EXPECT_GT(world->object_pose(coke).translation().z(), -0.01);  // lies on the floor, not below
}

TEST(Physics, StackedThingsStay) {
  auto world = make_world();
  const std::size_t plate = object_index(*world, "Plate_1"), bowl = object_index(*world, "Bowl_1"),
                    egg = object_index(*world, "BoiledEgg_1");
  scene::Pose on_plate = world->object_pose(plate);
  on_plate.translation().z() += 0.007;
  world->set_object_pose(bowl, on_plate);
  scene::Pose in_bowl = on_plate;
  in_bowl.translation().z() += 0.0085;
  world->set_object_pose(egg, in_bowl);
  run(*world, 3.0);
  EXPECT_LT((world->object_pose(bowl).translation() - on_plate.translation()).norm(), 0.003);
  EXPECT_LT((world->object_pose(egg).translation() - in_bowl.translation()).head<2>().norm(), 0.02);
  EXPECT_TRUE(holds(*world, "(state Bowl_1 Egg)"));
}

TEST(Physics, FrozenRobotJointDoesNotFollow) {
  auto world = make_world();
  const auto lift = static_cast<std::size_t>(world->robot().index_of("lift"));
  const double before = world->robot_joint(lift).position;
  world->freeze_joint("lift", true);
  world->command(lift, before - 0.1, 0.0);
  run(*world, 0.5);
  EXPECT_NEAR(world->robot_joint(lift).position, before, 1e-5);
  world->freeze_joint("lift", false);
  run(*world, 1.0);
  EXPECT_NEAR(world->robot_joint(lift).position, before - 0.1, 1e-4);
}

TEST(Physics, DrivingAboutMovesNothingElse) {
  auto world = make_world();
  const auto base_y = static_cast<std::size_t>(world->robot().index_of("base_y"));
  const auto yaw = static_cast<std::size_t>(world->robot().index_of("base_yaw"));
  std::vector<scene::Pose> start;
  for (std::size_t i = 0; i < world->scene().objects.size(); ++i) start.push_back(world->object_pose(i));
  for (int k = 0; k < 1500; ++k) {
    const double t = k * 0.002;
    world->command(base_y, 0.5 * (1 - std::cos(t)), 0.5 * std::sin(t));
    world->command(yaw, 0.6 * (1 - std::cos(t)), 0.6 * std::sin(t));
    world->step();
  }
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_LT((world->object_pose(i).translation() - start[i].translation()).norm(), 0.0005);
  }
}

TEST(Physics, RefusesAnImpossibleStep) {
  WorldOptions options;
  options.physics_step = 0.0;
  EXPECT_FALSE(World::create(test_scene(), test_robot(), options));
  options.physics_step = NAN;
  EXPECT_FALSE(World::create(test_scene(), test_robot(), options));
}

}  // namespace
}  // namespace goalnet::sim
