// The loop that the benchmark scores: predict, plan, apply, predict again, until nothing is predicted or the
// step limit is met.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/goal_planner.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/scoring.h"

namespace goalnet::inference {

struct EvaluationOptions {
  bool grounding = true;       // pass the demonstrations' grounding to the model
  std::size_t max_steps = 30;  // predictions a run
  std::size_t max_actions = 200;
  unsigned threads = 1;
  std::function<void(std::size_t done, std::size_t all)> progress;  // called from one thread at a time
};

// What a model did for one demonstration.
struct ModelRun {
  std::string id;
  std::vector<std::string> actions;  // in the demonstrations' spelling
  FactSet final_state;
  Scores scores;
  double confidence = 0;  // of the first prediction; 0 when there was none
  std::string refusal;    // the model's message when it refused; the run then did nothing more
};

struct Evaluation {
  std::vector<ModelRun> runs;  // in the order of the demonstrations
  Scores mean;
};

using ModelFactory = std::function<Expected<std::unique_ptr<GoalModel>>()>;  // one model for each thread

// Runs and scores every demonstration given. The result does not depend on the number of threads. Fails only
// when the factory does.
Expected<Evaluation> evaluate(const ModelFactory& factory, const std::vector<Demonstration>& demonstrations,
                              const Lexicon& lexicon, const EvaluationOptions& options,
                              const FullPlanner& full_planner = {});

// One run: exactly the loop above, for tests and other drivers.
ModelRun run_model(GoalModel& model, const Demonstration& demonstration, const Lexicon& lexicon,
                   const EvaluationOptions& options, const GoalPlanner& planner, Symbols& symbols);

// One JSON object a line, for ../shared/tools/score.py: {"id", "actions", "final_state"}.
Expected<void> write_runs(const std::vector<ModelRun>& runs, const std::filesystem::path& path);

// Folds grouped by scenario: which of `folds` a scenario is tested in. The same on every machine.
class ScenarioFolds {
 public:
  ScenarioFolds(const std::vector<Demonstration>& demonstrations, int folds, std::uint64_t seed = 7);
  explicit ScenarioFolds(const std::set<std::string>& scenarios, int folds, std::uint64_t seed = 7);
  int fold_of(const std::string& scenario) const;

 private:
  std::map<std::string, int> fold_;
};

}  // namespace goalnet::inference
