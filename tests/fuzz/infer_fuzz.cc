// Whatever a person says to a robot: goals or one message, in both rooms and in worlds made of the same
// bytes. Needs GOALNET_CONFIG_DIR or the working directory at the root of the project.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "components/core/config_path.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/lexicon.h"

namespace {

using namespace goalnet;
using namespace goalnet::inference;

// All things of a room with everything movable on one counter; `bits` switches devices, contents and what is
// held.
WorldState room(const char* some_thing, std::uint8_t bits) {
  Symbols symbols;
  static const Lexicon lexicon = *Lexicon::load(config_path("language/household.json"), symbols);
  WorldState world;
  world.objects = {some_thing};
  lexicon.complete_objects(world);
  std::vector<Predicate> facts;
  for (const std::string& name : world.objects) {
    if (name == "Robot" || name == "Sink" || name.starts_with("Counter") || name.starts_with("Stove"))
      continue;
    facts.push_back({"IsGraspable", name, ""});
    facts.push_back({"On", name, bits & 1 ? "Counter_1" : "Sink"});
  }
  if (bits & 2) facts.push_back({"state", "SinkKnob", "TapIsOn"});
  if (bits & 4) facts.push_back({"state", "Mug_1", "Coffee"}), facts.push_back({"state", "Kettle", "Water"});
  if (bits & 8)
    facts.push_back({"Grasping", "Robot", "Mug_1"}), facts.push_back({"Grasping", "Robot", "Beer_1"});
  if (bits & 16)
    facts.push_back({"state", "Tv_1", "Channel3"}), facts.push_back({"state", "IceCream_1", "ScoopsLeft"});
  if (bits & 32)
    facts.push_back({"On", "Kettle", "StoveFire_2"}), facts.push_back({"state", "Stove", "StoveFire2"});
  if (bits & 64) facts.push_back({"In", "Mug_1", "Microwave"}), facts.push_back({"On", "Mug_1", "Mug_1"});
  world.facts = FactSet(facts);
  return world;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::unique_ptr<GoalModel> model = [] {
    auto loaded = load_model(config_path("models/goalnet.safetensors"));
    if (!loaded) std::abort();
    return std::move(*loaded);
  }();
  if (size == 0) return 0;
  const std::vector<WorldState> states = {room(data[0] & 128 ? "Armchair_2" : "Fridge", data[0])};
  const std::string_view sentence(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto goal = model->infer({.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
  if (!goal) {
    if (goal.error().message.empty()) std::abort();
    return 0;
  }
  if (!(goal->confidence >= 0 && goal->confidence <= 1)) std::abort();
  for (const Predicate& fact : goal->positive)
    if (fact.relation.empty() || fact.subject.empty()) std::abort();
  return 0;
}
