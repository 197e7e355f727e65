// The problem sets of `goalnet bench plan`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::tools {

struct PlanQuestion {
  std::string name;
  WorldState state;
  Goal goal;
};

struct RecordedQuestions {
  std::vector<PlanQuestion> single;  // a recorded state to the next recorded difference
  std::vector<PlanQuestion> whole;   // the start to the net difference
};

// Empty if the folder does not have the demonstrations.
RecordedQuestions recorded_questions(const std::filesystem::path& folder);

// `count` objects on the counter to the table, in a room with `room` objects.
PlanQuestion carry_question(int count, int room);
// Twelve objects into the fridge, whose doors are closed.
PlanQuestion fridge_question(int count);
// Water into `count` empty cups; heat `count` cups.
PlanQuestion water_question(int count);
PlanQuestion heat_question(int count);

}  // namespace goalnet::tools
