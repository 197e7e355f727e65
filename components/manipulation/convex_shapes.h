// Convex pieces and the distance between them: Bullet's GJK and EPA on the primitives of robot and scene.
#pragma once

#include <memory>
#include <vector>

#include <LinearMath/btTransform.h>
#include <Eigen/Geometry>

#include "components/robot/kinematics.h"
#include "components/scene/shape.h"

class btConvexShape;

namespace goalnet::manipulation {

using robot::Pose;

// One convex solid in the frame of its owner.
struct Piece {
  std::shared_ptr<btConvexShape> shape;
  Pose pose = Pose::Identity();
};

std::vector<Piece> pieces_of(const std::vector<scene::Shape>& shapes);  // leaves out what is not solid
std::vector<Piece> pieces_of(const urdf::Link& link);                   // its collision geometry

// Pieces placed in the world, with bounds, ready for queries.
class PlacedShape {
 public:
  PlacedShape() = default;
  explicit PlacedShape(std::vector<Piece> pieces);
  void place(const Pose& owner);
  bool empty() const { return pieces_.empty(); }
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  // Whether any two pieces are nearer than `distance` [m]; negative distances allow overlap of that depth.
  friend bool nearer_than(const PlacedShape& a, const PlacedShape& b, double distance);
  // Smallest distance [m], at most `cutoff`; negative when they overlap.
  friend double distance_between(const PlacedShape& a, const PlacedShape& b, double cutoff);

 private:
  std::vector<Piece> pieces_;
  std::vector<btTransform> transforms_;
  std::vector<Eigen::AlignedBox3d> piece_bounds_;
  Eigen::AlignedBox3d bounds_;
};

bool nearer_than(const PlacedShape& a, const PlacedShape& b, double distance);
double distance_between(const PlacedShape& a, const PlacedShape& b, double cutoff);

}  // namespace goalnet::manipulation
