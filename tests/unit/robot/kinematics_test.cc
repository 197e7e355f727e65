#include "components/robot/kinematics.h"

#include <random>

#include <gtest/gtest.h>
#include <kdl/treefksolverpos_recursive.hpp>

#include "components/robot/arm_kinematics.h"
#include "components/robot/kdl_tree.h"

namespace goalnet::robot {
namespace {

class KinematicsTest : public testing::Test {
 protected:
  KinematicsTest()
      : model_(load_robot(GOALNET_SOURCE_DIR "/config/robots/default.yaml").value()), tree_(model_) {}

  std::vector<double> random_configuration() {
    std::vector<double> q;
    for (const auto& joint : model_.joints) {
      const double low = std::max(joint.limits.lower, -3.0), high = std::min(joint.limits.upper, 3.0);
      q.push_back(std::uniform_real_distribution<double>(low, high)(random_));
    }
    return q;
  }
  ArmPositions of_arm(const ArmKinematics& arm, const std::vector<double>& q) {
    ArmPositions out;
    for (std::size_t i = 0; i < 7; ++i) out[i] = q[static_cast<std::size_t>(arm.joints()[i])];
    return out;
  }

  RobotModel model_;
  Kinematics tree_;
  std::mt19937 random_{7};
};

TEST_F(KinematicsTest, AgreesWithKdlOnEveryLink) {
  const KDL::Tree kdl = kdl_tree(model_);
  KDL::TreeFkSolverPos_recursive solver(kdl);
  ASSERT_EQ(kdl.getNrOfJoints(), model_.joints.size());
  for (int trial = 0; trial < 20; ++trial) {
    const auto q = random_configuration();
    KDL::JntArray array(kdl.getNrOfJoints());
    for (const auto& [name, element] : kdl.getSegments()) {
      const int index = model_.index_of(element.segment.getJoint().getName());
      if (index >= 0) array(element.q_nr) = q[static_cast<std::size_t>(index)];
    }
    std::vector<Pose> poses;
    tree_.forward(q, poses);
    for (std::size_t i = 0; i < tree_.link_count(); ++i) {
      KDL::Frame frame;
      ASSERT_EQ(solver.JntToCart(array, frame, tree_.link_name(i)), 0);
      EXPECT_TRUE(poses[i].isApprox(from_kdl(frame), 1e-9)) << tree_.link_name(i);
      EXPECT_TRUE(poses[i].isApprox(tree_.forward(q, static_cast<int>(i)), 1e-12));
    }
  }
}

TEST_F(KinematicsTest, ClosedFormReachesEveryPoseItCameFrom) {
  for (const auto& arm : model_.arms) {
    const auto ik = ArmKinematics::create(model_, arm).value();
    ASSERT_TRUE(ik.closed_form());
    for (int trial = 0; trial < 200; ++trial) {
      const ArmPositions q = of_arm(ik, random_configuration());
      const Pose target = ik.forward(q);
      const auto solutions = ik.solve(target, q, 24, 0.0);
      ASSERT_FALSE(solutions.empty());
      EXPECT_LT(largest_step(solutions.front(), q), 1e-5);
      for (const auto& s : solutions) {
        EXPECT_TRUE(ik.forward(s).isApprox(target, 1e-6));
        for (std::size_t i = 0; i < 7; ++i) {
          EXPECT_GE(s[i], ik.lower()[i]);
          EXPECT_LE(s[i], ik.upper()[i]);
        }
      }
    }
  }
}

TEST_F(KinematicsTest, FollowsAStraightLineWithoutJumps) {
  const auto ik = ArmKinematics::create(model_, *model_.arm("left")).value();
  ArmPositions q = of_arm(ik, model_.home());
  Pose pose = ik.forward(q);
  for (int step = 0; step < 40; ++step) {
    pose.translation() += Eigen::Vector3d(0.003, 0.001, 0.002);
    const auto next = ik.follow(pose, q, 0.15);
    ASSERT_TRUE(next) << "step " << step;
    EXPECT_TRUE(ik.forward(*next).isApprox(pose, 1e-6));
    q = *next;
  }
}

TEST_F(KinematicsTest, OutOfReachHasNoSolution) {
  const auto ik = ArmKinematics::create(model_, *model_.arm("right")).value();
  Pose far = Pose::Identity();
  far.translation() = Eigen::Vector3d(2.0, 0, 0);
  EXPECT_TRUE(ik.solve(far, ArmPositions{}).empty());
  EXPECT_FALSE(ik.follow(far, ArmPositions{}, 10.0));
}

TEST_F(KinematicsTest, HandsMirrorEachOtherAtHome) {
  const auto q = model_.home();
  const Pose left = tree_.forward(q, tree_.link_index("left_tcp"));
  const Pose right = tree_.forward(q, tree_.link_index("right_tcp"));
  EXPECT_NEAR(left.translation().x(), right.translation().x(), 1e-9);
  EXPECT_NEAR(left.translation().y(), -right.translation().y(), 1e-9);
  EXPECT_NEAR(left.translation().z(), right.translation().z(), 1e-9);
}

}  // namespace
}  // namespace goalnet::robot
