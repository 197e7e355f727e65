#include "tools/goalnet/physics_run.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "sim/world.h"
#include "tools/goalnet/lockstep_loop.h"
#include "tools/goalnet/physics_start.h"
#include "tools/goalnet/run_record.h"

namespace goalnet::tools {
namespace {

using inference::Demonstration;

constexpr double kRest = 1.0;  // [s] simulated, for things to come to rest

bool has_place(const FactSet& facts, const std::string& thing) {
  return std::any_of(facts.begin(), facts.end(),
                     [&](const Predicate& fact) { return is_place(fact) && fact.subject == thing; });
}

}  // namespace

const scene::Scene& scene_of(const Demonstration& demonstration, const std::vector<scene::Scene>& scenes) {
  const auto known = [&](const scene::Scene& scene) {
    return std::count_if(demonstration.states.front().facts.begin(), demonstration.states.front().facts.end(),
                         [&](const Predicate& fact) {
                           return std::binary_search(scene.symbols.begin(), scene.symbols.end(),
                                                     fact.subject);
                         });
  };
  return *std::max_element(scenes.begin(), scenes.end(),
                           [&](const scene::Scene& a, const scene::Scene& b) { return known(a) < known(b); });
}

std::string recorded_spelling(const Action& action) {
  // Recordings do not tell which way a knob was turned.
  static constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"turn-on", "turn"},    {"turn-off", "turn"}, {"press-on", "press"},
      {"press-off", "press"}, {"pour-out", "pour"}, {"place-utensil", "place"}};
  const auto& of = action.arguments;
  if (of.size() == 2 && action.name == "keep-on") return "keep " + of[0] + " On " + of[1];
  if (of.size() == 2 && action.name == "keep-in") return "keep " + of[0] + " In " + of[1];
  std::string text = action.name;
  for (const auto& [ours, theirs] : kNames)
    if (action.name == ours) text = theirs;
  for (const std::string& argument : of) text += " " + argument;
  return text;
}

inference::Scores score_physics(const Demonstration& demonstration, const FactSet& seen_before,
                                const FactSet& seen_after, const std::vector<Action>& actions) {
  const FactSet &first = demonstration.states.front().facts, &last = demonstration.states.back().facts;
  std::vector<Predicate> unsaid, near;
  for (const Predicate& fact : seen_before)
    if (is_place(fact) && !has_place(first, fact.subject)) unsaid.push_back(fact);
  for (const Predicate& fact : first)
    if (fact.relation == "Near") near.push_back(fact);
  const auto comparable = [&](const FactSet& seen) {
    std::vector<Predicate> facts = near;
    for (const Predicate& fact : seen)
      if (is_place(fact) || fact.relation == "Grasping" || fact.relation == "state") facts.push_back(fact);
    FactSet result(std::move(facts));
    for (const Predicate& fact : unsaid) result.erase(fact);
    return result;
  };
  const FactSet before = comparable(seen_before);
  FactSet wanted = before;
  for (const Predicate& fact : difference(last, first)) wanted.insert(fact);
  for (const Predicate& fact : difference(first, last)) wanted.erase(fact);
  std::vector<std::string> recorded;
  for (const Action& action : actions) {
    recorded.push_back(recorded_spelling(action));
    if (action.name == "moveto" && !action.arguments.empty())
      near = {Predicate{"Near", "Robot", action.arguments.front()}};
  }
  return inference::score_run(before, wanted, demonstration.actions, comparable(seen_after), recorded);
}

Expected<PhysicsRun> run_in_physics(const Demonstration& demonstration, const scene::Scene& scene,
                                    const PhysicsOptions& options) {
  RunRecord record;
  LoopOptions loop_options;
  loop_options.scene = scene.name;
  loop_options.model = options.model;
  loop_options.seed = options.seed;
  loop_options.process_only = true;
  LoopEvents events;
  events.on_status = [&](const coordinator::Report& report) { record.on_status(report); };
  events.on_world = [&](const WorldState& world) { record.on_world(world); };
  events.stop_asked = options.stop_asked;
  auto loop = LockstepLoop::create(loop_options, std::move(events));
  if (!loop) return tl::unexpected<Error>(std::move(loop.error()));
  const FactSet& start = demonstration.states.front().facts;
  arrange((*loop)->world(), start);
  if (auto settled = (*loop)->settle(kRest); !settled)
    return tl::unexpected<Error>(std::move(settled.error()));

  PhysicsRun result;
  result.scene = scene.name;
  result.not_arranged = difference(known_facts(start, scene), record.facts());
  const double begin = (*loop)->sim_time();
  (*loop)->instruct(demonstration.sentence);
  while (!record.last().finished) {
    if (options.stop_asked && options.stop_asked()) return fail(Outcome::kCancelled, "interrupted");
    (*loop)->step();
  }
  result.sim_seconds = (*loop)->sim_time() - begin;
  result.outcome = record.last().outcome;
  result.message = record.last().message;
  result.run.id = demonstration.id;
  for (const Action& action : record.last().actions) result.run.actions.push_back(recorded_spelling(action));
  result.run.final_state = record.facts();
  if (static_cast<int>(result.outcome) / 10 == 1) result.run.refusal = result.message;
  result.run.scores =
      score_physics(demonstration, record.facts_before(), record.facts(), record.last().actions);
  return result;
}

}  // namespace goalnet::tools
