// The problem sets of `goalnet bench plan`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::tools {

struct PlanQuestion {
  std::string name;
  WorldState state;
  Goal goal;
};

// Gives one recorded question after the other, so that never all are in memory: `single` asks for a recorded
// state to the next recorded difference, `whole` for the start to the net difference. Returns false if the
// folder does not have the demonstrations.
bool for_each_recorded_question(const std::filesystem::path& folder,
                                const std::function<void(const PlanQuestion&)>& single,
                                const std::function<void(const PlanQuestion&)>& whole);

// `count` objects on the counter to the table, in a room with `room` objects.
PlanQuestion carry_question(int count, int room);
// Twelve objects into the fridge, whose doors are closed.
PlanQuestion fridge_question(int count);
// Water into `count` empty cups; heat `count` cups.
PlanQuestion water_question(int count);
PlanQuestion heat_question(int count);

}  // namespace goalnet::tools
