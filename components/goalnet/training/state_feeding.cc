#include "components/goalnet/training/state_feeding.h"

#include <algorithm>

namespace goalnet::inference::training {
namespace {

void remove_places(FactSet& facts, const std::string& object) {
  std::vector<Predicate> gone;
  for (const Predicate& fact : facts) {
    if ((fact.relation == "On" || fact.relation == "In") && fact.subject == object && fact.object != object)
      gone.push_back(fact);
  }
  for (const Predicate& fact : gone) facts.erase(fact);
}

bool same(const Goal& a, const Goal& b) { return a.positive == b.positive && a.negative == b.negative; }

}  // namespace

bool sym_sim(const Goal& goal, WorldState& state) {
  for (const Predicate& fact : goal.negative) state.facts.erase(fact);
  for (const Predicate& fact : goal.positive) {
    if (fact.relation == "Grasping") remove_places(state.facts, fact.object);
    if (fact.relation == "On" || fact.relation == "In") {
      remove_places(state.facts, fact.subject);
      state.facts.erase({"Grasping", "Robot", fact.subject});
    }
    state.facts.insert(fact);
  }
  return true;
}

Episode feed_states(const Episode& episode, bool with_grounding, GoalModel& model, const Simulator& simulator,
                    double p, std::size_t extra, std::mt19937_64& random) {
  Episode fed{episode.id, episode.scenario, episode.sentence, episode.grounding, {}, {}, {}};
  std::bernoulli_distribution follow_model(p);
  WorldState state = episode.states[0];
  bool own = false;  // the state is no longer the recorded one
  std::size_t next = 0;
  const std::size_t last = episode.goals.size() - 1;
  while (true) {
    while (own && next < last && satisfied(episode.goals[next], state.facts)) ++next;
    fed.states.push_back(state);
    fed.goals.push_back(episode.goals[next]);
    fed.pursued.push_back(episode.goals[next]);
    if (next == last || fed.states.size() >= episode.states.size() + extra) break;
    if (follow_model(random)) {
      StepInput input;
      input.sentence = episode.sentence;
      input.grounding = with_grounding ? &episode.grounding : nullptr;
      input.states = fed.states;
      input.goals = std::span(fed.pursued).first(fed.states.size() - 1);
      const auto chosen = model.infer(input);
      WorldState reached = state;
      if (chosen && !chosen->empty() && !same(*chosen, episode.goals[next]) && simulator(*chosen, reached)) {
        fed.pursued.back() = *chosen;
        state = std::move(reached);
        own = true;
        continue;
      }
    }
    if (!own) {
      state = episode.states[++next];
    } else if (simulator(episode.goals[next], state)) {
      ++next;
    } else {
      break;  // the person's way cannot be followed from here
    }
  }
  return fed;
}

}  // namespace goalnet::inference::training
