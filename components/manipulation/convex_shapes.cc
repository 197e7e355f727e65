#include "components/manipulation/convex_shapes.h"

#include <algorithm>

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

namespace goalnet::manipulation {
namespace {

btTransform to_bullet(const Pose& pose) {
  const auto& r = pose.linear();
  const auto& p = pose.translation();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      btVector3(p.x(), p.y(), p.z()));
}

std::shared_ptr<btConvexShape> box(double x, double y, double z) {
  return std::make_shared<btBoxShape>(btVector3(x / 2, y / 2, z / 2));
}

std::shared_ptr<btConvexShape> cylinder(double radius, double length) {
  return std::make_shared<btCylinderShapeZ>(btVector3(radius, radius, length / 2));
}

// Distance of two convex solids if it is below `cutoff`, else `cutoff`.
double distance(const btConvexShape& a, const btTransform& ta, const btConvexShape& b, const btTransform& tb,
                double cutoff) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;
  btGjkPairDetector detector(&a, &b, &simplex, &penetration);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = ta;
  input.m_transformB = tb;
  const double reach = std::max(cutoff, 0.0) + a.getMargin() + b.getMargin();
  input.m_maximumDistanceSquared = reach * reach;
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  return result.m_hasResult ? std::min<double>(result.m_distance, cutoff) : cutoff;
}

bool apart(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double gap) {
  return ((a.min().array() - gap) > b.max().array()).any() ||
         ((b.min().array() - gap) > a.max().array()).any();
}

}  // namespace

std::vector<Piece> pieces_of(const std::vector<scene::Shape>& shapes) {
  std::vector<Piece> pieces;
  for (const auto& shape : shapes) {
    if (!shape.solid) continue;
    switch (shape.kind) {
      case scene::ShapeKind::kBox:
        pieces.push_back({box(shape.size.x(), shape.size.y(), shape.size.z()), shape.pose});
        break;
      case scene::ShapeKind::kCylinder:
        pieces.push_back({cylinder(shape.size.x(), shape.size.z()), shape.pose});
        break;
      case scene::ShapeKind::kSphere:
        pieces.push_back({std::make_shared<btSphereShape>(shape.size.x()), shape.pose});
        break;
    }
  }
  return pieces;
}

std::vector<Piece> pieces_of(const urdf::Link& link) {
  std::vector<Piece> pieces;
  for (const auto& collision : link.collision_array) {
    if (!collision || !collision->geometry) continue;
    const Pose pose = robot::to_pose(collision->origin);
    if (const auto b = std::dynamic_pointer_cast<urdf::Box>(collision->geometry)) {
      pieces.push_back({box(b->dim.x, b->dim.y, b->dim.z), pose});
    } else if (const auto c = std::dynamic_pointer_cast<urdf::Cylinder>(collision->geometry)) {
      pieces.push_back({cylinder(c->radius, c->length), pose});
    } else if (const auto s = std::dynamic_pointer_cast<urdf::Sphere>(collision->geometry)) {
      pieces.push_back({std::make_shared<btSphereShape>(s->radius), pose});
    }
  }
  return pieces;
}

PlacedShape::PlacedShape(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  transforms_.resize(pieces_.size());
  piece_bounds_.resize(pieces_.size());
  place(Pose::Identity());
}

void PlacedShape::place(const Pose& owner) {
  bounds_.setEmpty();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    transforms_[i] = to_bullet(owner * pieces_[i].pose);
    btVector3 low, high;
    pieces_[i].shape->getAabb(transforms_[i], low, high);
    piece_bounds_[i] = Eigen::AlignedBox3d(Eigen::Vector3d(low.x(), low.y(), low.z()),
                                           Eigen::Vector3d(high.x(), high.y(), high.z()));
    bounds_.extend(piece_bounds_[i]);
  }
}

double distance_between(const PlacedShape& a, const PlacedShape& b, double cutoff) {
  const double gap = std::max(cutoff, 0.0);
  if (a.empty() || b.empty() || apart(a.bounds_, b.bounds_, gap)) return cutoff;
  double least = cutoff;
  for (std::size_t i = 0; i < a.pieces_.size(); ++i) {
    if (apart(a.piece_bounds_[i], b.bounds_, gap)) continue;
    for (std::size_t j = 0; j < b.pieces_.size(); ++j) {
      if (apart(a.piece_bounds_[i], b.piece_bounds_[j], gap)) continue;
      least = std::min(least, distance(*a.pieces_[i].shape, a.transforms_[i], *b.pieces_[j].shape,
                                       b.transforms_[j], least));
    }
  }
  return least;
}

bool nearer_than(const PlacedShape& a, const PlacedShape& b, double limit) {
  const double gap = std::max(limit, 0.0);
  if (a.empty() || b.empty() || apart(a.bounds_, b.bounds_, gap)) return false;
  for (std::size_t i = 0; i < a.pieces_.size(); ++i) {
    if (apart(a.piece_bounds_[i], b.bounds_, gap)) continue;
    for (std::size_t j = 0; j < b.pieces_.size(); ++j) {
      if (apart(a.piece_bounds_[i], b.piece_bounds_[j], gap)) continue;
      // With a negative limit the exact depth counts, so the cutoff must lie above it.
      if (distance(*a.pieces_[i].shape, a.transforms_[i], *b.pieces_[j].shape, b.transforms_[j],
                   std::max(limit, 0.0) + 1e-4) < limit) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace goalnet::manipulation
