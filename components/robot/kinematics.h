// Where every link is for given joint positions. Plain tree walk over the urdfdom parse: planning calls it
// thousands of times per action. kdl_tree.h gives the same tree to KDL; a test holds the two together.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "components/robot/robot_model.h"

namespace goalnet::robot {

using Pose = Eigen::Isometry3d;

// Converts a urdfdom pose.
Pose to_pose(const urdf::Pose& pose);

// Immutable after construction; safe to read from several threads.
class Kinematics {
 public:
  explicit Kinematics(const RobotModel& model);

  std::size_t joint_count() const { return joint_count_; }
  std::size_t link_count() const { return links_.size(); }
  const std::string& link_name(std::size_t i) const { return links_[i].name; }
  // Index of a link, -1 if the robot has none of that name. Parents come before their children.
  int link_index(const std::string& name) const;
  int parent_of(std::size_t link) const { return links_[link].parent; }
  // Index in RobotModel::joints of the joint that moves this link against its parent; -1 if fixed.
  int joint_of(std::size_t link) const { return links_[link].joint; }

  // Poses of all links in the frame of the root link; q in the order of RobotModel::joints [rad, m].
  // `poses` is resized once and then reused without allocation.
  void forward(const std::vector<double>& q, std::vector<Pose>& poses) const;
  Pose forward(const std::vector<double>& q, int link) const;

 private:
  struct Link {
    std::string name;
    int parent = -1;
    int joint = -1;
    bool prismatic = false;
    Pose origin = Pose::Identity();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  };
  Pose local(const Link& link, const std::vector<double>& q) const;

  std::vector<Link> links_;
  std::size_t joint_count_ = 0;
};

}  // namespace goalnet::robot
