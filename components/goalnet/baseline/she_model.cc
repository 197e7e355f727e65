#include "components/goalnet/baseline/she_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::baseline {
namespace {

constexpr std::size_t kMostHypotheses = 200;  // of a verb, the most frequent ones
constexpr std::size_t kMostArguments = 24;    // ways to choose objects for the arguments
constexpr int kRounds = 30;                   // of gradient ascent
constexpr double kRate = 0.3, kShrink = 1e-4;

using Features = std::array<double, kSheFeatures>;

struct Candidate {
  Goal goal;
  Features features;
};

// All ways to choose one object for each argument, the first candidates first.
std::vector<std::vector<std::string>> choices(const VerbFrame& frame) {
  std::vector<std::vector<std::string>> all = {{}};
  for (const auto& names : frame.candidates) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& chosen : all) {
      for (const std::string& name : names) {
        longer.push_back(chosen);
        longer.back().push_back(name);
        if (longer.size() >= kMostArguments) break;
      }
      if (longer.size() >= kMostArguments) break;
    }
    all = std::move(longer);
  }
  return all;
}

// Share of words in common between the sentence and the nearest sentence behind the hypothesis.
double overlap(const std::vector<std::string>& words, const Evidence& evidence) {
  double best = 0;
  for (const auto& other : evidence.sentences) {
    std::vector<std::string> common;
    std::set_intersection(words.begin(), words.end(), other.begin(), other.end(), std::back_inserter(common));
    const double all = static_cast<double>(words.size() + other.size() - common.size());
    if (all > 0) best = std::max(best, static_cast<double>(common.size()) / all);
  }
  return best;
}

Features features_of(const Hypothesis& hypothesis, const Evidence& evidence, int total, bool of_verb,
                     const Goal& goal, const std::vector<std::string>& arguments, const FactSet& facts,
                     const std::vector<std::string>& words) {
  Features f{};
  std::set<std::string> used;
  double constants = 0, true_already = 0;
  for (const Change& change : hypothesis) {
    for (const std::string* name : {&change.fact.subject, &change.fact.object}) {
      if (name->starts_with('?')) used.insert(*name);
    }
    const bool about_arguments = change.fact.subject.starts_with('?') || change.fact.object.starts_with('?');
    constants += !about_arguments;
    f[8] += change.fact.relation == "Grasping" && change.added;
    f[9] += change.fact.relation == "state";
    f[10] += change.fact.relation == "On" || change.fact.relation == "In";
    f[11] += !change.added;
  }
  for (const Predicate& fact : goal.positive) true_already += facts.contains(fact);
  for (const Predicate& fact : goal.negative) true_already += !facts.contains(fact);
  const double size = std::max<double>(1, static_cast<double>(hypothesis.size()));
  f[0] = std::log((evidence.whole + 0.2) / total);
  f[14] = std::log((evidence.part + 0.2) / total);
  f[15] = overlap(words, evidence);
  f[16] = f[15] > 0.99 ? 1 : 0;
  f[1] = of_verb ? 1 : 0;
  f[2] = static_cast<double>(hypothesis.size());
  f[3] = hypothesis.empty() ? 1 : 0;
  f[4] = arguments.empty() ? 1 : static_cast<double>(used.size()) / static_cast<double>(arguments.size());
  f[5] = constants / size;
  f[6] = true_already / size;
  f[7] = true_already >= static_cast<double>(hypothesis.size()) ? 1 : 0;
  for (const std::string& name : arguments) {
    f[12] += facts.contains({"Grasping", "Robot", name});
    f[13] += facts.contains({"Near", "Robot", name});
  }
  return f;
}

std::vector<std::string> word_set(const std::string& sentence) {
  auto words = tokenize(sentence).value_or(std::vector<std::string>());
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

std::vector<Candidate> candidates_of(const SheParts& parts, const VerbFrame& frame, const FactSet& facts,
                                     const std::vector<std::string>& words) {
  const auto found = parts.spaces.find(frame.verb);
  const bool of_verb = !frame.verb.empty() && found != parts.spaces.end();
  const auto everything = parts.spaces.find("");
  std::vector<Candidate> candidates;
  if (everything == parts.spaces.end()) return candidates;
  const auto& space = of_verb ? found->second : everything->second;
  std::vector<std::pair<const Hypothesis*, const Evidence*>> order;
  int total = 0;
  for (const auto& [hypothesis, evidence] : space) {
    order.emplace_back(&hypothesis, &evidence);
    total += evidence.whole;
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second->whole, a.second->part) > std::pair(b.second->whole, b.second->part);
  });
  if (order.size() > kMostHypotheses) order.resize(kMostHypotheses);
  for (const auto& arguments : choices(frame)) {
    for (const auto& [hypothesis, evidence] : order) {
      Candidate candidate;
      if (!instantiate(*hypothesis, arguments, candidate.goal)) continue;
      candidate.features =
          features_of(*hypothesis, *evidence, total, of_verb, candidate.goal, arguments, facts, words);
      candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

double score(const std::vector<double>& weights, const Features& features) {
  double sum = 0;
  for (std::size_t i = 0; i < features.size(); ++i) sum += weights[i] * features[i];
  return sum;
}

// F1 of a goal against what was demonstrated.
double agreement(const Goal& goal, const Goal& wanted) {
  const auto common = [](const std::vector<Predicate>& a, const std::vector<Predicate>& b) {
    return std::count_if(a.begin(), a.end(), [&](const Predicate& fact) {
      return std::find(b.begin(), b.end(), fact) != b.end();
    });
  };
  const double hit =
      static_cast<double>(common(goal.positive, wanted.positive) + common(goal.negative, wanted.negative));
  const double all = static_cast<double>(goal.positive.size() + goal.negative.size() +
                                         wanted.positive.size() + wanted.negative.size());
  return all > 0 ? 2 * hit / all : 1;
}

// Each demonstration's hypothesis, and every part of it of one or two changes: the lattice of She et al., cut
// short.
void extend(std::map<Hypothesis, Evidence>& space, const Hypothesis& whole,
            const std::vector<std::string>& words) {
  const auto note = [&](const Hypothesis& hypothesis, int Evidence::*count) {
    Evidence& evidence = space[hypothesis];
    ++(evidence.*count);
    if (count == &Evidence::whole && evidence.sentences.size() < 10) evidence.sentences.push_back(words);
  };
  note(whole, &Evidence::whole);
  if (whole.size() < 2 || whole.size() > 8) return;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    note({whole[i]}, &Evidence::part);
    for (std::size_t j = i + 1; whole.size() > 2 && j < whole.size(); ++j)
      note({whole[i], whole[j]}, &Evidence::part);
  }
}

class SheModel : public GoalModel {
 public:
  explicit SheModel(std::shared_ptr<const SheParts> parts) : parts_(std::move(parts)) {}
  std::string_view kind() const override { return "she2016"; }

 private:
  Expected<Goal> do_infer(const StepInput& input) override {
    if (!input.goals.empty()) return Goal{};  // the whole goal was given at the start
    const WorldState& state = input.states.back();
    const VerbFrame frame = find_frame(std::string(input.sentence), input.grounding, parts_->lexicon, state);
    const auto candidates = candidates_of(*parts_, frame, state.facts, word_set(std::string(input.sentence)));
    const Candidate* best = nullptr;
    double best_score = 0, sum = 0;
    for (const Candidate& candidate : candidates) {
      const double value = score(parts_->weights, candidate.features);
      if (best != nullptr && value <= best_score) continue;
      best = &candidate;
      best_score = value;
    }
    if (best == nullptr) return fail(Outcome::kNotUnderstood, "no verb of the instruction is known");
    for (const Candidate& candidate : candidates)
      sum += std::exp(score(parts_->weights, candidate.features) - best_score);
    Goal goal = best->goal;
    goal.confidence = 1 / sum;
    return goal;
  }

  std::shared_ptr<const SheParts> parts_;
};

}  // namespace

namespace {

struct Lesson {
  const Demonstration* demonstration;
  VerbFrame frame;
  Goal wanted;
  std::vector<std::string> words;
};

void learn_spaces(SheParts& parts, const std::vector<const Lesson*>& lessons) {
  parts.spaces.clear();
  for (const Lesson* lesson : lessons) {
    const Hypothesis hypothesis = generalise(lesson->wanted, lesson->frame);
    extend(parts.spaces[""], hypothesis, lesson->words);
    if (!lesson->frame.verb.empty()) extend(parts.spaces[lesson->frame.verb], hypothesis, lesson->words);
  }
}

// One choice to learn from: the candidates, and which of them agree best with what was demonstrated.
struct Choice {
  std::vector<Candidate> candidates;
  std::vector<bool> right;
};

Choice choice_of(const SheParts& parts, const Lesson& lesson) {
  Choice choice{candidates_of(parts, lesson.frame, lesson.demonstration->states[0].facts, lesson.words), {}};
  std::vector<double> agreements;
  for (const Candidate& candidate : choice.candidates)
    agreements.push_back(agreement(candidate.goal, lesson.wanted));
  const double best = agreements.empty() ? 0 : *std::max_element(agreements.begin(), agreements.end());
  for (const double value : agreements) choice.right.push_back(best > 0 && value >= best);
  return choice;
}

// One step of gradient ascent on the log probability of the right candidates.
void learn_choice(std::vector<double>& weights, const Choice& choice, double rate) {
  double all = 0, good = 0, highest = -1e300;
  std::vector<double> p;
  for (const Candidate& candidate : choice.candidates)
    highest = std::max(highest, score(weights, candidate.features));
  for (std::size_t k = 0; k < choice.candidates.size(); ++k) {
    p.push_back(std::exp(score(weights, choice.candidates[k].features) - highest));
    all += p.back();
    good += choice.right[k] ? p.back() : 0;
  }
  if (good <= 0) return;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double step = rate * ((choice.right[k] ? p[k] / good : 0) - p[k] / all);
    for (std::size_t j = 0; j < kSheFeatures; ++j) weights[j] += step * choice.candidates[k].features[j];
  }
  for (double& weight : weights) weight *= 1 - kShrink;
}

}  // namespace

std::shared_ptr<const SheParts> train_she(const std::vector<Demonstration>& demonstrations,
                                          network::Lexicon lexicon) {
  auto parts =
      std::make_shared<SheParts>(SheParts{{}, std::vector<double>(kSheFeatures), std::move(lexicon)});
  std::vector<Lesson> lessons;
  for (const Demonstration& d : demonstrations) {
    const Grounding* grounding = d.grounding.empty() ? nullptr : &d.grounding;
    lessons.push_back({&d, find_frame(d.sentence, grounding, parts->lexicon, d.states[0]), net_change(d),
                       word_set(d.sentence)});
  }
  // The weights must not lean on having seen the very demonstration: each part of the scenarios is ranked
  // with the hypotheses of the others.
  constexpr std::size_t kParts = 4;
  std::vector<Choice> all;
  for (std::size_t part = 0; part < kParts; ++part) {
    std::vector<const Lesson*> known, asked;
    for (const Lesson& lesson : lessons) {
      std::size_t hash = 0;
      for (const char c : lesson.demonstration->scenario) hash = hash * 31 + static_cast<unsigned char>(c);
      (hash % kParts == part ? asked : known).push_back(&lesson);
    }
    learn_spaces(*parts, known);
    for (const Lesson* lesson : asked) all.push_back(choice_of(*parts, *lesson));
  }
  for (int round = 0; round < kRounds; ++round) {
    for (const Choice& choice : all) learn_choice(parts->weights, choice, kRate / (1 + round));
  }
  std::vector<const Lesson*> everything;
  for (const Lesson& lesson : lessons) everything.push_back(&lesson);
  learn_spaces(*parts, everything);
  return parts;
}

std::unique_ptr<GoalModel> make_she_model(std::shared_ptr<const SheParts> parts) {
  return std::make_unique<SheModel>(std::move(parts));
}

}  // namespace goalnet::inference::baseline
