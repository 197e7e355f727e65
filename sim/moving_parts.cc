#include "sim/moving_parts.h"

#include <algorithm>
#include <cmath>

namespace goalnet::sim {
namespace {

LinkSpec link_of(const scene::Part& part, int parent) {
  LinkSpec link;
  link.joint = part.joint.name;
  link.parent = parent;
  link.prismatic = part.joint.kind == scene::JointKind::kPrismatic;
  link.origin = part.joint.origin;
  link.axis = part.joint.axis;
  link.mass = mass_of_shapes(part.shapes, part.mass);
  link.shapes = part.shapes;
  link.friction = part.friction;
  return link;
}

double inertia_about_joint(const LinkSpec& link) {
  if (link.prismatic) return link.mass.mass;
  const double arm = link.axis.cross(Eigen::Vector3d(link.mass.center.translation())).norm();
  return link.axis.dot(inertia_tensor(link.mass) * link.axis) + link.mass.mass * arm * arm;
}

}  // namespace

MovingParts::MovingParts(Physics& physics, const scene::Scene& scene) : physics_(physics) {
  for (const auto& fixture : scene.fixtures) {
    const std::size_t count = fixture.parts.size();
    const std::size_t first = joints_.size();
    joints_.resize(first + count);
    for (std::size_t root = 0; root < count; ++root) {
      if (fixture.parts[root].parent >= 0) continue;
      // The root and everything that hangs on it; parents stand before children.
      std::vector<int> place(count, -1);
      std::vector<LinkSpec> links;
      std::vector<std::string> names;
      std::vector<std::size_t> members;
      for (std::size_t i = root; i < count; ++i) {
        const scene::Part& part = fixture.parts[i];
        const int parent = part.parent < 0 ? -1 : place[static_cast<std::size_t>(part.parent)];
        if (i != root && parent < 0) continue;
        place[i] = static_cast<int>(links.size());
        links.push_back(link_of(part, i == root ? -1 : parent));
        names.push_back(part.name);
        members.push_back(i);
      }
      bodies_.push_back(std::make_unique<ArticulatedBody>(fixture.pose, links));
      ArticulatedBody& body = *bodies_.back();
      body.body().setCanSleep(true);
      body.body().setSleepThreshold(1e-6);
      body.body().setSleepTimeout(0.5);
      physics.add_articulated(body, names, kPartGroup, kRobotGroup | kObjectGroup);
      for (std::size_t k = 0; k < members.size(); ++k) {
        const scene::Joint& joint = fixture.parts[members[k]].joint;
        JointOfPart& entry = joints_[first + members[k]];
        entry.spec = &joint;
        entry.body = &body;
        entry.link = k;
        entry.inertia = inertia_about_joint(body.links()[k]);
        limits_.push_back(std::make_unique<btMultiBodyJointLimitConstraint>(&body.body(), static_cast<int>(k),
                                                                            joint.lower, joint.upper));
        physics.world().addMultiBodyConstraint(limits_.back().get());
      }
    }
  }
}

MovingParts::~MovingParts() {
  for (auto& limit : limits_) physics_.world().removeMultiBodyConstraint(limit.get());
  for (auto& body : bodies_) physics_.remove(*body);
}

int MovingParts::find(std::string_view joint_name) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].spec->name == joint_name) return static_cast<int>(i);
  }
  return -1;
}

double MovingParts::position(std::size_t i) const { return joints_[i].body->position(joints_[i].link); }
double MovingParts::velocity(std::size_t i) const { return joints_[i].body->velocity(joints_[i].link); }

void MovingParts::set_position(std::size_t i, double q) {
  ArticulatedBody& body = *joints_[i].body;
  body.set_position(joints_[i].link, std::clamp(q, joints_[i].spec->lower, joints_[i].spec->upper));
  body.update_transforms();
  body.body().wakeUp();
  for (std::size_t k = 0; k < body.links().size(); ++k) {
    if (body.collider(k) == nullptr) continue;
    body.collider(k)->setActivationState(ACTIVE_TAG);
    physics_.forget_contacts(*body.collider(k));
    physics_.world().updateSingleAabb(body.collider(k));
  }
}

bool MovingParts::asleep(const JointOfPart& joint) const {
  for (std::size_t k = 0; k < joint.body->links().size(); ++k) {
    btMultiBodyLinkCollider* collider = joint.body->collider(k);
    if (collider != nullptr && collider->getActivationState() == ISLAND_SLEEPING) return true;
  }
  return false;
}

void MovingParts::freeze(std::size_t i, bool frozen) {
  if (frozen && !joints_[i].frozen) joints_[i].frozen_at = position(i);
  joints_[i].frozen = frozen;
}

void MovingParts::apply(double dt) {
  for (auto& joint : joints_) {
    // Bullet neither moves nor clears the forces of what sleeps.
    if (asleep(joint)) continue;
    const double v = joint.body->velocity(joint.link);
    const double q = joint.body->position(joint.link);
    const scene::Joint& spec = *joint.spec;
    // Dry friction: at most what stops the joint within this step.
    const double stop = joint.inertia * v / dt;
    double effort = -std::clamp(stop, -spec.friction, spec.friction) - spec.damping * v;
    if (joint.frozen) effort = -stop - 0.3 * joint.inertia * (q - joint.frozen_at) / (dt * dt);
    if (spec.return_force > 0.0 && !joint.frozen) {
      const double soft =
          spec.kind == scene::JointKind::kPrismatic ? 0.001 : 0.02;  // fades out near its rest
      effort += spec.return_force * std::clamp((spec.rest - q) / soft, -1.0, 1.0);
    }
    joint.effort = effort;
    joint.body->body().addJointTorque(static_cast<int>(joint.link), effort);
  }
}

}  // namespace goalnet::sim
