#include "components/planner/plan_format.h"

#include <cstdio>

namespace goalnet::planner {

std::string to_competition_format(const Plan& plan, bool with_costs) {
  std::string text;
  for (const Action& action : plan.actions) text += "(" + to_string(action) + ")\n";
  return text + "; cost = " + std::to_string(plan.cost) +
         (with_costs ? " (general cost)\n" : " (unit cost)\n");
}

std::string statistics_as_comments(const Plan& plan) {
  const Statistics& s = plan.statistics;
  char numbers[400];
  std::snprintf(
      numbers, sizeof numbers,
      "; lower bound = %lld\n; ground actions = %lld, facts = %lld\n; evaluated = %lld, expanded = %lld, "
      "generated = %lld\n; symmetries = %lld\n; grounding = %.6f s, search = %.6f s\n; search tables = %lld "
      "bytes\n",
      static_cast<long long>(plan.lower_bound), static_cast<long long>(s.ground_actions),
      static_cast<long long>(s.ground_facts), static_cast<long long>(s.evaluated),
      static_cast<long long>(s.expanded), static_cast<long long>(s.generated),
      static_cast<long long>(s.symmetries), s.grounding_seconds, s.search_seconds,
      static_cast<long long>(s.peak_bytes));
  return "; found by " + s.method + (plan.optimal ? ", optimal\n" : ", not known to be optimal\n") + numbers;
}

}  // namespace goalnet::planner
