#include "components/goalnet/training/episodes.h"

#include <algorithm>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference::training {
namespace {

constexpr std::size_t kLongestStretch = 10;  // no natural way to one action is longer

// Where the stretch of actions from `begin` ends: behind the last action that they are the natural way to.
std::size_t stretch_end(const std::vector<SymAction>& actions, std::size_t begin, const SymState& state) {
  std::size_t end = begin + 1;
  for (std::size_t last = begin; last < std::min(actions.size(), begin + kLongestStretch); ++last) {
    const std::vector<SymAction> way = with_means(actions[last], state);
    if (way.size() == last - begin + 1 &&
        std::equal(way.begin(), way.end(), actions.begin() + static_cast<std::ptrdiff_t>(begin))) {
      end = last + 1;
    }
  }
  return end;
}

}  // namespace

Goal intention(const Goal& step) {
  Goal goal;
  goal.positive = step.positive;
  const auto is_near = [](const Predicate& fact) { return fact.relation == "Near"; };
  if (!std::all_of(goal.positive.begin(), goal.positive.end(), is_near))
    std::erase_if(goal.positive, is_near);
  if (!goal.positive.empty()) return goal;
  for (const char* relation : {"state", "Grasping", "On", "In"}) {
    for (const Predicate& fact : step.negative) {
      if (fact.relation == relation) goal.negative.push_back(fact);
    }
    if (!goal.negative.empty()) break;
  }
  return goal;
}

Episode make_episode(const Demonstration& demonstration, const Lexicon& things, bool compress) {
  Episode episode{
      demonstration.id, demonstration.scenario, demonstration.sentence, demonstration.grounding, {}, {}, {}};
  Symbols symbols;
  std::vector<SymAction> actions;
  for (const std::string& text : demonstration.actions) {
    const auto action = parse_action(text, symbols);
    actions.push_back(action ? *action : SymAction{});
  }
  for (std::size_t begin = 0; begin < actions.size();) {
    std::size_t end = begin + 1;
    if (compress) end = stretch_end(actions, begin, to_sym_state(demonstration.states[begin].facts, symbols));
    Goal goal = compress ? intention(demonstration.steps[end - 1]) : demonstration.steps[begin];
    if (!goal.empty()) {
      episode.states.push_back(demonstration.states[begin]);
      episode.goals.push_back(goal);
    }
    begin = end;
  }
  episode.states.push_back(demonstration.states.back());
  episode.goals.emplace_back();
  episode.pursued = episode.goals;
  for (WorldState& state : episode.states) things.complete_objects(state);
  return episode;
}

}  // namespace goalnet::inference::training
