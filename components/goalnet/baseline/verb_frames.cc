#include "components/goalnet/baseline/verb_frames.h"

#include <algorithm>
#include <array>

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::baseline {
namespace {

constexpr std::array<std::string_view, 18> kFillers = {".",   ",",  "and", "then", "now",  "please",
                                                       "you", "i",  "to",  "so",   "also", "the",
                                                       "a",   "an", "it",  "if",   "of",   "after"};
constexpr float kSense = 0.4F;  // a word that meant a class this often is an argument without a grounding

bool is_number(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789/") == std::string::npos;
}

std::vector<std::string> objects_meant(const std::string& word, const network::Lexicon& lexicon,
                                       const WorldState& state) {
  std::vector<std::string> objects;
  const int id = lexicon.word(word);
  if (id < 0) return objects;
  for (const network::WordSense& sense : lexicon.senses(id)) {
    if (sense.probability < kSense) continue;
    for (const std::string& name : state.objects) {
      if (lexicon.class_of(network::split_name(name).class_name) == sense.class_id) objects.push_back(name);
    }
  }
  return objects;
}

std::string replaced(const std::string& name, const VerbFrame& frame) {
  for (std::size_t i = 0; i < frame.candidates.size(); ++i) {
    const auto& names = frame.candidates[i];
    if (std::find(names.begin(), names.end(), name) != names.end()) return "?" + std::to_string(i + 1);
  }
  return name;
}

}  // namespace

VerbFrame find_frame(const std::string& sentence, const Grounding* grounding, const network::Lexicon& lexicon,
                     const WorldState& state) {
  VerbFrame frame;
  const auto words = tokenize(sentence);
  if (!words) return frame;
  for (const std::string& word : *words) {
    std::vector<std::string> objects;
    if (grounding != nullptr) {
      const auto found = grounding->find(word);
      if (found != grounding->end()) objects = found->second;
    } else {
      objects = objects_meant(word, lexicon, state);
    }
    const bool filler =
        std::find(kFillers.begin(), kFillers.end(), word) != kFillers.end() || is_number(word);
    if (!objects.empty()) {
      const bool known =
          std::find(frame.candidates.begin(), frame.candidates.end(), objects) != frame.candidates.end();
      if (!known) frame.candidates.push_back(std::move(objects));
    } else if (frame.verb.empty() && !filler) {
      frame.verb = word;
    }
  }
  return frame;
}

Hypothesis generalise(const Goal& change, const VerbFrame& frame) {
  Hypothesis hypothesis;
  for (const bool added : {true, false}) {
    for (Predicate fact : added ? change.positive : change.negative) {
      fact.subject = replaced(fact.subject, frame);
      if (fact.relation != "state") fact.object = replaced(fact.object, frame);
      hypothesis.push_back({added, fact});
    }
  }
  std::sort(hypothesis.begin(), hypothesis.end());
  hypothesis.erase(std::unique(hypothesis.begin(), hypothesis.end()), hypothesis.end());
  return hypothesis;
}

bool instantiate(const Hypothesis& hypothesis, const std::vector<std::string>& arguments, Goal& goal) {
  goal = {};
  const auto put = [&arguments](std::string& name) {
    if (!name.starts_with('?')) return true;
    const std::size_t number = static_cast<std::size_t>(name[1] - '0');
    if (name.size() != 2 || number < 1 || number > arguments.size()) return false;
    name = arguments[number - 1];
    return true;
  };
  for (const Change& change : hypothesis) {
    Predicate fact = change.fact;
    if (!put(fact.subject) || !put(fact.object)) return false;
    (change.added ? goal.positive : goal.negative).push_back(fact);
  }
  return true;
}

Goal net_change(const Demonstration& demonstration) {
  const FactSet &first = demonstration.states.front().facts, &last = demonstration.states.back().facts;
  Goal change{difference(last, first).values(), difference(first, last).values(), 1};
  const auto is_near = [](const Predicate& fact) { return fact.relation == "Near"; };
  if (!std::all_of(change.positive.begin(), change.positive.end(), is_near))
    std::erase_if(change.positive, is_near);
  std::erase_if(change.negative, is_near);
  // What is held is no longer where it lay: that follows.
  std::erase_if(change.negative, [&](const Predicate& fact) {
    return (fact.relation == "On" || fact.relation == "In") &&
           std::any_of(change.positive.begin(), change.positive.end(), [&](const Predicate& other) {
             return (other.relation == "Grasping" &&
                     (other.object == fact.subject || other.object == fact.object)) ||
                    ((other.relation == "On" || other.relation == "In") && other.subject == fact.subject);
           });
  });
  return change;
}

}  // namespace goalnet::inference::baseline
