#include "components/goalnet/ranker/example.h"

#include <algorithm>

#include "components/goalnet/language/frames.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

constexpr std::size_t kLongestRun = 8;  // actions that one macro stands for

void compress(Example& example) {
  const auto& actions = example.actions;
  for (std::size_t i = 0; i < actions.size();) {
    std::size_t end = i;  // the last action of the stretch that starts at i
    bool found = false;
    for (std::size_t j = std::min(actions.size(), i + kLongestRun); j-- > i && !found;) {
      const auto run = with_means(actions[j], example.states[i]);
      found = run.size() == j - i + 1 &&
              std::equal(run.begin(), run.end(), actions.begin() + static_cast<long>(i));
      if (found) end = j;
    }
    // What changed nothing (or was not possible) teaches nothing: predicates could not express it.
    if (found && !delta(example.states[i], example.states[end + 1]).empty())
      example.macros.emplace_back(i, actions[end]);
    i = end + 1;
  }
}

Example make_example(const Demonstration& demonstration, Lexicon& lexicon, const Language& language,
                     Symbols& symbols) {
  Example example;
  example.id = demonstration.id;
  example.scenario = demonstration.scenario;
  example.perturbed = demonstration.perturbed;
  WorldState world = demonstration.states.front();
  lexicon.complete_objects(world);
  // A demonstration is read whole or not at all; its sentence is never too long in practice, and empty if so.
  const auto words = tokenize(demonstration.sentence).value_or(std::vector<std::string>{});
  example.given = see_instruction(words, &demonstration.grounding, world.objects, lexicon, language, symbols);
  example.none = see_instruction(words, nullptr, world.objects, lexicon, language, symbols);
  for (const WorldState& state : demonstration.states)
    example.states.push_back(to_sym_state(state.facts, symbols));
  for (const std::string& text : demonstration.actions)
    example.actions.push_back(parse_action(text, symbols).value_or(SymAction{}));
  compress(example);
  const FrameReader reader(lexicon, language, symbols);
  for (auto [instruction, reading] :
       {std::pair{&example.given, &example.read_given}, {&example.none, &example.read_none}}) {
    auto understood = reader.read(*instruction, example.states.front());
    *reading = {std::move(understood.macros), understood.complete};
  }
  return example;
}

}  // namespace

std::vector<Example> make_examples(const std::vector<Demonstration>& demonstrations, Lexicon& lexicon,
                                   const Language& language, Symbols& symbols) {
  std::vector<Example> examples;
  for (const Demonstration& demonstration : demonstrations)
    examples.push_back(make_example(demonstration, lexicon, language, symbols));
  return examples;
}

Places learn_places(const std::vector<const Example*>& examples) {
  Places places;
  for (const Example* example : examples)
    for (const auto& [step, action] : example->macros) {
      const int y = example->none.find(action.y);
      if (y < 0) continue;
      const ClassId id = example->none.objects[static_cast<std::size_t>(y)].class_id;
      if (action.verb == Verb::kKeepOn) places.on.push_back(id);
      if (action.verb == Verb::kKeepIn) places.in.push_back(id);
    }
  for (auto* list : {&places.on, &places.in}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return places;
}

}  // namespace goalnet::inference
