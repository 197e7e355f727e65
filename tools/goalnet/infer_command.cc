#include "tools/goalnet/infer_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "components/core/config_path.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/goal_planner.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/world_file.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;
using nlohmann::json;

json texts(const std::vector<Predicate>& facts) {
  json list = json::array();
  for (const Predicate& fact : facts) list.push_back(to_string(fact));
  return list;
}

}  // namespace

int infer_command(int argc, char** argv) {
  CLI::App app("Infers the goals of an instruction in a given world.", "goalnet infer");
  std::string state, instruction, model_file = config_path("models/goalnet.safetensors");
  std::size_t steps = 30;
  bool as_json = false;
  app.footer(
      "Examples:\n"
      "  goalnet infer state.json \"put the mug in the sink\"\n"
      "  goalnet run --json \"turn on the tap\" > run.json; goalnet infer run.json \"turn it off\"\n"
      "\n"
      "exit codes: 0 understood; 10 not understood, or nothing here is meant; 11 unknown object; 13 a slip "
      "in "
      "the file or an argument.");
  app.add_option("STATE.json", state,
                 "the world: {\"objects\": [...], \"facts\": [\"(On Mug_1 Sink)\", ...]}")
      ->required();
  app.add_option("INSTRUCTION", instruction, "what to do, in plain English")->required();
  app.add_option("--model", model_file, "model file")->capture_default_str();
  app.add_option("--steps", steps, "at most so many steps")->check(CLI::Range(1, 30))->capture_default_str();
  app.add_flag("--json", as_json, "print one JSON object");
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  const auto file = read_world(state);
  if (!file) return tell(app.get_name(), file.error(), as_json);
  const WorldState& world = file->world;
  auto model = load_model(model_file);
  if (!model) return tell(app.get_name(), model.error(), as_json);

  Symbols symbols;
  const GoalPlanner planner;
  std::vector<WorldState> states = {world};
  std::vector<Goal> goals;
  json list = json::array();
  Error problem{Outcome::kDone, ""};
  SymState now = to_sym_state(world.facts, symbols);
  while (goals.size() < steps) {
    const auto goal =
        (*model)->infer({.sentence = instruction, .grounding = nullptr, .states = states, .goals = goals});
    if (!goal) {
      problem = goal.error();
      break;
    }
    if (goal->empty()) break;
    json actions = json::array();
    const auto plan = planner.plan(to_sym_goal(*goal, symbols), now);
    if (plan)
      for (const SymAction& action : *plan) {
        apply(action, now);
        actions.push_back(to_string(action, symbols));
      }
    list.push_back({{"positive", texts(goal->positive)},
                    {"negative", texts(goal->negative)},
                    {"confidence", goal->confidence},
                    {"actions", actions}});
    goals.push_back(*goal);
    states.push_back({world.objects, to_fact_set(now, symbols)});
  }
  if (as_json) {
    print_json({{"instruction", instruction},
                {"model", (*model)->kind()},
                {"outcome", to_string(problem.outcome)},
                {"message", problem.message},
                {"steps", list}});
  } else {
    for (std::size_t i = 0; i < list.size(); ++i) {
      std::printf("%zu.", i + 1);
      for (const json& fact : list[i]["positive"])
        std::printf(" %s", fact.get_ref<const std::string&>().c_str());
      for (const json& fact : list[i]["negative"])
        std::printf(" not %s", fact.get_ref<const std::string&>().c_str());
      std::printf("   confidence %.2f\n", list[i]["confidence"].get<double>());
    }
    if (problem.outcome == Outcome::kDone)
      std::printf(list.empty() ? "Nothing is left to do.\n" : "Then nothing is left to do.\n");
  }
  if (problem.outcome != Outcome::kDone) return tell(app.get_name(), problem, false);
  return 0;
}

}  // namespace goalnet::tools
