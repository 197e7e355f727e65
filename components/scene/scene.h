// A room: fixtures, movable objects, named places and device rules, loaded from config/scenes/*.yaml.
// The map frame: origin on the floor, z up, metres and radians. All names are those of facts and plans.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/scene/device_rule.h"
#include "components/scene/fixture.h"
#include "components/scene/object_model.h"
#include "components/scene/region.h"

namespace goalnet::scene {

// Where an object stands at the start; varied by the seed.
struct Placement {
  Pose pose = Pose::Identity();  // nominal, in the map frame
  std::string on;                // region it stands on or in
  double jitter_xy = 0.0;        // [m] uniform in +- this, along the map's x and y
  double jitter_yaw = 0.0;       // [rad] uniform in +- this
};

struct Object {
  std::string name;       // Mug_1
  std::size_t model = 0;  // index into Scene::models
  Placement placement;
  std::vector<std::string> states;  // initial values: Coffee, ScoopsLeft, ...
};

struct Scene {
  std::string name;  // kitchen
  std::string file;
  double floor_x_min = 0, floor_x_max = 0, floor_y_min = 0, floor_y_max = 0;  // [m] where the robot may drive
  Eigen::Vector3d robot_start = Eigen::Vector3d::Zero();                      // x [m], y [m], yaw [rad]
  std::vector<ObjectModel> models;
  std::vector<Object> objects;  // sorted by name
  std::vector<Fixture> fixtures;
  std::vector<Region> regions;
  DeviceRules rules;
  std::vector<Predicate> initial_facts;  // device states at the start, (state Tv_1 Channel1)
  std::vector<std::string> symbols;      // every name that facts may use as an object, sorted, Robot included

  const Object* find_object(std::string_view name) const;
  const ObjectModel& model_of(const Object& object) const { return models[object.model]; }
  const ObjectModel* find_model_of(std::string_view object_name) const;
  const Fixture* find_fixture(std::string_view name) const;
  const Region* find_region(std::string_view name) const;

  struct PartRef {
    const Fixture* fixture = nullptr;
    const Part* part = nullptr;
    explicit operator bool() const { return part != nullptr; }
  };
  // By part name (MicrowaveDoor) or by the name that plans use (Microwave in open Microwave).
  PartRef find_part(std::string_view name) const;
  PartRef find_joint(std::string_view joint_name) const;
};

// `name_or_path`: "kitchen" means scenes/kitchen.yaml in the configuration folder (config_path.h says which
// that is); anything with a '/' or ending in .yaml is a path. Errors: kInvalidRequest with "file:line: what
// is wrong; what to do".
Expected<Scene> load_scene(const std::string& name_or_path);

// The same from memory; `path` stands for the file in messages and says where its libraries lie (../objects,
// beside it, or in the configuration folder's objects).
Expected<Scene> parse_scene(const std::string& text, const std::string& path);

// Poses of all objects (in the order of Scene::objects) for a seed: nominal poses plus jitter. The same seed
// gives the same bits on every machine. Seed 0 is the nominal scene.
std::vector<Pose> initial_poses(const Scene& scene, std::uint64_t seed);

// Frame of a part in the map frame for given joint positions; `position(joint name)` is asked for every joint
// on the way from the fixture to the part.
template <class Position>
Pose part_pose(const Fixture& fixture, const Part& part, Position&& position) {
  const Pose parent =
      part.parent < 0 ? fixture.pose
                      : part_pose(fixture, fixture.parts[static_cast<std::size_t>(part.parent)], position);
  const double q = position(part.joint.name);
  Pose motion = Pose::Identity();
  if (part.joint.kind == JointKind::kRevolute) {
    motion.linear() = Eigen::AngleAxisd(q, part.joint.axis).toRotationMatrix();
  } else {
    motion.translation() = q * part.joint.axis;
  }
  return parent * part.joint.origin * motion;
}

}  // namespace goalnet::scene
