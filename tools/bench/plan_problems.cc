#include "tools/bench/plan_problems.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace goalnet::tools {
namespace {

// What can be grasped is a property of the object; some perturbed recordings lost it.
std::vector<Predicate> properties_of(const nlohmann::json& constants) {
  std::vector<Predicate> facts;
  for (const auto& [object, properties] : constants["all_obj_prop"].items()) {
    for (const auto& property : properties) {
      if (property == "IsGraspable") facts.push_back({"IsGraspable", object, ""});
    }
  }
  return facts;
}

FactSet facts_of(const nlohmann::json& state, std::vector<Predicate> facts) {
  for (const auto& text : state) {
    if (auto fact = parse_predicate(text.get<std::string>())) facts.push_back(std::move(*fact));
  }
  return FactSet(std::move(facts));
}

PlanQuestion difference_question(const std::string& name, const std::vector<std::string>& objects,
                                 const FactSet& from, const FactSet& to) {
  return {name, {objects, from}, {difference(to, from).values(), difference(from, to).values(), 1.0}};
}

// A kitchen with the usual fixtures and `room` objects in all, of which the first `count` are cups on the
// counter.
PlanQuestion kitchen(int count, int room) {
  PlanQuestion question;
  std::vector<Predicate> facts;
  question.state.objects = {"Robot",       "Counter_1",   "Sink",        "SinkKnob",
                            "Stove",       "StoveFire_1", "StoveFire_2", "StoveFire_3",
                            "StoveFire_4", "Fridge",      "Microwave",   "CoffeeTable_1"};
  for (int i = 1; static_cast<int>(question.state.objects.size()) < std::max(room, count + 12); ++i) {
    const std::string cup = "Cup_" + std::to_string(i);
    question.state.objects.push_back(cup);
    facts.push_back({"IsGraspable", cup, ""});
    facts.push_back({"On", cup, i <= count ? "Counter_1" : "Shelf_1"});
  }
  question.state.objects.push_back("Shelf_1");
  question.state.facts = FactSet(std::move(facts));
  return question;
}

std::string cup(int i) { return "Cup_" + std::to_string(i + 1); }

}  // namespace

bool for_each_recorded_question(const std::filesystem::path& folder,
                                const std::function<void(const PlanQuestion&)>& single,
                                const std::function<void(const PlanQuestion&)>& whole) {
  if (!std::filesystem::exists(folder / "constants.json")) return false;
  const auto constants = nlohmann::json::parse(std::ifstream(folder / "constants.json"));
  const auto objects = constants["all_objects"].get<std::vector<std::string>>();
  const std::vector<Predicate> properties = properties_of(constants);
  for (const char* part : {"train", "val"}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / part))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      const auto demo = nlohmann::json::parse(std::ifstream(file));
      std::vector<FactSet> states;
      for (const auto& state : demo["initial_states"]) states.push_back(facts_of(state, properties));
      if (states.empty()) continue;
      const std::string name = std::string(part) + "/" + file.stem().string();
      for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        if (states[i] == states[i + 1]) continue;
        single(difference_question(name + ":" + std::to_string(i), objects, states[i], states[i + 1]));
      }
      if (states.front() == states.back()) continue;
      whole(difference_question(name, objects, states.front(), states.back()));
    }
  }
  return true;
}

PlanQuestion carry_question(int count, int room) {
  PlanQuestion question = kitchen(count, room);
  question.name = "carry " + std::to_string(count) + " of " + std::to_string(room);
  for (int i = 0; i < count; ++i) question.goal.positive.push_back({"On", cup(i), "CoffeeTable_1"});
  return question;
}

PlanQuestion fridge_question(int count) {
  PlanQuestion question = kitchen(count, 59);
  question.name = "fridge " + std::to_string(count);
  for (int i = 0; i < count; ++i) question.goal.positive.push_back({"In", cup(i), "FridgeLeft"});
  return question;
}

PlanQuestion water_question(int count) {
  PlanQuestion question = kitchen(count, 59);
  question.name = "water " + std::to_string(count);
  for (int i = 0; i < count; ++i) question.goal.positive.push_back({"state", cup(i), "Water"});
  return question;
}

PlanQuestion heat_question(int count) {
  PlanQuestion question = kitchen(count, 59);
  question.name = "heat " + std::to_string(count);
  for (int i = 0; i < count; ++i) question.goal.positive.push_back({"state", cup(i), "temperatureHigh"});
  return question;
}

}  // namespace goalnet::tools
