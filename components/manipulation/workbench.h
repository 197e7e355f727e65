// The tools of the trade, put together for one robot in one scene: where everything is now, what the hands
// hold, and motions that do not collide. Skills (skills.h) are written in terms of this.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "components/manipulation/collision_checker.h"
#include "components/manipulation/manipulation_params.h"
#include "components/manipulation/path_planner.h"
#include "components/manipulation/trajectory_timing.h"
#include "components/manipulation/tried_ways.h"
#include "components/manipulation/world_view.h"
#include "components/robot/arm_kinematics.h"
#include "components/robot/robot_model.h"
#include "components/scene/scene.h"

namespace goalnet::manipulation {

using robot::ArmPositions;
using Configuration = std::vector<double>;  // all joints, order of RobotModel::joints

// Where the robot stands: pose of the base in the map frame [m, rad] and height of the lift [m].
struct Stand {
  double x = 0, y = 0, yaw = 0, lift = 0;
};

// Where the way ended in this action: the base could not get to `stand`, or, with a posture, the arm not into
// it there.
struct DeadEnd {
  Stand stand;
  std::optional<std::size_t> arm;  // empty: the base
  ArmPositions posture{};          // [rad]
};

// What has to be put aside before a hand gets at what it should do, and where that is.
struct InTheWay {
  std::vector<std::string> things;                  // movable objects; never empty
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // map frame [m]: keep this clear
};

// Belongs to one thread. Deterministic: the same calls give the same motions.
class Workbench {
 public:
  static Expected<std::unique_ptr<Workbench>> create(robot::RobotModel model, scene::Scene scene,
                                                     ManipulationParams params);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  // Takes in what is perceived now. Objects in hands are followed by where they really are.
  void observe(const WorldView& world);

  // The configuration that motions start from: as commanded, fingers as measured.
  const Configuration& now() const { return now_; }
  const WorldView& world() const { return world_; }
  const robot::RobotModel& model() const { return model_; }
  const robot::Kinematics& kinematics() const { return kinematics_; }
  const scene::Scene& scene() const { return scene_; }
  const ManipulationParams& params() const { return params_; }
  CollisionChecker& checker() { return checker_; }
  const CollisionChecker& checker() const { return checker_; }
  const robot::ArmKinematics& arm(std::size_t i) const { return arms_[i]; }
  std::size_t arm_count() const { return arms_.size(); }

  // What the hands hold. Set by skills when fingers have closed or opened, and from (Held X LeftHand) facts.
  const std::vector<std::optional<HeldObject>>& held() const { return held_; }
  void set_held(std::size_t arm, const std::optional<std::string>& object);
  std::optional<std::size_t> arm_holding(const std::string& object) const;
  // Supposes that an arm holds what it holds in another way, until the end of the supposition; searches in
  // vain give up ten times as soon meanwhile.
  void suppose_grip(std::size_t arm, const Pose& object_in_tool);
  // Supposes, in a search that goes on, that an arm has closed on a thing.
  void suppose_held(std::size_t arm, const std::string& object, const Pose& object_in_tool);
  // Supposes that what an arm holds, and what is in or on that, has been put down out of the way.
  void suppose_put_down(std::size_t arm);
  // Ends the last of them: one may be made within another.
  void end_supposition();
  bool supposes() const { return !before_.empty(); }

  // Positions that were last commanded; the runner reports the end of every motion. Empty: as measured.
  void set_command(const std::vector<std::string>& joints, const std::vector<double>& positions);
  void forget_command() { command_.clear(); }

  // What was found out on the way since the action began, or since those before it that failed: find_stand()
  // looks elsewhere.
  void note_dead_end(const DeadEnd& end) { dead_ends_.push_back(end); }
  void set_dead_ends(std::vector<DeadEnd> ends) { dead_ends_ = std::move(ends); }
  const std::vector<DeadEnd>& dead_ends() const { return dead_ends_; }
  // What earlier actions of the instruction tried in vain: add_way_there() tries other ways first.
  TriedWays& tried() { return tried_; }
  const TriedWays& tried() const { return tried_; }
  bool leads_nowhere(const Stand& stand) const;
  bool leads_nowhere(const Stand& stand, std::size_t arm, const ArmPositions& posture) const;

  // What was found to be in the way when a skill found no way; and what must not be moved for it.
  void note_in_the_way(std::optional<InTheWay> what) { in_the_way_ = std::move(what); }
  const std::optional<InTheWay>& in_the_way() const { return in_the_way_; }
  // A skill found no way because no hand was free for something that would have helped.
  void note_wants_hand(bool wants) { wants_hand_ = wants; }
  bool wants_hand() const { return wants_hand_; }
  void set_staying(std::set<std::string> things) { staying_ = std::move(things); }
  const std::set<std::string>& staying() const { return staying_; }

  // An arm that something kept from following its motion: tried last, and not waited for, until it has
  // completed a motion or the next instruction comes.
  void note_hindered(std::size_t arm, bool is) { hindered_[arm] = is; }
  bool hindered(std::size_t arm) const { return hindered_[arm]; }
  void forget_hindrances() { hindered_.assign(hindered_.size(), false); }

  void set_stop_check(std::function<bool()> stopped) { stopped_ = std::move(stopped); }
  bool stopped() const { return stopped_ && stopped_(); }

  // --- configurations ---
  Stand stand_of(const Configuration& q) const;
  Configuration with_stand(Configuration q, const Stand& stand) const;
  ArmPositions arm_of(const Configuration& q, std::size_t arm) const;
  Configuration with_arm(Configuration q, std::size_t arm, const ArmPositions& positions) const;
  Configuration with_fingers(Configuration q, std::size_t arm, double opening) const;
  Pose tool_pose(const Configuration& q, std::size_t arm) const;
  Pose arm_base_pose(const Configuration& q, std::size_t arm) const;
  double opening_of(const Configuration& q, std::size_t arm) const;  // [m] between the fingers
  double shoulder_side(std::size_t arm) const {
    return sides_[arm];
  }  // [m] y of the shoulder in the base frame

  // --- motions; all start at now() ---
  // Arm (and lift) to a goal configuration, around obstacles. Held objects stay upright if they must.
  // `opening` [m]: that the fingers will have before the end, if it is wider than now; they are taken for
  // that wide all the way.
  Expected<JointTrajectory> move_arm(std::size_t arm, const ArmPositions& goal, double lift,
                                     double opening = 0.0, int iterations = PlannerLimits{}.iterations);
  // The tool along straight lines through poses in the map frame. Contacts within tolerances are allowed.
  Expected<JointTrajectory> move_straight(std::size_t arm, const std::vector<Pose>& poses,
                                          const Tolerances& tolerances, double speed = 1.0);
  // The base (and lift) to a stand; arms stay as they are.
  Expected<JointTrajectory> drive(const Stand& goal, int iterations = PlannerLimits{}.iterations);
  // The base straight by a distance [m] along a direction [rad, from its heading; pi: backwards], arms as
  // they are. Hands may pass as near to things as they are now: for coming out from between boards.
  Expected<JointTrajectory> slide(double direction, double distance);
  // Whether that would be free from a configuration.
  bool can_slide(const Configuration& from, double direction, double distance) const;
  // Fingers to an opening [m] between them.
  JointTrajectory move_fingers(std::size_t arm, double opening, double speed = 1.0) const;
  // Back to the posture of driving; whatever is held comes close to the chest.
  Expected<JointTrajectory> tuck(std::size_t arm, int iterations = PlannerLimits{}.iterations);
  // The posture of driving for what the arm holds now; nothing if there is none here.
  std::optional<ArmPositions> carry_posture(std::size_t arm) const;
  bool is_tucked(std::size_t arm) const;

  // Arm positions along straight lines from `start`, at a given stand; nothing if it cannot be followed or
  // collides.
  std::optional<std::vector<ArmPositions>> follow(const Configuration& q, std::size_t arm,
                                                  const ArmPositions& start, const std::vector<Pose>& poses,
                                                  const Tolerances& tolerances, double margin) const;
  // How far the up axis of what the arm holds may lean [rad]; pi: as it likes.
  double tilt_limit(std::size_t arm) const;

 private:
  Workbench(robot::RobotModel model, scene::Scene scene, ManipulationParams params);
  TimedJoints timed(const std::vector<int>& joints, double speed = 1.0) const;
  JointVector pick(const Configuration& q, const std::vector<int>& joints) const;
  std::optional<ArmPositions> empty_posture(std::size_t arm) const;
  bool contains_something(const std::string& vessel) const;
  bool upright(const Configuration& q, std::size_t arm, double limit) const;

  const robot::RobotModel model_;
  const scene::Scene scene_;
  const ManipulationParams params_;
  const robot::Kinematics kinematics_;
  CollisionChecker checker_;
  std::vector<robot::ArmKinematics> arms_;
  std::vector<int> tool_links_, arm_base_links_;
  std::vector<double> sides_;
  int base_x_ = -1, base_y_ = -1, base_yaw_ = -1, lift_ = -1;
  WorldView world_;
  Configuration now_;
  Configuration command_;
  std::vector<std::optional<HeldObject>> held_;
  struct Before {
    std::vector<std::optional<HeldObject>> held;
    bool leaves_out;  // things, in the checker
  };
  std::vector<Before> before_;                      // each supposition that goes on
  std::vector<std::optional<ArmPositions>> carry_;  // posture in which each arm was last tucked
  std::vector<DeadEnd> dead_ends_;
  TriedWays tried_;
  std::vector<bool> hindered_;  // by arm
  std::optional<InTheWay> in_the_way_;
  std::set<std::string> staying_;
  bool wants_hand_ = false;
  std::function<bool()> stopped_;
};

// Poses from one to another, at most `step` [m] and `turn` [rad] apart; the first one is left out.
std::vector<Pose> interpolate(const Pose& from, const Pose& to, double step = 0.02, double turn = 0.1);

// Angle between the z axis of a pose and up [rad].
double tilt_of(const Pose& pose);

}  // namespace goalnet::manipulation
