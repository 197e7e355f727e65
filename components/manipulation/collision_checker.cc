#include "components/manipulation/collision_checker.h"

#include <algorithm>

namespace goalnet::manipulation {
namespace {

const char* const kFloor = "floor";

}  // namespace

void Tolerances::allow(int part, int body, double distance) {
  auto [at, fresh] = limits_.try_emplace({part, body}, distance);
  if (!fresh) at->second = std::min(at->second, distance);
}

void Tolerances::allow_self(int part_a, int part_b, double distance) {
  allow(std::min(part_a, part_b), -1 - std::max(part_a, part_b), distance);
}

void Tolerances::allow_all(const PartSet& parts, int body) {
  for (const int part : parts) allow(part, body, kAnyDepth);
}

double Tolerances::limit(int part, int body, double margin) const {
  const auto found = limits_.find({part, body});
  return found == limits_.end() ? margin : std::min(margin, found->second);
}

CollisionChecker::CollisionChecker(const robot::RobotModel& model, const robot::Kinematics& kinematics,
                                   const scene::Scene& scene)
    : model_(model), kinematics_(kinematics), scene_(scene) {
  const auto add = [&](const std::string& name, std::vector<Piece> pieces, const Pose& pose) {
    body_index_.emplace(name, static_cast<int>(bodies_.size()));
    bodies_.push_back({name, PlacedShape(std::move(pieces)), true});
    bodies_.back().shape.place(pose);
  };
  for (const auto& fixture : scene.fixtures) {
    add(fixture.name, pieces_of(fixture.shapes), fixture.pose);
    for (const auto& part : fixture.parts) add(part.name, pieces_of(part.shapes), Pose::Identity());
  }
  for (const auto& object : scene.objects)
    add(object.name, pieces_of(scene.model_of(object).shapes), Pose::Identity());
  for (const auto& object : scene.objects)
    bodies_[static_cast<std::size_t>(body_index_.at(object.name))].movable = true;
  for (const auto& m : scene.models) object_shapes_.emplace(m.name, PlacedShape(pieces_of(m.shapes)));
  scene::Shape floor;
  floor.size = Eigen::Vector3d(60, 60, 1);
  floor.pose.translation().z() = -0.5;
  add(kFloor, pieces_of({floor}), Pose::Identity());
  floor_ = body(kFloor);

  for (std::size_t i = 0; i < kinematics.link_count(); ++i) {
    parts_.emplace_back(pieces_of(*model.urdf->getLink(kinematics.link_name(i))));
  }
  for (const auto& arm : model.arms) {
    tool_links_.push_back(kinematics.link_index(arm.tool_link));
    PartSet moving, hand;
    for (std::size_t i = 0; i < kinematics.link_count(); ++i) {
      bool below_arm = false, below_last = false;
      for (int l = static_cast<int>(i); l > 0; l = kinematics.parent_of(static_cast<std::size_t>(l))) {
        const int joint = kinematics.joint_of(static_cast<std::size_t>(l));
        if (joint < 0) continue;
        const auto& name = model.joints[static_cast<std::size_t>(joint)].name;
        below_arm |= std::find(arm.joints.begin(), arm.joints.end(), name) != arm.joints.end();
        below_last |= name == arm.joints.back();
      }
      if (below_arm && !parts_[i].empty()) moving.push_back(static_cast<int>(i));
      if (below_last && !parts_[i].empty()) hand.push_back(static_cast<int>(i));
    }
    moving.push_back(static_cast<int>(kinematics.link_count() + arm_parts_.size()));
    hand.push_back(moving.back());
    arm_parts_.push_back(moving);
    hand_parts_.push_back(hand);
    parts_.emplace_back();
    held_.emplace_back();
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const int part = static_cast<int>(i);
    const bool attachment = i >= kinematics.link_count();
    if (parts_[i].empty() && !attachment) continue;
    all_parts_.push_back(part);
    bool of_arm = false;
    for (const auto& set : arm_parts_) of_arm |= contains(set, part);
    if (!of_arm) trunk_parts_.push_back(part);
  }
  find_self_pairs();
}

void CollisionChecker::find_self_pairs() {
  // Neighbours always touch; so do pairs that touch at home. Everything else is checked.
  place_robot(model_.home());
  const int links = static_cast<int>(kinematics_.link_count());
  const auto near_relatives = [&](int a, int b) {
    int steps = 0;
    for (int l = b; l >= 0 && steps < 4; l = kinematics_.parent_of(static_cast<std::size_t>(l)), ++steps) {
      if (l == a) return steps <= 2;
    }
    return false;
  };
  for (std::size_t i = 0; i < all_parts_.size(); ++i) {
    for (std::size_t j = i + 1; j < all_parts_.size(); ++j) {
      const int a = all_parts_[i], b = all_parts_[j];
      const auto same_hand = [&](const PartSet& hand) { return contains(hand, a) && contains(hand, b); };
      if (std::any_of(hand_parts_.begin(), hand_parts_.end(), same_hand)) continue;
      if (contains(trunk_parts_, a) && contains(trunk_parts_, b)) continue;
      if (a < links && b < links) {
        if (near_relatives(a, b) || near_relatives(b, a)) continue;
        if (nearer_than(parts_[static_cast<std::size_t>(a)], parts_[static_cast<std::size_t>(b)],
                        kSelfMargin))
          continue;
      }
      self_pairs_.emplace_back(a, b);
    }
  }
}

void CollisionChecker::update(const WorldView& world, const std::vector<std::optional<HeldObject>>& held) {
  for (const auto& fixture : scene_.fixtures) {
    for (const auto& part : fixture.parts) {
      bodies_[static_cast<std::size_t>(body_index_.at(part.name))].shape.place(
          scene::part_pose(fixture, part, [&](const std::string& joint) { return world.joint(joint); }));
    }
  }
  for (const auto& object : scene_.objects) {
    auto& b = bodies_[static_cast<std::size_t>(body_index_.at(object.name))];
    const Pose* pose = world.object(object.name);
    b.present = pose != nullptr;
    if (pose) b.shape.place(*pose);
  }
  find_riding(world);
  held_ = held;
  held_.resize(model_.arms.size());
  for (std::size_t arm = 0; arm < held_.size(); ++arm) {
    auto& shape = parts_[kinematics_.link_count() + arm];
    shape = PlacedShape();
    if (!held_[arm]) continue;
    const auto* m = scene_.find_model_of(held_[arm]->name);
    if (m == nullptr) continue;
    shape = object_shapes_.at(m->name);
    bodies_[static_cast<std::size_t>(body_index_.at(held_[arm]->name))].present = false;
    // What is in it or on it comes along.
    for (const Predicate& fact : world.facts) {
      if ((fact.relation != "In" && fact.relation != "On") || fact.object != held_[arm]->name) continue;
      if (const int content = body(fact.subject); content >= 0)
        bodies_[static_cast<std::size_t>(content)].present = false;
    }
  }
}

// What stands in a slot of the tray, what is in or on that, and so on.
void CollisionChecker::find_riding(const WorldView& world) {
  riding_.clear();
  for (Body& b : bodies_) b.riding = false;
  if (!model_.tray) return;
  const Pose to_tray = kinematics_.forward(world.robot, kinematics_.link_index(model_.tray->link)).inverse();
  const auto over_tray = [&](const Pose& object) {
    const Eigen::Vector3d p = to_tray * object.translation();
    return std::ranges::any_of(model_.tray->slots, [&](const auto& slot) {
      const Eigen::Vector3d d = p - slot.position;
      return std::abs(d.x()) < slot.size.x() / 2 && std::abs(d.y()) < slot.size.y() / 2 && d.z() > -0.02 &&
             d.z() < 0.06;
    });
  };
  const auto add = [&](const std::string& name) {
    const Pose* pose = world.object(name);
    Body& b = bodies_[static_cast<std::size_t>(body(name))];
    if (pose == nullptr || b.riding) return;
    b.riding = true;
    b.pose = *pose;
    b.on_tray = to_tray * *pose;
    riding_.push_back(body(name));
  };
  for (const auto& object : scene_.objects)
    if (const Pose* pose = world.object(object.name); pose != nullptr && over_tray(*pose)) add(object.name);
  for (std::size_t i = 0; i < riding_.size(); ++i) {
    const std::string below = bodies_[static_cast<std::size_t>(riding_[i])].name;
    for (const Predicate& fact : world.facts)
      if ((fact.relation == "In" || fact.relation == "On") && fact.object == below && body(fact.subject) >= 0)
        add(fact.subject);
  }
}

void CollisionChecker::ride_along(bool along) {
  along_ = along;
  for (const int i : riding_) {
    Body& b = bodies_[static_cast<std::size_t>(i)];
    b.shape.place(b.pose);
  }
}

const PlacedShape& CollisionChecker::shape_of(int part) const {
  const auto i = static_cast<std::size_t>(part);
  return i < parts_.size() ? parts_[i] : bodies_[i - parts_.size()].shape;
}

bool CollisionChecker::rides(const std::string& object) const {
  const int i = body(object);
  return i >= 0 && bodies_[static_cast<std::size_t>(i)].present &&
         bodies_[static_cast<std::size_t>(i)].riding;
}

void CollisionChecker::leave_out(const std::vector<std::string>& objects) {
  for (Body& b : bodies_) b.left_out = false;
  for (const std::string& name : objects)
    if (const int i = body(name); i >= 0) bodies_[static_cast<std::size_t>(i)].left_out = true;
}

void CollisionChecker::pose_joint(const WorldView& world, const std::string& joint, double position) {
  const auto ref = scene_.find_joint(joint);
  if (!ref) return;
  for (const auto& part : ref.fixture->parts) {
    bodies_[static_cast<std::size_t>(body_index_.at(part.name))].shape.place(scene::part_pose(
        *ref.fixture, part,
        [&](const std::string& name) { return name == joint ? position : world.joint(name); }));
  }
}

int CollisionChecker::body(const std::string& name) const {
  const auto found = body_index_.find(name);
  return found == body_index_.end() ? -1 : found->second;
}

std::string CollisionChecker::part_name(int part) const {
  const auto i = static_cast<std::size_t>(part);
  if (i < kinematics_.link_count()) return kinematics_.link_name(i);
  if (i >= parts_.size()) return bodies_[i - parts_.size()].name;
  const auto& held = held_[i - kinematics_.link_count()];
  return held ? held->name : "hand";
}

}  // namespace goalnet::manipulation
