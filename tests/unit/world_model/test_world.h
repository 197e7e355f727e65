// A kitchen and a robot for tests: objects are put where a test wants them, joints are set, and facts come
// out.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "components/world_model/world_model.h"

namespace goalnet::world_model::test {

template <class T>
T value_or_throw(Expected<T> loaded) {
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return std::move(*loaded);
}
inline const scene::Scene& kitchen() {
  static const scene::Scene scene = value_or_throw(scene::load_scene("kitchen"));
  return scene;
}
inline const scene::Scene& living_room() {
  static const scene::Scene scene = value_or_throw(scene::load_scene("living_room"));
  return scene;
}
inline const robot::RobotModel& default_robot() {
  static const robot::RobotModel robot = value_or_throw(robot::load_robot("default"));
  return robot;
}

class TestWorld {
 public:
  explicit TestWorld(Params params = {}, std::uint64_t seed = 0)
      : model(kitchen(), default_robot(), std::move(params)), kinematics_(default_robot()) {
    const auto poses = scene::initial_poses(kitchen(), seed);
    for (std::size_t i = 0; i < poses.size(); ++i) objects.push_back({kitchen().objects[i].name, poses[i]});
    for (std::size_t i = 0; i < default_robot().joints.size(); ++i) {
      joints.names.push_back(default_robot().joints[i].name);
      joints.positions.push_back(default_robot().home()[i]);
    }
  }

  // One observation of everything, 50 ms after the last.
  const FactSet& look(std::int64_t elapsed_ns = 50'000'000) {
    time_ns += elapsed_ns;
    joints.time_ns = time_ns;
    model.observe(joints);
    model.observe(ObservedPoses{time_ns, objects});
    return model.update().facts;
  }
  const FactSet& look_for(double seconds) {
    for (int n = 0; n < std::lround(seconds / 0.05) - 1; ++n) look();
    return look();
  }

  bool holds(const std::string& fact) const {
    return model.world().facts.contains(parse_predicate(fact).value());
  }

  scene::Pose& pose(const std::string& name) {
    for (ObservedPose& object : objects)
      if (object.name == name) return object.pose;
    throw std::out_of_range(name);
  }
  void put(const std::string& name, double x, double y, double z) {
    pose(name) = scene::make_pose({x, y, z}, Eigen::Vector3d::Zero());
  }
  // Puts the object on the middle of a region's support.
  void put_on(const std::string& name, const std::string& region, std::size_t support = 0) {
    const scene::Region* place = kitchen().find_region(region);
    pose(name) = kitchen().find_fixture(place->fixture)->pose * place->supports[support].frame;
  }
  double& joint(const std::string& name) {
    for (std::size_t i = 0; i < joints.names.size(); ++i)
      if (joints.names[i] == name) return joints.positions[i];
    joints.names.push_back(name);
    joints.positions.push_back(0.0);
    return joints.positions.back();
  }
  scene::Pose link(const std::string& name) const {
    return kinematics_.forward(std::vector<double>(joints.positions.begin(),
                                                   joints.positions.begin() + default_robot().joints.size()),
                               kinematics_.link_index(name));
  }
  void drive_to(double x, double y, double yaw) {
    joint("base_x") = x;
    joint("base_y") = y;
    joint("base_yaw") = yaw;
  }
  // Lets the left hand hold the mug by its wall: the middle of the mug lies between the pads, the hand comes
  // level.
  void grip_mug(const std::string& arm, const std::string& mug) {
    const scene::Pose tool = link(arm + "_tcp");
    // Upright against the hand: the object's z along the tool's x.
    scene::Pose object = scene::Pose::Identity();
    object.linear().col(2) = tool.linear().col(0);
    object.linear().col(0) = tool.linear().col(2);
    object.linear().col(1) = object.linear().col(2).cross(object.linear().col(0));
    object.translation() = tool.translation() - 0.06 * object.linear().col(2);
    pose(mug) = object;
    joint(arm + "_finger_1") = joint(arm + "_finger_2") = 0.040;
  }

  WorldModel model;
  std::vector<ObservedPose> objects;
  ObservedJoints joints;
  std::int64_t time_ns = 0;

 private:
  robot::Kinematics kinematics_;
};

}  // namespace goalnet::world_model::test
