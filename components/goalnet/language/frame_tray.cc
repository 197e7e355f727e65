// What the robot carries on its tray.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr std::size_t kMostOnTray = 4;  // as config/domains/household.pddl counts (TrayHolds)

}  // namespace

// "put both cds on your tray": held there, not in a hand.
std::string FrameActions::put_on_tray(const Clause& clause) {
  if (tray_ == kNone) return not_here("there is no tray here");
  Clause moved = clause;
  moved.particles.clear();
  Problem problem;
  const Objects objects = direct(moved, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  if (objects.size() > kMostOnTray)
    return "those are " + std::to_string(objects.size()) + " things; the tray takes " +
           std::to_string(kMostOnTray);
  for (const Symbol object : objects) {
    taken_.push_back(object);
    if (!now_.holds(object)) {
      if (problem = act({Verb::kGrasp, object}); !problem.empty()) return problem;
    } else {
      macros_.push_back({Verb::kGrasp, object});
      steps_.emplace_back();
    }
    auto& added = steps_.back().added;  // sorted
    added.push_back(sym_fact(Relation::kHeld, object, tray_));
    std::sort(added.begin(), added.end());
  }
  return {};
}

}  // namespace goalnet::inference
