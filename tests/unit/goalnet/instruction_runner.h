// Follows an instruction in the symbolic household: infer, plan by config/domains/household.pddl, apply,
// infer again.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/goalnet/goal_model.h"
#include "components/planner/planner.h"

namespace goalnet::inference {

// "(On Mug_1 Sink) !(Near Robot X)" -> facts with their signs.
std::vector<std::pair<std::string, bool>> signed_facts(const std::string& text);
// Whether a goal of tests/data/instructions holds: alternatives, '!', '*', '#2' (see the head of
// sensible.tsv).
bool reached(const std::string& goal, const FactSet& facts);
// The cells of each line that is no comment.
std::vector<std::vector<std::string>> read_rows(const std::string& path);

// The rooms of tests/data/instructions/worlds.json.
class Rooms {
 public:
  Rooms();  // Throws.
  // A room with changes: "(On Mug_1 Sink)" is added, "!(On Mug_1 Counter_1)" removed; what is held stands
  // nowhere.
  WorldState room(const std::string& name, const std::string& changes) const;
  const std::map<std::string, WorldState>& all() const { return rooms_; }

 private:
  std::map<std::string, WorldState> rooms_;
};

class InstructionRunner {
 public:
  // Loads the shipped model, the household domain and the rooms of tests/data/instructions/worlds.json.
  // Throws.
  InstructionRunner();

  WorldState room(const std::string& name, const std::string& changes) const {
    return rooms_.room(name, changes);
  }

  // A recorded world with all that stands in the room, where it stands: recordings list only what their facts
  // speak of.
  WorldState furnished(const WorldState& recorded) const;

  struct Run {
    bool refused = false;
    std::string message;    // why refused, or which step found no plan
    double confidence = 1;  // of the first step
    std::vector<Goal> goals;
    FactSet facts;        // in the end
    bool planned = true;  // every step found a plan
  };
  Run follow(const WorldState& world, const std::string& sentence,
             const std::map<std::string, double>* distances = nullptr);

  GoalModel& model() { return *model_; }

 private:
  std::unique_ptr<GoalModel> model_;
  std::unique_ptr<planner::Domain> domain_;
  std::unique_ptr<planner::Planner> planner_;
  Rooms rooms_;
};

}  // namespace goalnet::inference
