#include "components/manipulation/in_the_way.h"

#include <algorithm>

namespace goalnet::manipulation {
namespace {

constexpr std::size_t kFew[] = {1, 3};     // things to put aside: rather one
constexpr std::size_t kMostTries = 2'500;  // of the search with things away
constexpr double kBesideTrunk = 0.05;      // [m] as where stands are looked for

std::vector<std::string> may_go(const Workbench& bench) {
  std::vector<std::string> names;
  for (const auto& object : bench.scene().objects) {
    if (!bench.staying().contains(object.name) && !bench.arm_holding(object.name) &&
        !bench.checker().rides(object.name))
      names.push_back(object.name);
  }
  return names;
}

// What the robot would touch on its way, things as they are.
std::vector<std::string> touched(const Workbench& bench, const Configuration& start, const Reach& reach,
                                 const std::vector<ArmPositions>& along) {
  const CollisionChecker& checker = bench.checker();
  std::vector<std::string> names;
  const auto look = [&](const Configuration& q, const CollisionQuery& query) {
    for (std::string& name : checker.touched_objects(q, query))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  };
  look(start, {&checker.trunk_parts(), kBesideTrunk, nullptr, false});
  for (std::size_t i = 0; i < along.size(); ++i) {
    const bool first = i == 0;
    look(bench.with_arm(start, reach.arm, along[i]),
         {&checker.arm_parts(reach.arm), first ? bench.params().margin : bench.params().contact_margin,
          first ? nullptr : &reach.tolerances, false});
  }
  return names;
}

}  // namespace

ThingsAway::ThingsAway(Workbench& bench) : checker_(bench.checker()) { checker_.leave_out(may_go(bench)); }
ThingsAway::~ThingsAway() { checker_.leave_out({}); }

std::optional<InTheWay> find_in_the_way(Workbench& bench, const std::vector<Reach>& reaches,
                                        const StandSearchOptions& options) {
  if (bench.supposes() || reaches.empty()) return std::nullopt;
  const std::vector<std::string> away = may_go(bench);
  if (away.empty()) return std::nullopt;
  std::optional<InTheWay> found;
  StandSearchOptions search = options;
  search.most_tries = std::min(options.most_tries, kMostTries);
  for (const std::size_t few : kFew) {
    search.accept = [&](const Configuration& start, const Reach& reach, const auto& along) {
      if (options.accept && !options.accept(start, reach, along)) return false;
      bench.checker().leave_out({});
      auto names = touched(bench, start, reach, along);
      bench.checker().leave_out(away);
      const bool fits = !names.empty() && names.size() <= few &&
                        std::all_of(names.begin(), names.end(), [&](const std::string& name) {
                          return std::find(away.begin(), away.end(), name) != away.end();
                        });
      if (fits) found = InTheWay{std::move(names), reach.tool.back().translation()};
      return fits;
    };
    const ThingsAway scope(bench);
    if (find_stand(bench, reaches, search)) return found;
    if (bench.stopped()) break;
  }
  return std::nullopt;
}

}  // namespace goalnet::manipulation
