#include "tools/bench/decode.h"

#include <chrono>
#include <stdexcept>

#include "components/core/config_path.h"
#include "components/goalnet/goal_model.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

WorldState kitchen() {
  WorldState world;
  world.objects = {"Counter_1", "Fridge",      "Glass_1",     "Kettle",      "Microwave",  "Mug_1",
                   "Plate_1",   "Plate_2",     "Robot",       "Sink",        "SinkKnob",   "Spoon_1",
                   "Stove",     "StoveFire_1", "StoveFire_2", "StoveFire_3", "StoveFire_4"};
  std::vector<Predicate> facts;
  for (const char* name : {"Glass_1", "Kettle", "Mug_1", "Plate_1", "Plate_2", "Spoon_1"}) {
    facts.push_back({"IsGraspable", name, ""});
    facts.push_back({"On", name, "Counter_1"});
  }
  world.facts = FactSet(facts);
  return world;
}

constexpr const char* kInstructions[] = {"fill the mug with water", "put the kettle on the stove",
                                         "open the microwave",      "put both plates in the sink",
                                         "grab the spoon",          "turn on the tap",
                                         "wash the glass",          "put the mug in the microwave"};

nlohmann::json measure(ModelUse use, const BenchOptions& options) {
  auto model = load_model(config_path("models/goalnet.safetensors"), use);
  if (!model) throw std::runtime_error(model.error().message);
  const std::vector<WorldState> states = {kitchen()};
  std::vector<double> milliseconds;
  for (int round = 0; round < (options.quick ? 2 : 20); ++round)
    for (const char* sentence : kInstructions) {  // each another than the one before: nothing is remembered
      const auto begin = std::chrono::steady_clock::now();
      const auto goal =
          (*model)->infer({.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
      const auto end = std::chrono::steady_clock::now();
      if (!goal) throw std::runtime_error(goal.error().message);
      milliseconds.push_back(std::chrono::duration<double, std::milli>(end - begin).count());
    }
  return summary(std::move(milliseconds), "ms");
}

}  // namespace

nlohmann::json bench_decode(const BenchOptions& options) {
  return {{"robot", measure(ModelUse::kRobot, options)},
          {"benchmark", measure(ModelUse::kBenchmark, options)}};
}

}  // namespace goalnet::tools
