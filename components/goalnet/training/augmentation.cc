#include "components/goalnet/training/augmentation.h"

#include <algorithm>
#include <map>

#include "components/goalnet/network/index.h"
#include "components/goalnet/network/name_table.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::training {
namespace {

constexpr float kSimilar = 0.35F;  // cosine of the classes' word vectors

int class_of(const Vocabulary& vocabulary, const std::string& name) {
  return vocabulary.lexicon.class_of(network::split_name(name).class_name);
}

void swap_name(std::string& name, const std::string& a, const std::string& b) {
  if (name == a) {
    name = b;
  } else if (name == b) {
    name = a;
  }
}

void swap_names(std::vector<Predicate>& facts, const std::string& a, const std::string& b) {
  for (Predicate& fact : facts) {
    swap_name(fact.subject, a, b);
    swap_name(fact.object, a, b);
  }
}

}  // namespace

Augmentation::Augmentation(const Vocabulary& vocabulary, const std::vector<Episode>& episodes)
    : vocabulary_(vocabulary) {
  const auto& classes = vocabulary.lexicon.classes();
  network::NameTable names(vocabulary.lexicon, vocabulary.vectors);
  for (const std::string& name : classes) names.slot(name);  // slots in the order of the classes
  similar_.assign(classes.size(), std::vector<std::uint8_t>(classes.size()));
  const auto abilities = [&](int c) {
    int bits = 0;
    for (int r = 0; r < network::kRelations; ++r) {
      const auto relation = static_cast<network::GoalRelation>(r);
      if (relation == network::GoalRelation::kState) continue;
      bits = bits * 4 + vocabulary.grammar.main_allowed(relation, c, false) * 2 +
             vocabulary.grammar.second_allowed(relation, c);
    }
    return bits;
  };
  for (int a = 0; a < static_cast<int>(classes.size()); ++a) {
    for (int b = 0; b < static_cast<int>(classes.size()); ++b) {
      const float cosine = names.entry(a).unit.dot(names.entry(b).unit);
      similar_[at(a)][at(b)] = a != b && cosine > kSimilar && abilities(a) == abilities(b);
    }
  }
  std::vector<std::map<std::string, int>> counts(classes.size());
  for (const Episode& episode : episodes) {
    for (const auto& [word, objects] : episode.grounding) {
      for (const std::string& name : objects) {
        const int c = class_of(vocabulary, name);
        if (c >= 0) ++counts[at(c)][word];
      }
    }
  }
  words_.resize(classes.size());
  for (std::size_t c = 0; c < classes.size(); ++c) {
    for (const auto& [word, count] : counts[c]) words_[c].push_back(word);
    std::stable_sort(words_[c].begin(), words_[c].end(),
                     [&](const auto& x, const auto& y) { return counts[c].at(x) > counts[c].at(y); });
  }
}

Episode Augmentation::replaced(const Episode& episode, std::mt19937_64& random) const {
  struct Choice {
    std::string word, object, substitute;
  };
  std::vector<Choice> choices;
  for (const auto& [word, objects] : episode.grounding) {
    if (objects.size() != 1) continue;
    const int c = class_of(vocabulary_, objects[0]);
    if (c < 0) continue;
    for (const std::string& other : episode.states[0].objects) {
      const int d = class_of(vocabulary_, other);
      if (d >= 0 && similar_[at(c)][at(d)] && !words_[at(d)].empty())
        choices.push_back({word, objects[0], other});
    }
  }
  if (choices.empty()) return episode;
  const Choice& choice = choices[random() % choices.size()];
  const auto& names = words_[at(class_of(vocabulary_, choice.substitute))];
  const std::string& word = names[random() % std::min<std::size_t>(3, names.size())];
  Episode result = episode;
  for (WorldState& state : result.states) {
    std::vector<Predicate> facts = state.facts.values();
    swap_names(facts, choice.object, choice.substitute);
    state.facts = FactSet(std::move(facts));
  }
  for (auto* goals : {&result.goals, &result.pursued}) {
    for (Goal& goal : *goals) {
      swap_names(goal.positive, choice.object, choice.substitute);
      swap_names(goal.negative, choice.object, choice.substitute);
    }
  }
  Grounding grounding;
  for (const auto& [old, objects] : episode.grounding) {
    auto swapped = objects;
    for (std::string& name : swapped) swap_name(name, choice.object, choice.substitute);
    grounding[old == choice.word ? word : old] = std::move(swapped);
  }
  result.grounding = std::move(grounding);
  result.sentence.clear();
  const auto texts = tokenize(episode.sentence);
  if (!texts) return episode;
  for (const std::string& text : *texts)
    result.sentence += (result.sentence.empty() ? "" : " ") + (text == choice.word ? word : text);
  return result;
}

}  // namespace goalnet::inference::training
