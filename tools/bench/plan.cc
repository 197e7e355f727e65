#include "tools/bench/plan.h"

#include <fcntl.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <thread>

#include "components/core/config_path.h"
#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "components/planner/world.h"
#include "tools/bench/cpu_clock.h"
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

// Every question solved `repetitions` times by one planner; the time of each is its best, so that what is
// reported is the planner and not what else the machine does. The problem is made before the clock starts.
// CPU time, which includes about a quarter of a microsecond of reading that clock, tells the long ones apart
// from a busy machine.
class Measurement {
 public:
  Measurement(const planner::Domain& domain, int repetitions)
      : domain_(domain), planner_(domain), repetitions_(repetitions) {}

  void ask(const PlanQuestion& question) {
    auto problem = planner::make_problem(domain_, question.state, question.goal);
    if (!problem) throw std::runtime_error(question.name + ": " + problem.error().message);
    planner::SolveOptions options;
    options.time_limit = std::chrono::seconds(1);
    double best = 1e300, best_cpu = 1e300, best_with_facts = 1e300;
    Expected<planner::Plan> plan = planner::Plan{};
    for (int i = 0; i < repetitions_; ++i) {
      const double cpu_start = cpu_clock_.microseconds();
      auto start = Clock::now();
      plan = planner_.solve(*problem, options);
      best = std::min(best, microseconds_since(start));
      best_cpu = std::min(best_cpu, cpu_clock_.microseconds() - cpu_start);
      if (best > 1e5) break;  // slow ones need no repetition
      start = Clock::now();
      (void)planner_.solve(question.state, question.goal, options);
      best_with_facts = std::min(best_with_facts, microseconds_since(start));
    }
    if (!times_.empty() && best > *std::max_element(times_.begin(), times_.end())) slowest_ = question.name;
    times_.push_back(best);
    cpu_.push_back(best_cpu);
    if (best_with_facts < 1e300) with_facts_.push_back(best_with_facts);
    if (!plan) {
      (plan.error().outcome == Outcome::kNoPlan ? without_plan_ : timed_out_) += 1;
      return;
    }
    const auto valid = planner::validate(*problem, plan->actions);
    if (!valid) throw std::runtime_error(question.name + ": invalid plan: " + valid.error().message);
    optimal_ += plan->optimal ? 1 : 0;
    timed_out_ += plan->optimal ? 0 : 1;
  }

  json result() const {
    json result = summary(times_, "us");
    result["cpu"] = summary(cpu_, "us");
    result["from_facts"] = summary(with_facts_, "us");
    result["optimal"] = optimal_;
    result["no_plan"] = without_plan_;
    result["not_optimal_after_1_s"] = timed_out_;
    result["slowest"] = slowest_;
    return result;
  }

 private:
  const planner::Domain& domain_;
  planner::Planner planner_;
  const CpuClock cpu_clock_;  // of the thread that makes and uses this
  int repetitions_;
  std::vector<double> times_, cpu_, with_facts_;
  int optimal_ = 0, without_plan_ = 0, timed_out_ = 0;
  std::string slowest_;
};

json measure_scaling(const planner::Domain& domain, int repetitions) {
  json result = json::array();
  const std::vector<PlanQuestion> questions = {
      carry_question(1, 60),   carry_question(4, 60),    carry_question(10, 60),
      carry_question(10, 200), carry_question(10, 1000), carry_question(13, 1000),
      fridge_question(12),     water_question(4),        heat_question(4)};
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
    if (!planner::validate(*problem, plan->actions))
      throw std::runtime_error(question.name + ": invalid plan");
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

double parse_time(const planner::Domain& domain, const PlanQuestion& question) {
  const std::string text = as_pddl(domain, question);
  double best = 1e300;
  for (int i = 0; i < 3; ++i) {
    const auto start = Clock::now();
    const auto problem = planner::parse_problem(text, "recorded", domain);
    best = std::min(best, microseconds_since(start));
    if (!problem) throw std::runtime_error(problem.error().message);
  }
  return best;
}

// The process from start to exit, in a household problem: "goalnet plan" beside this program, if it is there.
json measure_process(int repetitions) {
  const std::string program = program_folder() + "/goalnet";
  const std::string domain = config_path("domains/household.pddl");
  char name[] = "/tmp/goalnet-bench-XXXXXX";
  const int file = mkstemp(name);
  if (file < 0 || access(program.c_str(), X_OK) != 0) return "not measured: " + program + " is not here";
  const std::string text =
      "(define (problem mug) (:domain goalnet-household) (:init (IsGraspable Mug_1) (IsGraspable Kettle) (On "
      "Mug_1 "
      "Counter_1) (On Kettle Counter_1) (HandsHold Zero) (TrayHolds Zero)) (:goal (On Mug_1 Sink)))";
  const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  double best = 1e300, best_cpu = 1e300;
  bool failed = !written;
  for (int i = 0; i < 20 * repetitions && !failed; ++i) {
    std::string arguments[] = {"goalnet", "plan", domain, name};
    char* argv[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), arguments[3].data(),
                    nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const auto start = Clock::now();
    pid_t child = 0;
    int status = 0;
    rusage usage{};
    failed = posix_spawn(&child, program.c_str(), &actions, nullptr, argv, environ) != 0 ||
             wait4(child, &status, 0, &usage) != child || status != 0;
    best = std::min(best, microseconds_since(start));
    const auto cpu_of = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_usec);
    };
    best_cpu = std::min(best_cpu, cpu_of(usage.ru_utime) + cpu_of(usage.ru_stime));
    posix_spawn_file_actions_destroy(&actions);
  }
  unlink(name);
  if (failed) throw std::runtime_error("goalnet plan failed on a household problem");
  return {{"best_us", best}, {"best_cpu_us", best_cpu}};
}

// From asking a search to stop until it has, at random moments of large problems: grounding, first estimates,
// optimal and other searches. CPU time counts the searching thread only, whatever else the machine does.
json measure_cancelling(const planner::Domain& domain, const BenchOptions& options) {
  std::vector<double> wall, cpu;
  std::mt19937_64 random(options.seed);
  PlanQuestion crowd = carry_question(3000, 3100);
  for (int i = 0; i < 40; ++i)
    crowd.goal.positive.push_back({"state", "Cup_" + std::to_string(i + 1), "Water"});
  const std::vector<PlanQuestion> questions = {heat_question(12), water_question(30), crowd,
                                               carry_question(500, 1000)};
  const int points = options.quick ? 5 : 60;
  for (const PlanQuestion& question : questions) {
    const auto problem = planner::make_problem(domain, question.state, question.goal);
    if (!problem) throw std::runtime_error(question.name + ": " + problem.error().message);
    planner::Planner planner(domain);
    for (int i = 0; i < points; ++i) {
      // Moments from 10 us to 1 s, as many early ones as late ones.
      const double delay = 10.0 * std::pow(10.0, 5.0 * static_cast<double>(random() % 10'000) / 10'000.0);
      planner::SolveOptions solve;
      std::stop_source source;
      solve.stop = source.get_token();
      const CpuClock clock;
      Clock::time_point asked;
      double used_before = 0.0;
      std::jthread canceller([&] {
        std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(delay));
        used_before = clock.microseconds();
        asked = Clock::now();
        source.request_stop();
      });
      const auto plan = planner.solve(*problem, solve);
      const auto answered = Clock::now();
      const double used_after = clock.microseconds();
      canceller.join();
      if (plan || plan.error().outcome != Outcome::kCancelled) continue;  // it was done before
      wall.push_back(std::chrono::duration<double, std::micro>(answered - asked).count());
      cpu.push_back(used_after - used_before);
    }
  }
  return {{"wall", summary(wall, "us")}, {"cpu", summary(cpu, "us")}};
}

}  // namespace

json bench_plan(const BenchOptions& options) {
  const planner::Domain domain = load(config_path("domains/benchmark.pddl"));
  const int repetitions = options.quick ? 2 : 5;
  json result;
  result["scaling"] = measure_scaling(domain, repetitions);
  const std::string folder =
      options.data.empty() ? std::string(GOALNET_SOURCE_DIR) + "/../shared/data/goalnet" : options.data;
  Measurement single(domain, repetitions), whole(domain, repetitions);
  std::vector<double> parsing;
  const bool recorded = for_each_recorded_question(
      folder, [&](const PlanQuestion& question) { single.ask(question); },
      [&](const PlanQuestion& question) {
        whole.ask(question);
        parsing.push_back(parse_time(domain, question));
      });
  if (recorded) {
    result["single"] = single.result();
    result["whole"] = whole.result();
    result["parse_problem"] = summary(parsing, "us");
  } else {
    result["recorded"] = "not measured: no demonstrations in " + folder;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_memory_mb"] =
      static_cast<double>(usage.ru_maxrss) / 1024.0;  // of the above, with all libraries of goalnet-robot
  result["process"] = measure_process(repetitions);
  result["cancel"] = measure_cancelling(domain, options);
  return result;
}

}  // namespace goalnet::tools
