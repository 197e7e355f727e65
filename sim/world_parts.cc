#include "sim/world_parts.h"

#include <algorithm>
#include <cmath>

#include "sim/bullet_convert.h"

namespace goalnet::sim {
namespace {

constexpr double kRulePeriod = 0.01;  // [s] device rules are slow next to the physics

// A floor wide enough that nothing that falls or rolls gets off it; top at z = 0.
std::vector<scene::Shape> floor_of(const scene::Scene& scene) {
  scene::Shape floor;
  floor.size = {scene.floor_x_max - scene.floor_x_min + 4.0, scene.floor_y_max - scene.floor_y_min + 4.0,
                0.2};
  floor.pose.translation() = Eigen::Vector3d((scene.floor_x_min + scene.floor_x_max) / 2.0,
                                             (scene.floor_y_min + scene.floor_y_max) / 2.0, -0.1);
  floor.color = {0.62, 0.55, 0.47};
  return {floor};
}

}  // namespace

World::Parts::Parts(const scene::Scene& the_scene, const robot::RobotModel& the_robot,
                    const WorldOptions& the_options, RobotLinks the_links)
    : scene(the_scene),
      robot_model(the_robot),
      options(the_options),
      links(std::move(the_links)),
      physics(options),
      parts(physics, scene),
      movables(physics, scene, scene::initial_poses(scene, options.seed)),
      robot(scene::Pose::Identity(), links.links),
      servo(robot, robot_model, options),
      grasping(physics, robot, links, robot_model, servo, movables, options),
      rules(scene) {
  physics.add_static("floor", scene::Pose::Identity(), floor_of(scene), 0.8);
  for (const auto& fixture : scene.fixtures)
    physics.add_static(fixture.name, fixture.pose, fixture.shapes, fixture.friction);
  std::vector<std::string> names(links.links.size());
  for (const auto& [name, place] : links.merged) {
    if (place.link >= 0 && place.pose.isApprox(scene::Pose::Identity(), 0.0)) {
      names[static_cast<std::size_t>(place.link)] = "robot/" + name;
    }
  }
  physics.add_articulated(robot, names, kRobotGroup, kStaticGroup | kObjectGroup | kPartGroup);
  add_stops();
  for (const auto& arm : robot_model.arms) {
    for (const auto& finger : arm.gripper.fingers)
      fingers.push_back(static_cast<std::size_t>(robot_model.index_of(finger)));
  }
  has_spots = std::any_of(scene.rules.buttons.begin(), scene.rules.buttons.end(),
                          [](const auto& rule) { return !rule.object.empty(); });
  rules_every = std::max(1L, std::lround(kRulePeriod / options.physics_step));
}

// Hard stops of the joints.
void World::Parts::add_stops() {
  for (std::size_t i = 0; i < robot_model.joints.size(); ++i) {
    const robot::JointLimits& limits = robot_model.joints[i].limits;
    if (!std::isfinite(limits.lower) || !std::isfinite(limits.upper)) continue;
    // Hard stops, a little beyond the limits so that they do not fight the servo there.
    const double slack = 0.002;
    stops.push_back(std::make_unique<btMultiBodyJointLimitConstraint>(
        &robot.body(), static_cast<int>(i), limits.lower - slack, limits.upper + slack));
    physics.world().addMultiBodyConstraint(stops.back().get());
  }
}

World::Parts::~Parts() {
  for (auto& stop : stops) physics.world().removeMultiBodyConstraint(stop.get());
  physics.remove(robot);
}

void World::Parts::run_rules(double dt) {
  DeviceInput input;
  input.joint = [this](const std::string& name) {
    const int index = parts.find(name);
    return index < 0 ? 0.0 : parts.position(static_cast<std::size_t>(index));
  };
  for (std::size_t i = 0; i < movables.count(); ++i) {
    input.objects.push_back(movables.pose(i));
    input.held.push_back(grasping.holds(i));
    input.hands.push_back(grasping.hands_on(i));
  }
  if (has_spots) input.touches = finger_touches();
  rules.update(input, dt);
}

// Where fingers press down on movable things, in those things' frames. A grip from the sides is no press.
std::vector<Touch> World::Parts::finger_touches() {
  std::vector<Touch> touches;
  btDispatcher* dispatcher = physics.world().getDispatcher();
  for (int m = 0; m < dispatcher->getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(m);
    if (manifold->getNumContacts() == 0) continue;
    const bool first = is_finger(manifold->getBody0());
    if (!first && !is_finger(manifold->getBody1())) continue;
    const int object = movables.find(first ? manifold->getBody1() : manifold->getBody0());
    if (object < 0) continue;
    const std::size_t index = static_cast<std::size_t>(object);
    auto touch =
        std::find_if(touches.begin(), touches.end(), [&](const Touch& t) { return t.object == index; });
    if (touch == touches.end())
      touch = touches.insert(touches.end(), Touch{index, Eigen::Vector3d::Zero(), 0.0});
    const Eigen::Vector3d down = -(movables.pose(index).linear().col(2));
    for (int c = 0; c < manifold->getNumContacts(); ++c) {
      const btManifoldPoint& point = manifold->getContactPoint(c);
      // Bullet's normal points from the second body to the first.
      const Eigen::Vector3d push = (first ? -1.0 : 1.0) * from_bullet(point.m_normalWorldOnB);
      const double force = std::max(0.0, push.dot(down)) * point.getAppliedImpulse() / options.physics_step;
      touch->point += force * from_bullet(point.getPositionWorldOnB());
      touch->force += force;
    }
  }
  std::erase_if(touches, [](const Touch& touch) { return touch.force <= 0.0; });
  for (Touch& touch : touches)
    touch.point = movables.pose(touch.object).inverse() * (touch.point / touch.force);
  return touches;
}

bool World::Parts::is_finger(const btCollisionObject* object) {
  return std::any_of(fingers.begin(), fingers.end(),
                     [&](std::size_t joint) { return robot.collider(joint) == object; });
}

}  // namespace goalnet::sim
