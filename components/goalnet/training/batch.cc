#include "components/goalnet/training/batch.h"

#include <algorithm>

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::training {

using network::GoalRelation;

EpisodeEncoder::EpisodeEncoder(const network::NetworkConfig& config, const Vocabulary& vocabulary)
    : config_(config),
      vocabulary_(vocabulary),
      names_(vocabulary.lexicon, vocabulary.vectors),
      worlds_(config, vocabulary.lexicon, vocabulary.grammar, vocabulary.vectors, names_) {}

std::vector<Target> EpisodeEncoder::targets_of(const Goal& goal, const WorldState& state) const {
  std::vector<Target> targets;
  const auto place = [&state](const std::string& name) {
    const auto found = std::find(state.objects.begin(), state.objects.end(), name);
    if (found != state.objects.end()) return static_cast<int>(found - state.objects.begin());
    // A part that the world does not list ("FridgeLeft") stands for the whole ("Fridge").
    int whole = -1;
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
      const bool longer =
          whole < 0 || state.objects[i].size() > state.objects[static_cast<std::size_t>(whole)].size();
      if (name.starts_with(state.objects[i]) && longer) whole = static_cast<int>(i);
    }
    return whole;
  };
  for (const bool positive : {true, false}) {
    if (!(positive ? config_.positive : config_.negative)) continue;
    for (const Predicate& fact : positive ? goal.positive : goal.negative) {
      const int relation = network::relation_id(fact.relation);
      if (relation < 0) continue;
      const auto r = static_cast<GoalRelation>(relation);
      Target target{network::token_of(r, positive), place(network::main_argument(fact)), -1, -1};
      if (network::has_second_object(r)) target.second = place(fact.object);
      if (r == GoalRelation::kState) target.value = vocabulary_.grammar.value(fact.object);
      const bool complete = target.main >= 0 && (!network::has_second_object(r) || target.second >= 0) &&
                            (r != GoalRelation::kState || target.value >= 0);
      if (complete && static_cast<int>(targets.size()) < config_.max_predicates) targets.push_back(target);
    }
  }
  // A goal of which this configuration can say nothing teaches nothing; above all not to stop here.
  if (targets.empty() && !goal.empty()) return targets;
  targets.push_back({});
  return targets;
}

Expected<EncodedEpisode> EpisodeEncoder::encode(const Episode& episode, bool with_grounding) {
  EncodedEpisode encoded;
  const auto texts = tokenize(episode.sentence);
  if (!texts) return tl::unexpected(texts.error());
  network::EncodedSentence sentence;
  for (const std::string& text : *texts) sentence.words.push_back(vocabulary_.lexicon.word(text));
  encoded.words = sentence.words;
  for (std::size_t t = 0; t < episode.states.size(); ++t) {
    StepExample step;
    const auto before = std::span(episode.pursued).first(t);
    auto done = worlds_.encode(sentence, *texts, with_grounding ? &episode.grounding : nullptr,
                               episode.states[t], before, step.world);
    if (!done) return tl::unexpected(done.error());
    step.goals_before = static_cast<int>(t);
    step.targets = targets_of(episode.goals[t], episode.states[t]);
    if (t + 1 == episode.states.size()) {
      for (int goal = 0; goal < static_cast<int>(t); ++goal) {
        const auto past = step.world.past_of(goal);
        encoded.past.emplace_back(past.begin(), past.end());
      }
    }
    encoded.steps.push_back(std::move(step));
  }
  return encoded;
}

}  // namespace goalnet::inference::training
