#include "tools/bench/decode.h"

#include <chrono>
#include <memory>
#include <stdexcept>

#include "components/core/config_path.h"
#include "components/goalnet/demonstration.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/lexicon.h"
#include "tools/bench/cpu_clock.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

// Both clocks of one decoding after the other.
struct Times {
  std::vector<double> wall, cpu;
  CpuClock clock;

  void measure(GoalModel& model, const StepInput& input) {
    const auto begin = std::chrono::steady_clock::now();
    const double cpu_begin = clock.microseconds();
    const auto goal = model.infer(input);
    cpu.push_back((clock.microseconds() - cpu_begin) / 1e3);
    wall.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    if (!goal) throw std::runtime_error(goal.error().message);
  }
  nlohmann::json report() const {
    nlohmann::json result = summary(wall, "ms");
    result.update(summary(cpu, "cpu_ms"));
    return result;
  }
};

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

std::unique_ptr<GoalModel> shipped_model(ModelUse use) {
  auto model = load_model(config_path("models/goalnet.safetensors"), use);
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

nlohmann::json in_kitchen(ModelUse use, const BenchOptions& options) {
  const auto model = shipped_model(use);
  const std::vector<WorldState> states = {kitchen()};
  Times times;
  for (int round = 0; round < (options.quick ? 2 : 20); ++round)
    for (const char* sentence : kInstructions)  // each another than the one before: nothing is remembered
      times.measure(*model, {.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
  return times.report();
}

nlohmann::json recorded(const std::string& folder, const BenchOptions& options) {
  const auto model = shipped_model(ModelUse::kBenchmark);
  const auto demonstrations = read_demonstrations(folder);
  if (!demonstrations) throw std::runtime_error(demonstrations.error().message);
  Symbols symbols;
  const auto lexicon = Lexicon::load(config_path("language/household.json"), symbols);
  if (!lexicon) throw std::runtime_error(lexicon.error().message);
  Times times;
  for (const Demonstration& demonstration : *demonstrations) {
    if (demonstration.perturbed || (options.quick && times.wall.size() >= 20)) continue;
    std::vector<WorldState> states = {demonstration.states.front()};
    lexicon->complete_objects(states.front());
    times.measure(*model,
                  {.sentence = demonstration.sentence, .grounding = nullptr, .states = states, .goals = {}});
  }
  return times.report();
}

}  // namespace

nlohmann::json bench_decode(const BenchOptions& options) {
  nlohmann::json result = {{"robot", in_kitchen(ModelUse::kRobot, options)},
                           {"benchmark", in_kitchen(ModelUse::kBenchmark, options)}};
  if (!options.data.empty()) result["recorded"] = recorded(options.data + "/val", options);
  return result;
}

}  // namespace goalnet::tools
