// What the expected agreement of a chosen run is worth: measured on runs for unseen demonstrations.
#pragma once

#include <utility>
#include <vector>

namespace goalnet::inference {

// A curve that never falls, straight between its points and level outside.
class Confidence {
 public:
  using Point = std::pair<float, float>;  // expected, mean SJI

  Confidence() = default;  // says what it is told
  explicit Confidence(std::vector<Point> points) : points_(std::move(points)) {}
  // From pairs of expected and reached; deterministic.
  static Confidence fit(std::vector<Point> pairs);

  float operator()(float expected) const;
  const std::vector<Point>& points() const { return points_; }

 private:
  std::vector<Point> points_;  // by expected, rising
};

}  // namespace goalnet::inference
