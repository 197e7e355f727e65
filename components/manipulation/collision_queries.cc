// What of the robot is too near to what, in a posture that is asked about.
#include <algorithm>

#include "components/manipulation/collision_checker.h"

namespace goalnet::manipulation {
namespace {

bool contains_name(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void CollisionChecker::place_robot(const std::vector<double>& q) const {
  kinematics_.forward(q, link_poses_);
  for (std::size_t i = 0; i < link_poses_.size(); ++i) {
    if (!parts_[i].empty()) parts_[i].place(link_poses_[i]);
  }
  for (std::size_t arm = 0; arm < held_.size(); ++arm) {
    auto& shape = parts_[kinematics_.link_count() + arm];
    if (!shape.empty())
      shape.place(link_poses_[static_cast<std::size_t>(tool_links_[arm])] * held_[arm]->object_in_tool);
  }
  if (!along_ || riding_.empty()) return;
  const Pose& tray = link_poses_[static_cast<std::size_t>(kinematics_.link_index(model_.tray->link))];
  for (const int i : riding_) {
    Body& b = bodies_[static_cast<std::size_t>(i)];
    b.shape.place(tray * b.on_tray);
  }
}

// Calls visit(a, b, is_body, limit) for each pair to look at; stops when it returns true. What rides along is
// a part, too: the first after the robot's own.
template <class Visit>
void CollisionChecker::visit_contacts(const std::vector<double>& q, const CollisionQuery& query,
                                      Visit&& visit) const {
  place_robot(q);
  static const Tolerances kNone;
  const auto& tolerances = query.tolerances ? *query.tolerances : kNone;
  for (const int part : *query.parts) {
    const auto& shape = parts_[static_cast<std::size_t>(part)];
    if (shape.empty()) continue;
    const bool of_trunk = contains(trunk_parts_, part);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!bodies_[b].counts() || (of_trunk && static_cast<int>(b) == floor_))
        continue;  // the base stands on the floor
      if (of_trunk && along_ && bodies_[b].riding) continue;
      const double limit = tolerances.limit(part, static_cast<int>(b), query.margin);
      if (limit == Tolerances::kAnyDepth) continue;
      if (visit(part, static_cast<int>(b), true, limit)) return;
    }
  }
  for (std::size_t i = 0; along_ && i < riding_.size() && query.parts == &all_parts_; ++i) {
    if (!bodies_[static_cast<std::size_t>(riding_[i])].counts()) continue;
    const int part = static_cast<int>(parts_.size()) + riding_[i];
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!bodies_[b].counts() || bodies_[b].riding) continue;
      if (visit(part, static_cast<int>(b), true, tolerances.limit(part, static_cast<int>(b), query.margin)))
        return;
    }
  }
  if (!query.self) return;
  for (const auto& [a, b] : self_pairs_) {
    if (!contains(*query.parts, a) && !contains(*query.parts, b)) continue;
    if (visit(a, b, false, std::min(kSelfMargin, tolerances.limit(a, -1 - b, kSelfMargin)))) return;
  }
}

bool CollisionChecker::collides(const std::vector<double>& q, const CollisionQuery& query) const {
  bool hit = false;
  visit_contacts(q, query, [&](int a, int b, bool is_body, double limit) {
    const auto& other =
        is_body ? bodies_[static_cast<std::size_t>(b)].shape : parts_[static_cast<std::size_t>(b)];
    hit = nearer_than(shape_of(a), other, limit);
    return hit;
  });
  return hit;
}

std::string CollisionChecker::explain(const std::vector<double>& q, const CollisionQuery& query) const {
  std::string text;
  visit_contacts(q, query, [&](int a, int b, bool is_body, double limit) {
    const auto& other =
        is_body ? bodies_[static_cast<std::size_t>(b)].shape : parts_[static_cast<std::size_t>(b)];
    if (!nearer_than(shape_of(a), other, limit)) return false;
    text = part_name(a) + " touches " + (is_body ? bodies_[static_cast<std::size_t>(b)].name : part_name(b));
    return true;
  });
  return text;
}

std::vector<std::string> CollisionChecker::touched_objects(const std::vector<double>& q,
                                                           const CollisionQuery& query) const {
  std::vector<std::string> names;
  visit_contacts(q, query, [&](int a, int b, bool is_body, double limit) {
    if (!is_body) return false;
    const Body& other = bodies_[static_cast<std::size_t>(b)];
    if (other.movable && !contains_name(names, other.name) && nearer_than(shape_of(a), other.shape, limit))
      names.push_back(other.name);
    return false;
  });
  return names;
}

Tolerances CollisionChecker::baseline(const std::vector<double>& q, const CollisionQuery& query,
                                      double least) const {
  Tolerances out = query.tolerances ? *query.tolerances : Tolerances();
  visit_contacts(q, query, [&](int a, int b, bool is_body, double limit) {
    const auto& other =
        is_body ? bodies_[static_cast<std::size_t>(b)].shape : parts_[static_cast<std::size_t>(b)];
    const double distance = distance_between(shape_of(a), other, limit);
    // 2 mm of slack: measured postures tremble, and GJK is exact to tenths of a millimetre only.
    if (distance < limit && distance >= least) out.allow(a, is_body ? b : -1 - b, distance - 0.002);
    return false;
  });
  return out;
}

std::string CollisionChecker::hand_obstacle(const std::vector<double>& q, std::size_t arm, const Pose& tool,
                                            double margin, const Tolerances& tolerances) const {
  place_robot(q);
  const Pose to_tool = tool * link_poses_[static_cast<std::size_t>(tool_links_[arm])].inverse();
  for (const int part : hand_parts_[arm]) {
    auto& shape = parts_[static_cast<std::size_t>(part)];
    if (shape.empty()) continue;
    if (part == attachment(arm)) {
      shape.place(tool * held_[arm]->object_in_tool);
    } else {
      shape.place(to_tool * link_poses_[static_cast<std::size_t>(part)]);
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!bodies_[b].counts() || bodies_[b].riding) continue;
      const double limit = tolerances.limit(part, static_cast<int>(b), margin);
      if (limit != Tolerances::kAnyDepth && nearer_than(shape, bodies_[b].shape, limit))
        return bodies_[b].name;
    }
  }
  return "";
}

bool CollisionChecker::hand_collides(const std::vector<double>& q, std::size_t arm, const Pose& tool,
                                     double margin, const Tolerances& tolerances) const {
  return !hand_obstacle(q, arm, tool, margin, tolerances).empty();
}

bool CollisionChecker::object_fits(const std::string& object, const Pose& pose, double margin,
                                   const std::vector<std::string>& ignored) const {
  const auto* m = scene_.find_model_of(object);
  if (m == nullptr) return false;
  PlacedShape shape = object_shapes_.at(m->name);
  shape.place(pose);
  for (const auto& b : bodies_) {
    if (!b.counts() || b.name == object || std::find(ignored.begin(), ignored.end(), b.name) != ignored.end())
      continue;
    if (nearer_than(shape, b.shape, margin)) return false;
  }
  return true;
}

bool CollisionChecker::object_clears(const std::string& object, const Pose& pose, const std::string& other,
                                     double margin) const {
  const auto* m = scene_.find_model_of(object);
  const int index = body(other);
  if (m == nullptr || index < 0) return true;
  const Body& b = bodies_[static_cast<std::size_t>(index)];
  PlacedShape shape = object_shapes_.at(m->name);
  shape.place(pose);
  return !b.counts() || !nearer_than(shape, b.shape, margin);
}

}  // namespace goalnet::manipulation
