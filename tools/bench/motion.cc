#include "tools/bench/motion.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "components/manipulation/testing/physics_harness.h"

namespace goalnet::tools {
namespace {

using Sequence = std::vector<Action>;

// What a day in the kitchen asks for; every kind of action is in it.
const std::vector<Sequence>& sequences() {
  static const std::vector<Sequence> kAll = {
      {{"moveto", {"Mug_1"}},
       {"grasp", {"Mug_1"}},
       {"keep-on", {"Mug_1", "Sink"}},
       {"turn-on", {"SinkKnob"}},
       {"turn-off", {"SinkKnob"}}},
      {{"moveto", {"Kettle"}},
       {"grasp", {"Kettle"}},
       {"keep-on", {"Kettle", "StoveFire_1"}},
       {"turn-on", {"StoveKnob_1"}}},
      {{"moveto", {"Mug_1"}},
       {"grasp", {"Mug_1"}},
       {"open", {"Microwave"}},
       {"keep-in", {"Mug_1", "Microwave"}},
       {"close", {"Microwave"}},
       {"press-on", {"MicrowaveButton"}}},
      {{"moveto", {"Plate_1"}},
       {"grasp", {"Plate_1"}},
       {"grasp", {"Plate_2"}},
       {"keep-on", {"Plate_1", "Sink"}},
       {"keep-on", {"Plate_2", "Sink"}}},
      {{"moveto", {"Coke_1"}},
       {"grasp", {"Coke_1"}},
       {"stow", {"Coke_1"}},
       {"open", {"FridgeLeftDoor"}},
       {"unstow", {"Coke_1"}},
       {"keep-in", {"Coke_1", "FridgeLeft"}}},
      {{"moveto", {"Spoon_1"}}, {"grasp", {"Spoon_1"}}, {"release", {"Spoon_1"}}},
  };
  return kAll;
}

}  // namespace

nlohmann::json bench_motion(const BenchOptions& options) {
  std::vector<double> planning_ms, simulated_s;
  std::size_t asked = 0, done = 0, retries = 0;
  nlohmann::json failures = nlohmann::json::array();
  const std::uint64_t seeds = options.quick ? 1 : 3;
  for (std::uint64_t seed = options.seed; seed < options.seed + seeds; ++seed) {
    for (const auto& sequence : sequences()) {
      auto harness = manipulation::PhysicsHarness::create("kitchen", "default", seed);
      if (!harness) throw std::runtime_error(harness.error().message);
      for (const auto& action : sequence) {
        const auto result = (*harness)->run(action);
        ++asked;
        retries += static_cast<std::size_t>(result.attempts);
        planning_ms.push_back(result.planning_time * 1e3);
        simulated_s.push_back(result.sim_time);
        if (result.result.outcome != Outcome::kDone) {
          failures.push_back(
              {{"seed", seed}, {"action", to_string(action)}, {"message", result.result.message}});
          break;  // what follows needs this one
        }
        ++done;
      }
    }
  }
  return {{"planning_per_action", summary(planning_ms, "ms")},
          {"simulated_per_action", summary(simulated_s, "s")},
          {"actions", asked},
          {"done", done},
          {"other_ways_tried", retries},
          {"failures", failures}};
}

}  // namespace goalnet::tools
