#include "components/goalnet/evaluation.h"

#include <atomic>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "components/goalnet/random.h"

namespace goalnet::inference {
namespace {

std::set<std::string> scenarios_of(const std::vector<Demonstration>& demonstrations) {
  std::set<std::string> scenarios;
  for (const Demonstration& demonstration : demonstrations) scenarios.insert(demonstration.scenario);
  return scenarios;
}

}  // namespace

ModelRun run_model(GoalModel& model, const Demonstration& demonstration, const Lexicon& lexicon,
                   const EvaluationOptions& options, const GoalPlanner& planner, Symbols& symbols) {
  ModelRun run;
  run.id = demonstration.id;
  WorldState world = demonstration.states.front();
  lexicon.complete_objects(world);
  std::vector<WorldState> states = {world};
  std::vector<Goal> goals;
  SymState now = to_sym_state(world.facts, symbols);
  while (goals.size() < options.max_steps && run.actions.size() < options.max_actions) {
    const auto goal = model.infer({.sentence = demonstration.sentence,
                                   .grounding = options.grounding ? &demonstration.grounding : nullptr,
                                   .states = states,
                                   .goals = goals});
    if (!goal) {
      run.refusal = goal.error().message;
      break;
    }
    if (goal->empty()) break;
    if (goals.empty()) run.confidence = goal->confidence;
    const auto plan = planner.plan(to_sym_goal(*goal, symbols), now);
    if (plan) {
      for (const SymAction& action : *plan) {
        apply(action, now);
        run.actions.push_back(to_string(action, symbols));
      }
    }
    goals.push_back(*goal);
    states.push_back({world.objects, to_fact_set(now, symbols)});
  }
  run.final_state = states.back().facts;
  run.scores = score_run(demonstration.states.front().facts, demonstration.states.back().facts,
                         demonstration.actions, run.final_state, run.actions);
  return run;
}

Expected<Evaluation> evaluate(const ModelFactory& factory, const std::vector<Demonstration>& demonstrations,
                              const Lexicon& lexicon, const EvaluationOptions& options,
                              const FullPlanner& full_planner) {
  Evaluation evaluation;
  evaluation.runs.resize(demonstrations.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  std::optional<Error> failure;
  const auto work = [&] {
    auto model = factory();
    if (!model) {
      const std::lock_guard lock(mutex);
      failure = model.error();
      return;
    }
    const GoalPlanner planner(full_planner);
    Symbols symbols;
    for (std::size_t i = next++; i < demonstrations.size(); i = next++) {
      evaluation.runs[i] = run_model(**model, demonstrations[i], lexicon, options, planner, symbols);
      const std::lock_guard lock(mutex);
      ++done;
      if (options.progress) options.progress(done, demonstrations.size());
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  threads.clear();  // joins
  if (failure) return tl::unexpected(*failure);
  for (const ModelRun& run : evaluation.runs) evaluation.mean += run.scores;
  if (!evaluation.runs.empty())
    evaluation.mean = evaluation.mean / static_cast<double>(evaluation.runs.size());
  return evaluation;
}

Expected<void> write_runs(const std::vector<ModelRun>& runs, const std::filesystem::path& path) {
  std::ofstream file(path);
  for (const ModelRun& run : runs) {
    nlohmann::json state = nlohmann::json::array();
    for (const Predicate& fact : run.final_state) state.push_back(to_string(fact));
    const nlohmann::json line = {{"id", run.id}, {"actions", run.actions}, {"final_state", state}};
    // A file name need not be UTF-8.
    file << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  }
  file.flush();
  if (!file) return fail(Outcome::kInvalidRequest, path.string() + ": cannot be written");
  return {};
}

ScenarioFolds::ScenarioFolds(const std::vector<Demonstration>& demonstrations, int folds, std::uint64_t seed)
    : ScenarioFolds(scenarios_of(demonstrations), folds, seed) {}

ScenarioFolds::ScenarioFolds(const std::set<std::string>& scenarios, int folds, std::uint64_t seed) {
  std::vector<std::string> order(scenarios.begin(), scenarios.end());
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  for (std::size_t i = 0; i < order.size(); ++i) fold_[order[i]] = static_cast<int>(i) % folds;
}

int ScenarioFolds::fold_of(const std::string& scenario) const {
  const auto it = fold_.find(scenario);
  return it == fold_.end() ? -1 : it->second;
}

}  // namespace goalnet::inference
