#include "tests/unit/goalnet/instruction_runner.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "components/planner/parser.h"
#include "components/planner/world.h"

namespace goalnet::inference {
namespace {

constexpr int kMostSteps = 30;
constexpr std::int64_t kMostStates = 200000;  // of one search

bool matches(const std::string& pattern, const std::string& name) {
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : pattern == name;
}

}  // namespace

std::vector<std::vector<std::string>> read_rows(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(path + ": cannot be read");
  std::vector<std::vector<std::string>> result;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> row(1);
    for (const char c : line) {
      if (c == '\t')
        row.emplace_back();
      else if (c != '\r')
        row.back().push_back(c);
    }
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<std::pair<std::string, bool>> signed_facts(const std::string& text) {
  std::vector<std::pair<std::string, bool>> result;
  for (std::size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1))
    result.emplace_back(text.substr(at, text.find(')', at) - at + 1), at == 0 || text[at - 1] != '!');
  return result;
}

bool reached(const std::string& goal, const FactSet& facts) {
  for (std::size_t begin = 0, end; begin <= goal.size(); begin = end + 3) {
    end = std::min(goal.find(" / ", begin), goal.size());
    const std::string alternative = goal.substr(begin, end - begin);
    const int needed = alternative.find("#2") != std::string::npos ? 2 : 1;
    bool all = true;
    for (const auto& [text, wanted] : signed_facts(alternative)) {
      std::istringstream words(text.substr(1, text.size() - 2));
      std::string relation, subject, object;
      words >> relation >> subject >> object;
      int found = 0;
      for (const Predicate& fact : facts)
        found += fact.relation == relation && matches(subject, fact.subject) && matches(object, fact.object);
      all = all && (wanted ? found >= needed : found == 0);
    }
    if (all) return true;
  }
  return false;
}

InstructionRunner::InstructionRunner() {
  const std::string source = GOALNET_SOURCE_DIR;
  auto loaded = load_model(source + "/config/models/goalnet.safetensors");
  if (!loaded) throw std::runtime_error(loaded.error().message);
  model_ = std::move(*loaded);
  auto domain = planner::load_domain(source + "/config/domains/household.pddl");
  if (!domain) throw std::runtime_error(domain.error().message);
  domain_ = std::make_unique<planner::Domain>(std::move(*domain));
  planner_ = std::make_unique<planner::Planner>(*domain_);
}

Rooms::Rooms() {
  std::ifstream file(std::string(GOALNET_SOURCE_DIR) + "/tests/data/instructions/worlds.json");
  const auto rooms = nlohmann::json::parse(file);
  for (const auto& [name, room] : rooms.items()) {
    WorldState& world = rooms_[name];
    world.objects = room.at("objects").get<std::vector<std::string>>();
    std::vector<Predicate> facts;
    for (const auto& text : room.at("facts")) facts.push_back(*parse_predicate(text.get<std::string>()));
    world.facts = FactSet(facts);
  }
}

WorldState Rooms::room(const std::string& name, const std::string& changes) const {
  WorldState world = rooms_.at(name);
  for (const auto& [text, add] : signed_facts(changes)) {
    const Predicate fact = *parse_predicate(text);
    if (!add) {
      world.facts.erase(fact);
      continue;
    }
    const FactSet before = world.facts;
    for (const Predicate& old : before)
      if (fact.relation == "Grasping" && old.subject == fact.object &&
          (old.relation == "On" || old.relation == "In"))
        world.facts.erase(old);
    world.facts.insert(fact);
  }
  return world;
}

WorldState InstructionRunner::furnished(const WorldState& recorded) const {
  const auto has = [](const WorldState& world, const std::string& object) {
    return std::find(world.objects.begin(), world.objects.end(), object) != world.objects.end();
  };
  WorldState room;
  std::ptrdiff_t most = 0;
  for (const auto& [name, other] : rooms_.all()) {
    const auto common = std::count_if(other.objects.begin(), other.objects.end(),
                                      [&](const std::string& object) { return has(recorded, object); });
    if (common > most) most = common, room = other;
  }
  WorldState world = recorded;
  for (const Predicate& fact : room.facts)
    if (!has(recorded, fact.subject)) world.facts.insert(fact);
  for (const std::string& object : room.objects)
    if (!has(recorded, object)) world.objects.push_back(object);
  return world;
}

InstructionRunner::Run InstructionRunner::follow(const WorldState& world, const std::string& sentence,
                                                 const std::map<std::string, double>* distances) {
  Run run;
  std::vector<WorldState> states = {world};
  for (int step = 0; step < kMostSteps; ++step) {
    const auto goal = model_->infer({.sentence = sentence,
                                     .grounding = nullptr,
                                     .states = states,
                                     .goals = run.goals,
                                     .distances = distances});
    if (!goal) {
      run.refused = true;
      run.message = goal.error().message;
      break;
    }
    if (goal->empty()) break;
    if (step == 0) run.confidence = goal->confidence;
    WorldState now = states.back();
    planner::SolveOptions options;
    options.node_limit = kMostStates;
    if (const auto plan = planner_->solve(now, *goal, options)) {
      for (const Action& action : plan->actions)
        if (auto facts = planner::apply(*domain_, now, action)) now.facts = std::move(*facts);
    } else {
      run.planned = false;
      run.message = plan.error().message;
    }
    run.goals.push_back(*goal);
    states.push_back(std::move(now));
  }
  run.facts = states.back().facts;
  return run;
}

}  // namespace goalnet::inference
