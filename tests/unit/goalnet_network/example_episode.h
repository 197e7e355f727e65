// A small kitchen for tests of the network: no data from outside needed.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/goal_model.h"

namespace goalnet::inference {

struct ExampleEpisode {
  std::string sentence;
  Grounding grounding;
  std::vector<WorldState> states;
  std::vector<Goal> goals;  // one per state; the last one is empty
};

inline Predicate fact(const std::string& text) { return *parse_predicate(text); }

inline WorldState example_state(const std::vector<std::string>& more) {
  WorldState state;
  state.objects = {"BoiledEgg_1", "Counter_1", "Fridge",  "FridgeLeft",  "Kettle",
                   "Microwave",   "Mug_1",     "Plate_1", "Plate_2",     "Robot",
                   "Sink",        "SinkKnob",  "Stove",   "StoveFire_1", "StoveFire_2"};
  std::vector<Predicate> facts;
  for (const char* text : {"IsGraspable Mug_1", "IsGraspable Kettle", "IsGraspable Plate_1",
                           "IsGraspable Plate_2", "IsGraspable BoiledEgg_1", "On Mug_1 Counter_1",
                           "In BoiledEgg_1 Fridge", "On Plate_2 StoveFire_1", "state Mug_1 Coffee"}) {
    facts.push_back(fact(text));
  }
  for (const std::string& text : more) facts.push_back(fact(text));
  state.facts = FactSet(std::move(facts));
  return state;
}

inline std::vector<ExampleEpisode> example_episodes() {
  ExampleEpisode fill{"fill mug with water", {{"mug", {"Mug_1"}}}, {}, {}};
  fill.states = {
      example_state({}), example_state({"On Mug_1 Sink", "Near Robot Sink"}),
      example_state({"On Mug_1 Sink", "Near Robot Sink", "state SinkKnob TapIsOn", "state Mug_1 Water"})};
  fill.goals = {
      {{fact("On Mug_1 Sink")}, {}}, {{fact("state SinkKnob TapIsOn"), fact("state Mug_1 Water")}, {}}, {}};
  ExampleEpisode boil{"boil egg and drop kettle", {{"egg", {"BoiledEgg_1"}}, {"kettle", {"Kettle"}}}, {}, {}};
  boil.states = {example_state({"Grasping Robot Kettle"}),
                 example_state({"Grasping Robot Kettle", "Near Robot Microwave"}),
                 example_state({"In BoiledEgg_1 Microwave", "Near Robot Microwave", "Grasping Robot Kettle"}),
                 example_state({"In BoiledEgg_1 Microwave"})};
  boil.goals = {{{fact("Near Robot Microwave")}, {}},
                {{fact("In BoiledEgg_1 Microwave")}, {}},
                {{}, {fact("Grasping Robot Kettle"), fact("Near Robot Microwave")}},
                {}};
  return {fill, boil};
}

}  // namespace goalnet::inference
