// Made-up demonstrations for tests of training.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/sym_sim.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

// Adds the state after each of its actions; the first state is there.
inline void play_actions(Demonstration& demonstration, Symbols& symbols) {
  SymState state = to_sym_state(demonstration.states[0].facts, symbols);
  for (const std::string& text : demonstration.actions) {
    apply(*parse_action(text, symbols), state);
    demonstration.states.push_back({demonstration.states[0].objects, to_fact_set(state, symbols)});
  }
}

struct Thing {
  std::string name, word;
};

// Somebody who takes one of the things, which all lie on the counter.
inline Demonstration taken(const std::vector<Thing>& things, const Thing& wanted, int scenario, int person,
                           const std::string& sentence) {
  Demonstration d;
  d.scenario = std::to_string(scenario);
  d.id = d.scenario + "_" + std::to_string(person);
  d.sentence = sentence;
  std::vector<std::string> objects = {"Counter_1", "Robot"};
  std::vector<Predicate> facts;
  for (const Thing& thing : things) {
    objects.push_back(thing.name);
    facts.push_back({"IsGraspable", thing.name, ""});
    facts.push_back({"On", thing.name, "Counter_1"});
  }
  d.states.push_back({objects, FactSet(facts)});
  d.actions = {"moveto " + wanted.name, "grasp " + wanted.name};
  Symbols symbols;
  play_actions(d, symbols);
  return d;
}

// The shipped words of the household, as training takes them.
inline std::string household_words() {
  std::ifstream file(GOALNET_SOURCE_DIR "/config/language/household.json");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace goalnet::inference
