#include "sim/inverse_dynamics.h"

namespace goalnet::sim {

InverseDynamics::InverseDynamics(const scene::Pose& base, const std::vector<LinkSpec>& links)
    : base_(base), links_(links), bodies_(links.size()) {
  for (auto& link : links_) {
    link.shapes.clear();
    tensors_.push_back(inertia_tensor(link.mass));
  }
}

void InverseDynamics::compute(const std::vector<double>& position, const std::vector<double>& velocity,
                              const std::vector<double>& acceleration, std::vector<double>& force) {
  const Eigen::Vector3d gravity(0.0, 0.0, -9.81);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const LinkSpec& link = links_[i];
    Body& body = bodies_[i];
    const Body* parent = link.parent < 0 ? nullptr : &bodies_[static_cast<std::size_t>(link.parent)];
    body.pose = (parent != nullptr ? parent->pose : base_) * link.origin;
    const Eigen::Vector3d axis = body.pose.linear() * link.axis;
    if (link.prismatic) {
      body.pose.translation() += position[i] * axis;
      body.axis_angular.setZero();
      body.axis_linear = axis;
    } else {
      body.pose.linear() = body.pose.linear() * Eigen::AngleAxisd(position[i], link.axis).toRotationMatrix();
      body.axis_angular = axis;
      body.axis_linear =
          body.pose.translation().cross(axis);  // velocity of the body's point at the map's origin
    }
    const double rate = velocity[i];
    // In free fall nothing needs force: accelerating the base upwards by g stands for gravity.
    body.velocity_angular = body.axis_angular * rate;
    body.velocity_linear = body.axis_linear * rate;
    body.acceleration_angular = body.axis_angular * acceleration[i];
    body.acceleration_linear = body.axis_linear * acceleration[i];
    if (parent != nullptr) {
      body.velocity_angular += parent->velocity_angular;
      body.velocity_linear += parent->velocity_linear;
      body.acceleration_angular += parent->acceleration_angular;
      body.acceleration_linear += parent->acceleration_linear;
    } else {
      body.acceleration_linear -= gravity;
    }
    // d/dt of the axis, which moves with the body: v x S * rate (spatial motion cross product).
    body.acceleration_angular += body.velocity_angular.cross(body.axis_angular) * rate;
    body.acceleration_linear +=
        (body.velocity_angular.cross(body.axis_linear) + body.velocity_linear.cross(body.axis_angular)) *
        rate;

    // Newton and Euler at the centre of mass, moved to the map's origin.
    const double mass = link.mass.mass;
    const Eigen::Vector3d center = body.pose * Eigen::Vector3d(link.mass.center.translation());
    const Eigen::Matrix3d rotation = body.pose.linear();
    const Eigen::Matrix3d tensor = rotation * tensors_[i] * rotation.transpose();
    const Eigen::Vector3d& w = body.velocity_angular;
    const Eigen::Vector3d center_velocity = body.velocity_linear + w.cross(center);
    // Spatial to ordinary acceleration of the centre: add w x v.
    const Eigen::Vector3d center_acceleration =
        body.acceleration_linear + body.acceleration_angular.cross(center) + w.cross(center_velocity);
    body.force = mass * center_acceleration;
    body.moment = tensor * body.acceleration_angular + w.cross(tensor * w) + center.cross(body.force);
  }
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Body& body = bodies_[i];
    force[i] = body.axis_angular.dot(body.moment) + body.axis_linear.dot(body.force);
    if (links_[i].parent >= 0) {
      Body& parent = bodies_[static_cast<std::size_t>(links_[i].parent)];
      parent.moment += body.moment;
      parent.force += body.force;
    }
  }
}

}  // namespace goalnet::sim
