#include "sim/robot_links.h"

#include <urdf_model/link.h>

#include "components/robot/joint_order.h"

namespace goalnet::sim {
namespace {

scene::Pose pose_of(const urdf::Pose& pose) {
  scene::Pose result = scene::Pose::Identity();
  const auto& q = pose.rotation;
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  result.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return result;
}

Expected<scene::Shape> shape_of(const urdf::Geometry& geometry, const std::string& link) {
  scene::Shape shape;
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const auto& box = static_cast<const urdf::Box&>(geometry);
      shape.size = {box.dim.x, box.dim.y, box.dim.z};
      return shape;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      shape.kind = scene::ShapeKind::kCylinder;
      shape.size = {cylinder.radius, cylinder.radius, cylinder.length};
      return shape;
    }
    case urdf::Geometry::SPHERE: {
      shape.kind = scene::ShapeKind::kSphere;
      shape.size = Eigen::Vector3d::Constant(static_cast<const urdf::Sphere&>(geometry).radius);
      return shape;
    }
    default:
      return fail(Outcome::kInvalidRequest, "robot link '" + link +
                                                "' uses a mesh; the simulator knows box, cylinder and "
                                                "sphere: approximate it with those");
  }
}

MassProperties mass_of(const urdf::Link& link) {
  if (!link.inertial) return {};
  const urdf::Inertial& inertial = *link.inertial;
  Eigen::Matrix3d tensor;
  tensor << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz, inertial.ixz,
      inertial.iyz, inertial.izz;
  return mass_of_tensor(inertial.mass, pose_of(inertial.origin), tensor);
}

MassProperties moved(const MassProperties& properties, const scene::Pose& by) {
  MassProperties result = properties;
  result.center = by * properties.center;
  return result;
}

}  // namespace

Expected<std::vector<scene::Shape>> shapes_of_link(const urdf::Link& link, bool visual) {
  std::vector<scene::Shape> shapes;
  const auto append = [&](const auto& element) -> Expected<void> {
    if (!element || !element->geometry) return {};
    auto shape = shape_of(*element->geometry, link.name);
    if (!shape) return tl::unexpected(shape.error());
    shape->pose = pose_of(element->origin);
    if constexpr (requires { element->material; }) {
      if (element->material) {
        const auto& color = element->material->color;
        shape->color = {color.r, color.g, color.b};
      }
    }
    shapes.push_back(*shape);
    return {};
  };
  if (visual) {
    for (const auto& element : link.visual_array) {
      if (auto done = append(element); !done) return tl::unexpected(done.error());
    }
  } else {
    for (const auto& element : link.collision_array) {
      if (auto done = append(element); !done) return tl::unexpected(done.error());
    }
  }
  return shapes;
}

Expected<RobotLinks> make_robot_links(const robot::RobotModel& model) {
  RobotLinks result;
  result.links.resize(model.joints.size());
  const auto absorb = [&](const urdf::Link& link, const MergedLink& place) -> Expected<void> {
    result.merged[link.name] = place;
    if (place.link < 0) return {};
    LinkSpec& spec = result.links[static_cast<std::size_t>(place.link)];
    spec.mass = combine(spec.mass, moved(mass_of(link), place.pose));
    auto shapes = shapes_of_link(link, false);
    if (!shapes) return tl::unexpected(shapes.error());
    for (auto shape : *shapes) {
      shape.pose = place.pose * shape.pose;
      spec.shapes.push_back(shape);
    }
    return {};
  };
  if (auto done = absorb(*model.urdf->getRoot(), MergedLink{}); !done) return tl::unexpected(done.error());
  for (const auto& joint : robot::joints_depth_first(*model.urdf)) {
    const MergedLink parent = result.merged.at(joint->parent_link_name);
    const scene::Pose origin = parent.pose * pose_of(joint->parent_to_joint_origin_transform);
    MergedLink place{parent.link, origin};
    if (robot::is_actuated(*joint)) {
      const int index = model.index_of(joint->name);
      LinkSpec& spec = result.links[static_cast<std::size_t>(index)];
      spec.joint = joint->name;
      spec.parent = parent.link;
      spec.prismatic = joint->type == urdf::Joint::PRISMATIC;
      spec.origin = origin;
      spec.axis = Eigen::Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
      place = MergedLink{index, scene::Pose::Identity()};
    }
    const auto link = model.urdf->getLink(joint->child_link_name);
    if (auto done = absorb(*link, place); !done) return tl::unexpected(done.error());
  }
  for (const auto& spec : result.links) {
    if (spec.mass.mass <= 0.0) {
      return fail(Outcome::kInvalidRequest, model.file + ": the link moved by joint '" + spec.joint +
                                                "' has no mass; add <inertial> to it");
    }
  }
  return result;
}

}  // namespace goalnet::sim
