#include "components/manipulation/stand_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::manipulation {
namespace {

TEST(StandCandidates, AlsoStandWherePlacesLieApart) {
  const auto bench =
      Workbench::create(robot::load_robot("default").value(), scene::load_scene("kitchen").value(), {})
          .value();
  WorldView view;
  view.robot = bench->model().home();
  bench->observe(view);
  // A bin may be put down here, however it is turned, and, less gladly, in the far corner.
  const Eigen::Vector2d here(0.5, -1.2), there(-1.6, 1.4);
  std::vector<Reach> reaches;
  for (const auto& place : {here, there}) {
    for (int heading = 0; heading < 12; ++heading) {
      const double angle = heading * std::numbers::pi / 6;
      Reach reach;
      Pose tool = Pose::Identity();
      tool.translation() =
          Eigen::Vector3d(place.x() + 0.155 * std::cos(angle), place.y() + 0.155 * std::sin(angle), 0.35);
      reach.tool = {tool};
      reach.preference = (place - here).norm();
      reaches.push_back(reach);
    }
  }
  const auto stands = stand_candidates(*bench, reaches, {});
  const auto reach_it = [](const Eigen::Vector2d& place) {
    return [place](const StandCandidate& c) {
      return c.drives && std::hypot(c.stand.x - place.x(), c.stand.y - place.y()) < 0.9;
    };
  };
  EXPECT_TRUE(std::ranges::any_of(stands, reach_it(here)));
  EXPECT_TRUE(std::ranges::any_of(stands, reach_it(there)));
}

}  // namespace
}  // namespace goalnet::manipulation
