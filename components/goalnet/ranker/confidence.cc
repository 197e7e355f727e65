#include "components/goalnet/ranker/confidence.h"

#include <algorithm>

namespace goalnet::inference {

Confidence Confidence::fit(std::vector<Point> pairs) {
  constexpr std::size_t kPoints = 12;
  struct Group {
    double x = 0, y = 0, n = 0;
  };
  std::sort(pairs.begin(), pairs.end());
  std::vector<Group> groups(std::min(kPoints, pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Group& group = groups[i * groups.size() / pairs.size()];
    group.x += static_cast<double>(pairs[i].first), group.y += static_cast<double>(pairs[i].second),
        ++group.n;
  }
  // Neighbours in the wrong order become one (isotonic regression).
  std::vector<Group> rising;
  for (const Group& group : groups) {
    rising.push_back(group);
    while (rising.size() > 1) {
      Group& before = rising[rising.size() - 2];
      const Group& last = rising.back();
      if (before.y / before.n <= last.y / last.n) break;
      before = {before.x + last.x, before.y + last.y, before.n + last.n};
      rising.pop_back();
    }
  }
  std::vector<Point> points;
  for (const Group& group : rising)
    points.emplace_back(static_cast<float>(group.x / group.n), static_cast<float>(group.y / group.n));
  return Confidence(std::move(points));
}

float Confidence::operator()(float expected) const {
  if (points_.empty()) return std::clamp(expected, 0.0f, 1.0f);
  if (expected <= points_.front().first) return points_.front().second;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const auto& [x0, y0] = points_[i - 1];
    const auto& [x1, y1] = points_[i];
    if (expected <= x1) return x1 > x0 ? y0 + (y1 - y0) * (expected - x0) / (x1 - x0) : y1;
  }
  return points_.back().second;
}

}  // namespace goalnet::inference
