#include "components/manipulation/put_ways.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/manipulation/phases.h"
#include "components/scene/fit.h"

namespace goalnet::manipulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kApproach = 0.10;   // [m] straight down from above
constexpr double kThrough = 0.0008;  // [m] that it must have from everything on its way down

Pose turned(const Vector3d& at, double heading) {
  Pose pose = Pose::Identity();
  pose.linear() = AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = at;
  return pose;
}

void add_descent(std::vector<PutWay>& ways, const Pose& end, double preference, double gap,
                 double height = kApproach) {
  ways.push_back({{moved(end, {0, 0, height}), end}, gap, preference});
}

// Upright on the floor of a plate, or on its rim if the thing is wider.
void lay(std::vector<PutWay>& ways, const Workbench& bench, const std::string& object, const Pose& mouth,
         const scene::Cavity& cavity) {
  const auto& model = *bench.scene().find_model_of(object);
  const double slack = std::max(0.0, 0.8 * cavity.radius - scene::girth(model));
  for (const double share : {0.0, 0.6}) {
    for (int direction = 0; direction < (share > 0 && slack > 0.01 ? 6 : 1); ++direction) {
      const double angle = direction * std::numbers::pi / 3;
      Vector3d at = mouth * Vector3d(share * slack * std::cos(angle), share * slack * std::sin(angle),
                                     -cavity.depth + 0.004);
      const double floor = at.z();
      while (at.z() < floor + cavity.depth && !bench.checker().object_fits(object, turned(at, 0), -0.001, {}))
        at.z() += 0.003;
      // Fingers that reach below the thing's rim are in the way when it sits in another of its kind: let go a
      // little higher.
      for (const double higher : {0.0, 0.012})
        for (int h = 0; h < 12; ++h)
          add_descent(ways, moved(turned(at, h * std::numbers::pi / 6), {0, 0, higher}),
                      share + 50.0 * higher, -0.001);
    }
  }
}

// Through a mouth: in its middle or beside (under a kettle's handle there is no middle), as low as the hand
// gets. All the way down must be free.
void drop(std::vector<PutWay>& ways, const Workbench& bench, const std::string& object, const Pose& mouth,
          const scene::Cavity& cavity) {
  const double slack = cavity.radius - scene::girth(*bench.scene().find_model_of(object)) - scene::kPlay;
  const double yaw = std::atan2(mouth.linear()(1, 0), mouth.linear()(0, 0));
  for (const double share : {0.0, 0.6, 1.15, 1.35}) {
    for (int direction = 0; direction < (share == 0 ? 1 : 8); ++direction) {
      const double angle = direction * std::numbers::pi / 4;
      for (int h = 0; h < 12; ++h) {
        Vector3d at(share * slack * std::cos(angle), share * slack * std::sin(angle), 0);
        const auto pose_at = [&](double depth) {
          at.z() = depth;
          return turned(mouth * at, yaw + h * std::numbers::pi / 6);
        };
        const auto fits = [&](double depth) {
          return bench.checker().object_fits(object, pose_at(depth), kThrough, {});
        };
        const double deepest = std::max(-0.06, 0.01 - cavity.depth);
        double free = deepest;  // everything below is
        if (!fits(deepest)) continue;
        while (free < 0.11 && fits(free + 0.01)) free += 0.01;
        for (const double depth : {deepest, 0.008, 0.05, 0.11}) {
          if (depth <= free + 1e-6)
            add_descent(ways, pose_at(depth), share + 4.0 * std::abs(depth - 0.008), 0.003);
        }
      }
    }
  }
}

// A long thing's far end (+x) goes in first and leans on the edge when it is let go.
void stand_in(std::vector<PutWay>& ways, const scene::ObjectModel& model, const Pose& mouth,
              const scene::Cavity& cavity) {
  const auto box = scene::bounds(model.shapes);
  const Vector3d tip(box.upper.x(), 0, 0.5 * (box.lower.z() + box.upper.z()));
  for (const double lean : {1.5, 1.2, 1.0, 0.8, 0.6}) {  // [rad] below level
    // Flat in a plate the tip lies far across, so that the handle rests on the near edge.
    const double across = 0.6 * cavity.radius * std::cos(lean);
    // The last ones end just inside the mouth, beside what spans it.
    for (const auto& [share, beside] :
         {std::pair{0.85, 0.0}, {0.5, 0.0}, {0.35, 0.0}, {0.1, 0.6}, {0.1, -0.6}}) {
      for (int h = 0; h < 16; ++h) {
        const double heading = h * std::numbers::pi / 8;
        const Vector3d ahead(std::cos(heading), std::sin(heading), 0);
        const Vector3d at = across * ahead + beside * cavity.radius * Vector3d(-ahead.y(), ahead.x(), 0);
        const double above = beside == 0.0 ? 0.06 : 0.16;
        const auto pose_at = [&](double down, double height) {
          Pose pose = Pose::Identity();
          pose.linear() = (AngleAxisd(heading, Vector3d::UnitZ()) * AngleAxisd(down, Vector3d::UnitY()))
                              .toRotationMatrix();
          pose.translation() = mouth.translation() + at + Vector3d(0, 0, height) - pose.linear() * tip;
          return pose;
        };
        PutWay way;
        // On the way there it must not lean more than things carried may.
        way.object = {pose_at(std::min(lean, 0.6), above), pose_at(lean, above),
                      pose_at(lean, -share * cavity.depth)};
        way.gap = -0.001;
        // Steep into deep things, flat into shallow ones.
        const double best = cavity.depth > 0.5 * cavity.radius ? 1.2 : 0.6;
        way.preference = std::abs(lean - best) + 2.0 * (0.85 - share);
        ways.push_back(std::move(way));
      }
    }
  }
}

// Along a slot: the thing's thickness (y) across it, either way round; upright, or, because a hand holds its
// foot, with another of its edges down.
void slide(std::vector<PutWay>& ways, const scene::ObjectModel& model, const Pose& mouth,
           const scene::Cavity& cavity) {
  const auto box = scene::bounds(model.shapes);
  const Vector3d middle = 0.5 * (box.lower + box.upper), size = box.upper - box.lower;
  for (const int quarters : {0, 2, 1, 3}) {
    const bool lies = quarters % 2 == 1;
    if ((lies ? size.z() : size.x()) > 2 * cavity.radius) continue;
    Pose turn = Pose::Identity();
    if (quarters != 0) {
      turn.linear() = AngleAxisd(quarters * std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
      turn.translation() = Vector3d(0, 0, (lies ? size.x() : size.z()) / 2) - turn.linear() * middle;
    }
    for (const double heading : {0.0, std::numbers::pi}) {
      const Pose end = mouth * Eigen::Translation3d(0, 0, 0.002 - cavity.depth) *
                       AngleAxisd(heading, Vector3d::UnitZ()) * turn;
      add_descent(ways, end, 0.5 * (quarters > 0) + 0.5 * lies, 0.0005, cavity.depth + 0.03);
    }
  }
}

}  // namespace

Expected<std::vector<PutWay>> put_ways(const Workbench& bench, const std::string& object,
                                       const std::string& receiver, const Pose& pose) {
  const auto* model = bench.scene().find_model_of(object);
  const auto* holder = bench.scene().find_model_of(receiver);
  if (model == nullptr || holder == nullptr || !holder->cavity)
    return fail(Outcome::kNoPlan, receiver + " has no opening to put something into");
  const scene::Cavity& cavity = *holder->cavity;
  const Pose mouth = pose * cavity.mouth;
  if (mouth.linear()(2, 2) < 0.9) return fail(Outcome::kMotionFailed, receiver + " does not stand upright");
  if (!scene::goes_through(*model, cavity))
    return fail(Outcome::kNoPlan, object + " does not fit through the opening of " + receiver);
  std::vector<PutWay> ways;
  if (cavity.slot) {
    slide(ways, *model, mouth, cavity);
  } else if (model->has_property("IsPlacable")) {
    stand_in(ways, *model, mouth, cavity);
  } else if (cavity.shallow()) {
    lay(ways, bench, object, mouth, cavity);
  } else {
    drop(ways, bench, object, mouth, cavity);
  }
  // What stands around may be in the way: no use in asking the arm.
  std::erase_if(ways, [&](const PutWay& way) {
    return !bench.checker().object_fits(object, way.object.front(), bench.params().margin, {}) ||
           !bench.checker().object_fits(object, way.object.back(), way.gap, {});
  });
  return ways;
}

}  // namespace goalnet::manipulation
