// Grippers hold things. A grasp forms only when both fingers really enclose a movable object: contacts on
// opposing pads with opposing normals, each finger pressing, for a while. From then on a constraint stands
// for the friction of the pads: it bears what their friction could bear and lets go when overloaded or when
// the fingers are told to open. Doors, knobs and buttons are never held that way; there contact and friction
// do the work.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>

#include "sim/movables.h"
#include "sim/robot_links.h"
#include "sim/robot_servo.h"

namespace goalnet::sim {

class Grasping {
 public:
  Grasping(Physics& physics, ArticulatedBody& robot, const RobotLinks& links, const robot::RobotModel& model,
           RobotServo& servo, Movables& movables, const WorldOptions& options);
  ~Grasping();

  // Once before each physics step.
  void update(double dt);

  std::size_t arm_count() const { return hands_.size(); }
  const std::string& arm(std::size_t i) const { return hands_[i].arm; }
  int held(std::size_t i) const { return hands_[i].object; }  // object index; -1: nothing
  double force(std::size_t i) const { return hands_[i].force; }
  void drop(std::size_t i);
  bool holds(std::size_t object) const;
  // How many hands hold the object or press it between their pads, as for a grasp.
  int hands_on(std::size_t object) const;

 private:
  struct Hand {
    std::string arm;
    std::size_t link = 0;                        // the link that carries the fingers
    std::vector<std::size_t> fingers;            // joints, and links of the same index
    scene::Pose grip = scene::Pose::Identity();  // point between the pads in the frame of `link`
    int candidate = -1;                          // object between the pads
    double enclosed_for = 0;                     // [s]
    int object = -1;
    std::unique_ptr<btMultiBodyFixedConstraint> constraint;
    double opening = 0;         // [m] sum of finger positions when the grasp formed
    double force = 0;           // [N] smoothed load
    double overloaded_for = 0;  // [s]
  };
  // The object between the pads of a hand, or -1.
  int enclosed(const Hand& hand) const;
  bool presses(const Hand& hand) const;
  void take(Hand& hand, int object);
  void watch(Hand& hand, double dt);
  void release(Hand& hand);
  double grip_force(const Hand& hand) const;

  Physics& physics_;
  ArticulatedBody& robot_;
  RobotServo& servo_;
  Movables& movables_;
  WorldOptions options_;
  std::vector<Hand> hands_;
};

}  // namespace goalnet::sim
