#include "tools/goalnet/plan_command.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "components/planner/plan_format.h"
#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "tools/goalnet/command_line.h"

namespace goalnet::tools {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  goalnet plan domain.pddl problem.pddl\n"
    "  goalnet plan domain.pddl problem.pddl --satisficing --statistics\n"
    "  goalnet plan domain.pddl problem.pddl --time-limit 60 --proof-limit 0 --json\n"
    "\n"
    "exit codes: 0 a plan was found; 11 an unknown object; 12 there is no plan; 13 a slip in a file or an "
    "argument;\n"
    "20 no plan within the limits of time and memory; 22 Ctrl-C before a plan was found (after that it "
    "prints\n"
    "the best plan so far).";

struct Options {
  std::string domain, problem;
  double time_limit = 20.0;
  double proof_limit = 5.0;
  double memory_limit = 1024.0;
  bool satisficing = false, statistics = false, json = false;
};

// A signal handler can only reach something static. request_stop without callbacks is one atomic operation.
std::stop_source& interruption() {
  static std::stop_source source;
  return source;
}

void on_signal(int) { interruption().request_stop(); }

// The most memory this program had, in megabytes; 0 where the system does not tell.
double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024.0;
  }
  return 0.0;
}

nlohmann::json to_json(const planner::Plan& plan) {
  nlohmann::json actions = nlohmann::json::array();
  for (const Action& action : plan.actions)
    actions.push_back({{"name", action.name}, {"arguments", action.arguments}});
  const planner::Statistics& s = plan.statistics;
  return {{"actions", actions},
          {"cost", plan.cost},
          {"lower_bound", plan.lower_bound},
          {"optimal", plan.optimal},
          {"statistics",
           {{"method", s.method},
            {"ground_actions", s.ground_actions},
            {"ground_facts", s.ground_facts},
            {"evaluated", s.evaluated},
            {"expanded", s.expanded},
            {"generated", s.generated},
            {"symmetries", s.symmetries},
            {"search_table_bytes", s.peak_bytes},
            {"peak_memory_mb", peak_memory_mb()},
            {"grounding_s", s.grounding_seconds},
            {"search_s", s.search_seconds}}}};
}

// On a terminal, one line for each plan that is better than those before.
void show_progress(const planner::Plan& plan, double seconds) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(
      stderr, "%.1f s: a plan of cost %lld, none costs less than %lld; looking on (Ctrl-C prints the best)\n",
      seconds, static_cast<long long>(plan.cost), static_cast<long long>(plan.lower_bound));
}

Expected<planner::Plan> make_plan(const Options& options, bool* with_costs) {
  const auto start = std::chrono::steady_clock::now();
  const auto domain = planner::load_domain(options.domain, interruption().get_token());
  if (!domain) return tl::unexpected(domain.error());
  const auto problem = planner::load_problem(options.problem, *domain, interruption().get_token());
  if (!problem) return tl::unexpected(problem.error());
  *with_costs = problem->minimise_cost;
  planner::SolveOptions solve;
  solve.time_limit = std::chrono::nanoseconds(static_cast<std::int64_t>(options.time_limit * 1e9));
  solve.proof_limit = std::chrono::nanoseconds(static_cast<std::int64_t>(options.proof_limit * 1e9));
  solve.memory_limit = static_cast<std::int64_t>(options.memory_limit * 1024 * 1024);
  solve.satisficing = options.satisficing;
  solve.stop = interruption().get_token();
  std::optional<planner::Plan> best;
  solve.on_plan = [&](const planner::Plan& plan) {
    best = plan;
    show_progress(plan, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  };
  auto plan = planner::solve(*domain, *problem, solve);
  if (!plan && plan.error().outcome == Outcome::kCancelled && best) plan = std::move(*best);
  if (!plan) return plan;
  // Nobody should act on a plan that was not replayed.
  if (const auto valid = planner::validate(*problem, plan->actions); !valid) {
    return fail(Outcome::kInternal,
                "the plan found is not valid; please report this problem: " + valid.error().message);
  }
  return plan;
}

}  // namespace

int plan_command(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Solves a PDDL problem (PDDL 2.1's ADL part, action costs, derived predicates) and prints a cheapest "
      "plan.");
  app.name("goalnet plan");
  app.footer(kFooter);
  app.add_option("domain", options.domain, "PDDL domain file")->required();
  app.add_option("problem", options.problem, "PDDL problem file")->required();
  app.add_option("--time-limit", options.time_limit,
                 "seconds; then the best plan so far is printed, which may not be optimal (0: no limit)")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_option(
         "--proof-limit", options.proof_limit,
         "seconds for proving a plan that was found optimal, or improving it (0: up to the time limit)")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--memory-limit", options.memory_limit, "megabytes for the search's tables")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  app.add_flag("--satisficing", options.satisficing, "any plan will do");
  app.add_flag("--statistics", options.statistics, "also print what the search did, as comments");
  app.add_flag("--json", options.json, "print one JSON object");
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  bool with_costs = false;
  const auto plan = make_plan(options, &with_costs);
  if (!plan) return tell(app.get_name(), plan.error(), options.json);
  if (options.json) {
    nlohmann::json json = to_json(*plan);
    json["outcome"] = to_string(Outcome::kDone);
    json["message"] = "";
    print_json(json, 2);
  } else {
    std::fputs(planner::to_competition_format(*plan, with_costs).c_str(), stdout);
    if (!plan->optimal) {
      std::printf("; not known to be optimal: no plan costs less than %lld\n",
                  static_cast<long long>(plan->lower_bound));
    }
    if (options.statistics) {
      std::fputs(planner::statistics_as_comments(*plan).c_str(), stdout);
      std::printf("; peak memory = %.1f MB\n", peak_memory_mb());
    }
  }
  return 0;
}

}  // namespace goalnet::tools
