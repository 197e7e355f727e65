#include "components/manipulation/joint_path.h"

#include <algorithm>
#include <cmath>

namespace goalnet::manipulation {
namespace {

void append_line(JointPath& out, const JointVector& to, const JointVector& scale, double spacing) {
  const JointVector from = out.back();
  const int steps = std::max(1, static_cast<int>(std::ceil(scaled_distance(from, to, scale) / spacing)));
  if (scaled_distance(from, to, scale) < 1e-9) return;
  for (int i = 1; i <= steps; ++i) out.push_back(from + (to - from) * (static_cast<double>(i) / steps));
}

JointVector parabola(const JointVector& a, const JointVector& corner, const JointVector& b, double u) {
  return (1 - u) * (1 - u) * a + 2 * u * (1 - u) * corner + u * u * b;
}

}  // namespace

double scaled_distance(const JointVector& a, const JointVector& b, const JointVector& scale) {
  return ((a - b).cwiseAbs().cwiseProduct(scale)).maxCoeff();
}

JointPath round_corners(const JointPath& corners, const JointVector& scale, double reach, double spacing,
                        const IsFree& is_free) {
  if (corners.size() < 2) return corners;
  JointPath out{corners.front()};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const JointVector& corner = corners[i];
    const double before = scaled_distance(corners[i - 1], corner, scale);
    const double after = scaled_distance(corner, corners[i + 1], scale);
    if (before < 1e-9 || after < 1e-9) continue;
    double r = std::min({reach, before / 2, after / 2});
    JointVector a, b;
    int steps = 0;
    for (int attempt = 0; attempt < 5; ++attempt, r /= 2) {
      a = corner + (corners[i - 1] - corner) * (r / before);
      b = corner + (corners[i + 1] - corner) * (r / after);
      steps = std::max(6, static_cast<int>(std::ceil(2 * r / spacing)));
      bool free = true;
      for (int k = 1; k < steps && free; k += 2) {
        free = is_free(parabola(a, corner, b, static_cast<double>(k) / steps));
      }
      if (free) break;
      steps = 0;
    }
    if (steps == 0) {  // no room: straight through the corner, nearly stopping there
      append_line(out, corner, scale, spacing);
      continue;
    }
    append_line(out, a, scale, spacing);
    for (int k = 1; k <= steps; ++k) out.push_back(parabola(a, corner, b, static_cast<double>(k) / steps));
  }
  append_line(out, corners.back(), scale, spacing);
  return out;
}

bool turns_sharply(const JointVector& before, const JointVector& at, const JointVector& after,
                   const JointVector& scale) {
  const JointVector in = (at - before).cwiseProduct(scale), out = (after - at).cwiseProduct(scale);
  return in.dot(out) < 0.5 * in.norm() * out.norm();  // 60 degrees
}

namespace {

// The curve between sharp corners; `points` are distinct.
void append_curve(JointPath& out, const JointPath& points, const JointVector& scale, double spacing) {
  const auto at = [&](std::ptrdiff_t i) -> JointVector {
    if (i < 0) return 2 * points[0] - points[1];
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    if (i >= n) return 2 * points[points.size() - 1] - points[points.size() - 2];
    return points[static_cast<std::size_t>(i)];
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto k = static_cast<std::ptrdiff_t>(i);
    const JointVector p0 = at(k - 1), p1 = at(k), p2 = at(k + 1), p3 = at(k + 2);
    const auto knot = [&](const JointVector& a, const JointVector& b) {
      return std::sqrt(std::max(1e-9, scaled_distance(a, b, scale)));
    };
    const double t1 = knot(p0, p1), t2 = knot(p1, p2), t3 = knot(p2, p3);
    const JointVector m1 = t2 * ((p1 - p0) / t1 - (p2 - p0) / (t1 + t2)) + (p2 - p1);
    const JointVector m2 = t2 * ((p3 - p2) / t3 - (p3 - p1) / (t2 + t3)) + (p2 - p1);
    const int steps = std::max(2, static_cast<int>(std::ceil(scaled_distance(p1, p2, scale) / spacing)));
    for (int s = 1; s <= steps; ++s) {
      const double u = static_cast<double>(s) / steps, u2 = u * u, u3 = u2 * u;
      out.push_back((2 * u3 - 3 * u2 + 1) * p1 + (u3 - 2 * u2 + u) * m1 + (-2 * u3 + 3 * u2) * p2 +
                    (u3 - u2) * m2);
    }
  }
}

}  // namespace

JointPath through_points(const JointPath& given, const JointVector& scale, double spacing) {
  JointPath points;
  for (const auto& p : given) {
    if (points.empty() || scaled_distance(points.back(), p, scale) > 1e-6) points.push_back(p);
  }
  if (points.size() < 2) return points;
  JointPath out{points.front()}, piece{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    piece.push_back(points[i]);
    if (i + 1 < points.size() && !turns_sharply(points[i - 1], points[i], points[i + 1], scale)) continue;
    append_curve(out, piece, scale, spacing);
    piece = {points[i]};
  }
  return out;
}

}  // namespace goalnet::manipulation
