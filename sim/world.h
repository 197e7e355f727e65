// The simulated room: physics in Bullet (double precision), device rules on top. Pure: no DDS, no clocks, no
// threads. One object, one thread. Same scene, robot, options and calls give the same bits.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "sim/world_options.h"

namespace goalnet::sim {

// Two things that touch, by name: objects, parts, fixtures, "floor", or the robot's links as "robot/<link>".
struct Contact {
  std::string a, b;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m] map frame
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // from b towards a
  double distance = 0.0;                               // [m] negative: overlapping
  double force = 0.0;                                  // [N]
};

struct JointReading {
  double position = 0.0;  // [rad or m]
  double velocity = 0.0;  // [rad/s or m/s]
  double effort = 0.0;    // [N m or N] applied by the joint's servo (robot) or friction and spring (fixtures)
};

struct HeldObject {
  std::string arm;
  std::string object;
  double force = 0.0;  // [N] through the grasp, smoothed
};

class World {
 public:
  // Fails with kInvalidRequest if the robot cannot be built.
  static Expected<std::unique_ptr<World>> create(const scene::Scene& scene, const robot::RobotModel& robot,
                                                 const WorldOptions& options);
  ~World();

  // Advances by one physics step.
  void step();
  double time() const;  // [s] since the start
  const WorldOptions& options() const;

  // Robot joints in the order of RobotModel::joints.
  std::size_t robot_joint_count() const;
  JointReading robot_joint(std::size_t joint) const;
  // Servo target; velocity is fed forward.
  void command(std::size_t joint, double position, double velocity);
  // Puts the robot there at once, at rest, and holds it (start of a scene and tests).
  void set_robot_position(std::size_t joint, double position);

  // Fixture joints in the order of the scene: fixtures, then their parts.
  std::size_t fixture_joint_count() const;
  const std::string& fixture_joint_name(std::size_t joint) const;
  JointReading fixture_joint(std::size_t joint) const;
  int find_fixture_joint(std::string_view name) const;  // -1: none
  void set_fixture_position(std::size_t joint, double position);

  // Movable objects in the order of Scene::objects.
  scene::Pose object_pose(std::size_t object) const;
  Eigen::Vector3d object_velocity(std::size_t object) const;  // [m/s]
  // Moves an object at once and to rest: for tests and faults. Breaks a grasp on it.
  void set_object_pose(std::size_t object, const scene::Pose& pose);
  // A push on the centre of mass for one physics step [N]: for tests.
  void push_object(std::size_t object, const Eigen::Vector3d& force);
  bool at_rest(std::size_t object) const;

  std::vector<Contact> contacts() const;
  bool touching(std::string_view a, std::string_view b) const;
  std::vector<HeldObject> held() const;

  // (state …) facts: contents, temperature, devices; sorted.
  const FactSet& facts() const;
  void set_fact(const Predicate& fact, bool holds);

  // Faults; each stays until lifted.
  void drop_grasp(std::string_view arm);                   // the hand loses what it holds
  void freeze_joint(std::string_view joint, bool frozen);  // a robot or fixture joint does not move any more
  void disable_device(std::string_view subject, bool dead);  // (state subject …) does not change any more

  // First thing that a ray meets, for pictures and tests. Empty name: nothing.
  struct RayHit {
    std::string name;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    std::array<double, 3> color = {0, 0, 0};
  };
  // `grazing`: exact along surfaces, where the usual way hits at random; its normals at edges are worse, and
  // it takes longer.
  RayHit ray(const Eigen::Vector3d& from, const Eigen::Vector3d& to, bool grazing = false) const;

  const scene::Scene& scene() const;
  const robot::RobotModel& robot() const;
  // Frame of a URDF link in the map frame; identity for unknown names.
  scene::Pose robot_link_pose(const std::string& link) const;

 private:
  struct Parts;
  explicit World(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace goalnet::sim
