// Doors, knobs and buttons: one multibody for each part that hangs on a fixture, with its children.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>

#include "components/scene/scene.h"
#include "sim/physics.h"

namespace goalnet::sim {

class MovingParts {
 public:
  MovingParts(Physics& physics, const scene::Scene& scene);
  ~MovingParts();

  // Joints in the order of the scene: fixtures, then parts.
  std::size_t count() const { return joints_.size(); }
  const scene::Joint& joint(std::size_t i) const { return *joints_[i].spec; }
  int find(std::string_view joint_name) const;
  double position(std::size_t i) const;
  double velocity(std::size_t i) const;
  double effort(std::size_t i) const { return joints_[i].effort; }
  void set_position(std::size_t i, double q);
  void freeze(std::size_t i, bool frozen);

  // Friction and springs for the physics step ahead.
  void apply(double dt);

 private:
  struct JointOfPart {
    const scene::Joint* spec = nullptr;
    ArticulatedBody* body = nullptr;
    std::size_t link = 0;
    double inertia = 0;  // [kg m^2 or kg] about the joint
    double effort = 0;
    bool frozen = false;
    double frozen_at = 0;
  };
  bool asleep(const JointOfPart& joint) const;

  Physics& physics_;
  std::vector<std::unique_ptr<ArticulatedBody>> bodies_;
  std::vector<std::unique_ptr<btMultiBodyJointLimitConstraint>> limits_;
  std::vector<JointOfPart> joints_;
};

}  // namespace goalnet::sim
