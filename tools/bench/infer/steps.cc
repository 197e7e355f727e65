#include "tools/bench/infer/steps.h"

#include "components/core/config_path.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::tools {
namespace {

WorldState kitchen() {
  WorldState state;
  std::vector<Predicate> facts;
  for (const char* name :
       {"Mug_1",     "Kettle",      "Spoon_1", "Fork_1",  "Plate_1",     "Plate_2",       "Glass_1",
        "LongCup_1", "LongCup_2",   "Bowl_1",  "Coke_1",  "CanadaDry_1", "EnergyDrink_1", "InstantRamen_1",
        "Ramen_1",   "BoiledEgg_1", "Salt_1",  "Syrup_1", "Syrup_2",     "IceCream_1"}) {
    facts.push_back({"IsGraspable", name, ""});
  }
  for (const char* text :
       {"In IceCream_1 Fridge", "In Coke_1 Fridge", "In CanadaDry_1 Fridge", "On Plate_2 StoveFire_4",
        "On Glass_1 StoveFire_4", "On Syrup_1 StoveFire_1", "state Mug_1 Coffee", "state Syrup_1 Vanilla",
        "state Syrup_2 Chocolate", "IsSqueezeable Syrup_1", "IsSqueezeable Syrup_2"}) {
    facts.push_back(*parse_predicate(text));
  }
  state.facts = FactSet(std::move(facts));
  for (const Predicate& fact : state.facts) state.objects.push_back(fact.subject);
  inference::Symbols symbols;
  const auto things = inference::Lexicon::load(config_path("language/household.json"), symbols);
  if (things) things->complete_objects(state);
  return state;
}

Goal reach(const char* text) { return {{*parse_predicate(text)}, {}, 1}; }

}  // namespace

std::vector<InferStep> infer_steps() {
  const WorldState start = kitchen();
  std::vector<InferStep> steps = {
      {"grab the spoon", {start}, {}},
      {"fill the mug with water", {start}, {}},
      {"take the kettle to the sink, fill it with water and boil it on the stove", {start}, {}}};
  InferStep later = steps.back();
  for (const char* text : {"On Kettle Sink", "state SinkKnob TapIsOn", "On Kettle StoveFire_1"}) {
    later.goals.push_back(reach(text));
    WorldState next = later.states.back();
    next.facts.insert(*parse_predicate(text));
    later.states.push_back(next);
    steps.push_back(later);
  }
  return steps;
}

}  // namespace goalnet::tools
