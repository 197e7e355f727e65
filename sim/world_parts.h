// What a World consists of, put together in the order in which things depend on each other. For world.cc
// only.
#pragma once

#include <memory>
#include <vector>

#include "sim/device_rules.h"
#include "sim/grasping.h"
#include "sim/movables.h"
#include "sim/moving_parts.h"
#include "sim/physics.h"
#include "sim/robot_links.h"
#include "sim/robot_servo.h"
#include "sim/world.h"

namespace goalnet::sim {

struct World::Parts {
  Parts(const scene::Scene& the_scene, const robot::RobotModel& the_robot, const WorldOptions& the_options,
        RobotLinks the_links);
  ~Parts();

  // Device rules over what is now, for `dt` [s].
  void run_rules(double dt);

  const scene::Scene scene;
  const robot::RobotModel robot_model;
  const WorldOptions options;
  RobotLinks links;
  Physics physics;
  MovingParts parts;
  Movables movables;
  ArticulatedBody robot;
  RobotServo servo;
  Grasping grasping;
  std::vector<std::unique_ptr<btMultiBodyJointLimitConstraint>> stops;
  DeviceRules rules;
  std::vector<std::size_t> fingers;  // joints, and links of the same index
  bool has_spots = false;            // some movable thing has buttons
  long steps = 0;
  long rules_every = 1;

 private:
  void add_stops();
  std::vector<Touch> finger_touches();
  bool is_finger(const btCollisionObject* object);
};

}  // namespace goalnet::sim
