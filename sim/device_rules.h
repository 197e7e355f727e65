// Devices as a thin symbolic layer over physics: reads joint positions and poses, keeps (state …) facts.
// Pure.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "components/scene/scene.h"

namespace goalnet::sim {

// A finger that presses on a movable thing.
struct Touch {
  std::size_t object = 0;                           // in Scene::objects
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // [m] middle of the contact, in the object's frame
  double force = 0;                                 // [N] towards the object's -z
};

// What the rules look at, once per evaluation.
struct DeviceInput {
  std::function<double(const std::string& joint)> joint;  // fixture joint positions [rad or m]
  std::vector<scene::Pose> objects;                       // in the order of Scene::objects, map frame
  std::vector<bool> held;                                 // in a gripper
  std::vector<Touch> touches;                             // of fingers; at most one for each object
  std::vector<int> hands;                                 // how many grippers press it between their pads
};

class DeviceRules {
 public:
  explicit DeviceRules(const scene::Scene& scene);

  // Applies all rules for `dt` seconds that passed.
  void update(const DeviceInput& input, double dt);

  const FactSet& facts() const { return facts_; }
  void set_fact(const Predicate& fact, bool holds);
  // A dead device: facts of this subject do not change any more.
  void disable(const std::string& subject, bool dead);

 private:
  bool holds(const std::vector<Predicate>& when, const std::vector<Predicate>& unless = {}) const;
  void set(const std::string& subject, const std::string& value, bool holds);
  // Runs the clock of a rule for a key; true once when `after` is reached, and again only after a pause.
  bool elapsed(std::uint64_t key, bool active, double after, double dt);

  void update_joint_facts(const DeviceInput& input);
  void update_buttons(const DeviceInput& input);
  void press(const scene::ButtonRule& rule);
  void update_fills(const DeviceInput& input, double dt);
  void update_regions(const DeviceInput& input, double dt);
  void update_contacts(const DeviceInput& input, double dt);
  void update_tears(const DeviceInput& input, double dt);
  void update_spills(const DeviceInput& input, double dt);
  bool gives(const scene::ContactRule& rule, const DeviceInput& input, std::size_t giver) const;
  // Whether what is given gets into the receiver; `point`: of the giver, that must lie in the hollow.
  bool reaches(const scene::ContactRule& rule, const DeviceInput& input, std::size_t giver,
               const Eigen::Vector3d& point, std::size_t receiver) const;
  void transfer(const scene::ContactRule& rule, const std::string& giver, const std::string& receiver);

  const scene::Scene* scene_;
  FactSet facts_;
  // Where a button is: pressed, let go, or between.
  enum class Button { kReleased, kBetween, kPressed };
  Button state_of(const scene::ButtonRule& rule, const DeviceInput& input) const;
  std::map<std::string, bool> armed_;       // buttons, by joint or spot: released since the last press
  std::map<std::uint64_t, double> clocks_;  // seconds a rule has been active, by key; negative: done
  std::set<std::string> dead_;
};

}  // namespace goalnet::sim
