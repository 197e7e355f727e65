// Whether a posture of the robot touches anything: furniture, moving parts, objects, itself, what it holds.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/manipulation/convex_shapes.h"
#include "components/manipulation/world_view.h"
#include "components/robot/robot_model.h"
#include "components/scene/scene.h"

namespace goalnet::manipulation {

// Parts of the robot by index: links as in Kinematics, then one "attached object" per arm.
using PartSet = std::vector<int>;
inline bool contains(const PartSet& set, int part) {
  return std::find(set.begin(), set.end(), part) != set.end();
}

// Exceptions from the safety margin: pairs that may come nearer, down to `distance` [m].
class Tolerances {
 public:
  static constexpr double kAnyDepth = -std::numeric_limits<double>::infinity();

  void allow(int part, int body, double distance);
  void allow_all(const PartSet& parts, int body);  // contact of any depth: the hand and what it grasps
  void allow_self(int part_a, int part_b,
                  double distance);  // two parts of the robot: what is held and the tray
  double limit(int part, int body, double margin) const;

 private:
  std::map<std::pair<int, int>, double> limits_;
};

struct CollisionQuery {
  const PartSet* parts = nullptr;  // these are checked against the world, and against all other robot parts
  double margin = 0.01;            // [m]
  const Tolerances* tolerances = nullptr;
  bool self = true;
};

// Not thread-safe: keeps scratch memory for link poses. Bodies of the world keep the poses of the last
// update.
class CollisionChecker {
 public:
  CollisionChecker(const robot::RobotModel& model, const robot::Kinematics& kinematics,
                   const scene::Scene& scene);

  // Moves parts and objects to where they are perceived. Objects held (`held[arm]`) move with the tool
  // instead; what is in or on them is left out.
  void update(const WorldView& world, const std::vector<std::optional<HeldObject>>& held);
  // Moves one part of a fixture (and its children) as if its joint stood at `position`: opening a door in
  // thought.
  void pose_joint(const WorldView& world, const std::string& joint, double position);

  // Whether what stands on the robot's tray, and what is in or on that, moves along with the postures asked
  // about (the base drives), so that arms and furniture must keep clear of it where it is then; else it stays
  // in place.
  void ride_along(bool along);
  bool rides_along() const { return along_; }
  bool rides(const std::string& object) const;

  // Objects that are taken for gone, in thought, until this is called again; empty: none. For finding out
  // what is in the way.
  void leave_out(const std::vector<std::string>& objects);

  bool collides(const std::vector<double>& q, const CollisionQuery& query) const;
  // The first pair found, for messages: "left_hand touches Kettle"; empty if there is none.
  std::string explain(const std::vector<double>& q, const CollisionQuery& query) const;
  // All movable objects that the parts are too near to.
  std::vector<std::string> touched_objects(const std::vector<double>& q, const CollisionQuery& query) const;
  // Tolerances for everything that is nearer than the margin in this posture already: from a touch one may
  // come away, but not press on. Pairs nearer than `least` [m] get none: they stay collisions.
  Tolerances baseline(const std::vector<double>& q, const CollisionQuery& query, double least = -1.0) const;
  // Whether a hand with its tool frame at a pose, with fingers as in `q` and what it holds, would be too near
  // to anything in the world, whatever the arm does: `margin` and `tolerances` as in a query. What rides
  // along is left out.
  bool hand_collides(const std::vector<double>& q, std::size_t arm, const Pose& tool, double margin,
                     const Tolerances& tolerances) const;
  // What it would be too near to, for messages; empty: nothing.
  std::string hand_obstacle(const std::vector<double>& q, std::size_t arm, const Pose& tool, double margin,
                            const Tolerances& tolerances) const;
  // Whether an object at a pose would be nearer than `margin` to any other body; those named are ignored.
  bool object_fits(const std::string& object, const Pose& pose, double margin,
                   const std::vector<std::string>& ignored) const;

  // The same with regard to one other body only.
  bool object_clears(const std::string& object, const Pose& pose, const std::string& other,
                     double margin) const;

  int body(const std::string& name) const;  // -1: none of that name
  const PartSet& all_parts() const { return all_parts_; }
  const PartSet& arm_parts(std::size_t arm) const { return arm_parts_[arm]; }  // moving links and attachment
  const PartSet& hand_parts(std::size_t arm) const { return hand_parts_[arm]; }  // hand, fingers, attachment
  const PartSet& trunk_parts() const { return trunk_parts_; }                    // everything but the arms
  int attachment(std::size_t arm) const { return static_cast<int>(kinematics_.link_count() + arm); }

 private:
  // Distance that two parts of the robot must keep [m]. Links are modelled slightly fat already.
  static constexpr double kSelfMargin = 0.005;

  struct Body {
    std::string name;
    PlacedShape shape;
    bool present = true;
    bool riding = false;
    Pose pose = Pose::Identity(), on_tray = Pose::Identity();  // of what rides: map frame, tray's frame
    bool movable = false;
    bool left_out = false;
    bool counts() const { return present && !left_out; }
  };
  void place_robot(const std::vector<double>& q) const;
  std::string part_name(int part) const;
  void find_self_pairs();
  void find_riding(const WorldView& world);
  const PlacedShape& shape_of(int part) const;  // of a part, or, beyond those, of a body that rides
  template <class Visit>
  void visit_contacts(const std::vector<double>& q, const CollisionQuery& query, Visit&& visit) const;

  const robot::RobotModel& model_;
  const robot::Kinematics& kinematics_;
  const scene::Scene& scene_;
  mutable std::vector<Body> bodies_;  // what rides is placed as the parts are
  std::map<std::string, int> body_index_;
  int floor_ = -1;
  bool along_ = false;
  std::vector<int> riding_;                           // bodies
  std::map<std::string, PlacedShape> object_shapes_;  // by model name, for attachments and fit tests
  mutable std::vector<PlacedShape> parts_;
  mutable std::vector<Pose> link_poses_;
  std::vector<std::optional<HeldObject>> held_;
  std::vector<int> tool_links_;
  std::vector<std::pair<int, int>> self_pairs_;
  PartSet all_parts_, trunk_parts_;
  std::vector<PartSet> arm_parts_, hand_parts_;
};

// While it lives the base moves, in thought, and what stands on the tray with it.
class RidingAlong {
 public:
  explicit RidingAlong(CollisionChecker& checker) : checker_(checker), before_(checker.rides_along()) {
    checker_.ride_along(true);
  }
  ~RidingAlong() { checker_.ride_along(before_); }
  RidingAlong(const RidingAlong&) = delete;
  RidingAlong& operator=(const RidingAlong&) = delete;

 private:
  CollisionChecker& checker_;
  const bool before_;
};

}  // namespace goalnet::manipulation
