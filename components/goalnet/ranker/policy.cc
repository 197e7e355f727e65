#include "components/goalnet/ranker/policy.h"

#include <algorithm>
#include <cmath>

namespace goalnet::inference {

Moment make_moment(const Instruction& instruction, const Lexicon& lexicon, const Places& places,
                   const Hints& hints, const PartialRun& run) {
  Moment moment;
  moment.actions = Candidates(instruction, lexicon, places).in(run.now);
  const FeatureContext context(instruction, hints, run);
  moment.decision.features.reserve(moment.actions.size() * 120);
  moment.decision.offsets.reserve(moment.actions.size() + 1);
  moment.decision.offsets.push_back(0);
  for (const SymAction& action : moment.actions) {
    const ActionHints action_hints = context.hints(action);
    EarlierFeatures earlier;
    context.extract_fixed(action, action_hints, moment.decision.features);
    context.extract_moment(action, action_hints, earlier, moment.decision.features);
    moment.decision.offsets.push_back(static_cast<std::uint32_t>(moment.decision.features.size()));
  }
  return moment;
}

Rollout::Rollout(const LogLinear& model, const Instruction& instruction, const Lexicon& lexicon,
                 const Places& places, const Hints& hints, const SymState& start)
    : model_(model),
      instruction_(instruction),
      candidates_(instruction, lexicon, places),
      hints_(hints),
      start_(start) {
  Node root;
  root.run.now = start;
  nodes_.push_back(std::move(root));
}

void Rollout::expand(std::size_t index) {
  if (nodes_[index].expanded) return;
  ++moments_;
  const FeatureContext context(instruction_, hints_, nodes_[index].run);
  struct Choice {
    SymAction action;
    std::uint32_t number;
    float fixed;
  };
  const std::vector<SymAction> offered = candidates_.in(nodes_[index].run.now);
  std::vector<Choice> choices;
  choices.reserve(offered.size());
  float most = -1e9f;
  for (const SymAction& action : offered) {
    const auto [number, is_new] = numbers_.number(step_key(action.verb, action.x, action.y));
    if (is_new) {
      Known& known = known_.emplace_back();
      known.hints = context.hints(action);
      features_.clear();
      context.extract_fixed(action, known.hints, features_);
      fixed_.push_back(model_.score(features_));
    }
    const float fixed = fixed_[number];
    if (action.verb != Verb::kStop) most = std::max(most, fixed);
    choices.push_back({action, number, fixed});
  }
  // What the words alone make this unlikely is not looked at: a fraction of the work, and the runs drawn are
  // no worse.
  constexpr float kMargin = 2.5f;
  std::erase_if(choices, [&](const Choice& choice) {
    return choice.action.verb != Verb::kStop && choice.fixed < most - kMargin;
  });
  std::vector<SymAction> actions;
  actions.reserve(choices.size());
  features_.clear();
  offsets_.assign(1, 0);
  for (const Choice& choice : choices) {
    actions.push_back(choice.action);
    Known& known = known_[choice.number];
    context.extract_moment(choice.action, known.hints, known.earlier, features_);
    offsets_.push_back(static_cast<std::uint32_t>(features_.size()));
  }
  std::vector<float> sum;
  model_.score(features_, offsets_, sum);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = choices[i].fixed + sum[i];
  LogLinear::softmax(sum);
  Node& node = nodes_[index];
  node.actions = std::move(actions);
  node.probability = std::move(sum);
  node.child.assign(node.actions.size(), -1);
  node.expanded = true;
}

int Rollout::follow(std::size_t index, std::size_t choice) {
  if (nodes_[index].child[choice] != -1) return nodes_[index].child[choice];
  const SymAction action = nodes_[index].actions[choice];
  Node next;
  next.run = nodes_[index].run;
  const auto steps = with_means(action, next.run.now);
  const SymState before = next.run.now;
  for (const SymAction& step : steps) apply(step, next.run.now);
  next.primitive = nodes_[index].primitive + steps.size();
  // Planner in the loop: what cannot be reached, changes nothing or leads back to the start is no choice.
  if (steps.empty() || next.run.now == before || next.run.now == start_ || next.primitive > kMaxActions) {
    nodes_[index].child[choice] = -2;
    return -2;
  }
  next.run.actions.push_back(action);
  nodes_.push_back(std::move(next));
  return nodes_[index].child[choice] = static_cast<int>(nodes_.size()) - 1;
}

template <class Choose>
CandidateRun Rollout::roll(Choose choose) {
  std::size_t at = 0;
  float log_probability = 0;
  while (nodes_[at].run.actions.size() < kMaxMacros) {
    expand(at);
    const std::size_t choice = choose(nodes_[at]);
    log_probability += std::log(std::max(nodes_[at].probability[choice], 1e-6f));
    if (nodes_[at].actions[choice].verb == Verb::kStop) break;
    const int next = follow(at, choice);
    if (next >= 0) {
      at = static_cast<std::size_t>(next);
      continue;
    }
    // Take the choice away for good and choose again among the rest.
    Node& node = nodes_[at];
    node.probability[choice] = 0;
    float sum = 0;
    for (const float p : node.probability) sum += p;
    if (sum <= 0) break;
    for (float& p : node.probability) p /= sum;
  }
  CandidateRun run = play(start_, nodes_[at].run.actions);
  run.log_probability = log_probability;
  return run;
}

CandidateRun Rollout::greedy() {
  return roll([](const Node& node) {
    return static_cast<std::size_t>(std::max_element(node.probability.begin(), node.probability.end()) -
                                    node.probability.begin());
  });
}

CandidateRun Rollout::sample(Random& random, float temperature) {
  CandidateRun run = roll([&](const Node& node) {
    double sum = 0;
    const float power = 1 / temperature;
    for (const float p : node.probability) sum += temperature == 1 ? p : std::pow(p, power);
    double left = random.uniform() * sum;
    std::size_t last = 0;
    for (std::size_t i = 0; i < node.probability.size(); ++i) {
      if (node.probability[i] <= 0) continue;
      last = i;
      left -= temperature == 1 ? node.probability[i] : std::pow(node.probability[i], power);
      if (left < 0) return i;
    }
    return last;
  });
  run.source = 1;
  return run;
}

float Rollout::log_probability(std::span<const SymAction> macros) {
  constexpr float kImpossible = -8;
  std::size_t at = 0;
  float sum = 0;
  for (std::size_t i = 0; i <= macros.size(); ++i) {
    expand(at);
    const SymAction action = i < macros.size() ? macros[i] : SymAction{};
    const auto& actions = nodes_[at].actions;
    const auto found = std::find(actions.begin(), actions.end(), action);
    const auto choice = static_cast<std::size_t>(found - actions.begin());
    if (found == actions.end()) return sum + kImpossible;
    sum += std::log(std::max(nodes_[at].probability[choice], 1e-4f));
    if (action.verb == Verb::kStop) break;
    const int next = follow(at, choice);
    if (next < 0) return sum + kImpossible;
    at = static_cast<std::size_t>(next);
  }
  return sum;
}

}  // namespace goalnet::inference
