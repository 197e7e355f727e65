#include "tools/bench/plan.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "components/core/config_path.h"
#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "components/planner/world.h"
#include "tools/bench/plan_problems.h"

namespace goalnet::tools {
namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::json;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

planner::Domain load(const std::string& path) {
  auto domain = planner::load_domain(path);
  if (!domain) throw std::runtime_error(domain.error().message);
  return std::move(*domain);
}

// Every question solved `repetitions` times by one planner; the time of each is its best, so that what is reported is
// the planner and not what else the machine does. The problem is made before the clock starts.
json measure(const planner::Domain& domain, const std::vector<PlanQuestion>& questions, int repetitions) {
  planner::Planner planner(domain);
  std::vector<double> times, with_facts;
  int optimal = 0, without_plan = 0, timed_out = 0;
  std::string slowest;
  for (const PlanQuestion& question : questions) {
    auto problem = planner::make_problem(domain, question.state, question.goal);
    if (!problem) throw std::runtime_error(question.name + ": " + problem.error().message);
    planner::SolveOptions options;
    options.time_limit = std::chrono::seconds(1);
    double best = 1e300, best_with_facts = 1e300;
    Expected<planner::Plan> plan = planner::Plan{};
    for (int i = 0; i < repetitions; ++i) {
      auto start = Clock::now();
      plan = planner.solve(*problem, options);
      best = std::min(best, microseconds_since(start));
      if (best > 1e5) break;  // slow ones need no repetition
      start = Clock::now();
      (void)planner.solve(question.state, question.goal, options);
      best_with_facts = std::min(best_with_facts, microseconds_since(start));
    }
    if (!times.empty() && best > *std::max_element(times.begin(), times.end())) slowest = question.name;
    times.push_back(best);
    if (best_with_facts < 1e300) with_facts.push_back(best_with_facts);
    if (!plan) {
      (plan.error().outcome == Outcome::kNoPlan ? without_plan : timed_out) += 1;
      continue;
    }
    const auto valid = planner::validate(*problem, plan->actions);
    if (!valid) throw std::runtime_error(question.name + ": invalid plan: " + valid.error().message);
    optimal += plan->optimal ? 1 : 0;
    timed_out += plan->optimal ? 0 : 1;
  }
  json result = summary(times, "us");
  result["from_facts"] = summary(with_facts, "us");
  result["optimal"] = optimal;
  result["no_plan"] = without_plan;
  result["not_optimal_after_1_s"] = timed_out;
  result["slowest"] = slowest;
  return result;
}

json measure_scaling(const planner::Domain& domain, int repetitions) {
  json result = json::array();
  const std::vector<PlanQuestion> questions = {
      carry_question(1, 60),   carry_question(4, 60),    carry_question(10, 60), carry_question(10, 200),
      carry_question(10, 1000), carry_question(13, 1000), fridge_question(12),    water_question(4),
      heat_question(4)};
  for (const PlanQuestion& question : questions) {
    planner::Planner planner(domain);
    auto problem = planner::make_problem(domain, question.state, question.goal);
    if (!problem) throw std::runtime_error(question.name + ": " + problem.error().message);
    double best = 1e300;
    Expected<planner::Plan> plan = planner::Plan{};
    for (int i = 0; i < repetitions; ++i) {
      const auto start = Clock::now();
      plan = planner.solve(*problem);
      best = std::min(best, microseconds_since(start));
      if (best > 1e5) break;
    }
    if (!plan) throw std::runtime_error(question.name + ": " + plan.error().message);
    if (!planner::validate(*problem, plan->actions)) throw std::runtime_error(question.name + ": invalid plan");
    result.push_back({{"problem", question.name},
                      {"actions", plan->actions.size()},
                      {"time_us", best},
                      {"optimal", plan->optimal},
                      {"method", plan->statistics.method},
                      {"expanded", plan->statistics.expanded}});
  }
  return result;
}

// The text of a recorded problem: 59 objects and its facts.
std::string as_pddl(const planner::Domain& domain, const PlanQuestion& question) {
  std::string text = "(define (problem recorded) (:domain " + domain.name + ")\n(:objects";
  for (const std::string& object : question.state.objects) {
    if (domain.constants.find(object) < 0) text += " " + object;
  }
  text += " - thing)\n(:init";
  for (const Predicate& fact : question.state.facts) text += "\n" + to_string(fact);
  text += ")\n(:goal (and";
  for (const Predicate& fact : question.goal.positive) text += " " + to_string(fact);
  for (const Predicate& fact : question.goal.negative) text += " (not " + to_string(fact) + ")";
  return text + ")))\n";
}

json measure_parsing(const planner::Domain& domain, const std::vector<PlanQuestion>& questions) {
  std::vector<double> times;
  for (const PlanQuestion& question : questions) {
    const std::string text = as_pddl(domain, question);
    double best = 1e300;
    for (int i = 0; i < 3; ++i) {
      const auto start = Clock::now();
      const auto problem = planner::parse_problem(text, "recorded", domain);
      best = std::min(best, microseconds_since(start));
      if (!problem) throw std::runtime_error(problem.error().message);
    }
    times.push_back(best);
  }
  return summary(times, "us");
}

}  // namespace

json bench_plan(const BenchOptions& options) {
  const planner::Domain domain = load(config_path("domains/benchmark.pddl"));
  const int repetitions = options.quick ? 2 : 5;
  json result;
  result["scaling"] = measure_scaling(domain, repetitions);
  const std::string folder =
      options.data.empty() ? std::string(GOALNET_SOURCE_DIR) + "/../shared/data/goalnet" : options.data;
  const RecordedQuestions recorded = recorded_questions(folder);
  if (recorded.whole.empty()) {
    result["recorded"] = "not measured: no demonstrations in " + folder;
  } else {
    result["single"] = measure(domain, recorded.single, repetitions);
    result["whole"] = measure(domain, recorded.whole, repetitions);
    result["parse_problem"] = measure_parsing(domain, recorded.whole);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_memory_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return result;
}

}  // namespace goalnet::tools
