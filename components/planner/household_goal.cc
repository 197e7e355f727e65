#include "components/planner/household_goal.h"

#include <algorithm>

namespace goalnet::planner {

std::vector<Goal> normalise_household_goal(const Goal& goal) {
  const auto is_near = [](const Predicate& fact) {
    return fact.relation == "Near" && fact.subject == "Robot";
  };
  const bool only_near = std::all_of(goal.positive.begin(), goal.positive.end(), is_near);
  Goal rest;
  rest.confidence = goal.confidence;
  std::copy_if(goal.negative.begin(), goal.negative.end(), std::back_inserter(rest.negative),
               [&](const Predicate& fact) { return !is_near(fact); });
  if (!only_near) {
    std::copy_if(goal.positive.begin(), goal.positive.end(), std::back_inserter(rest.positive),
                 [&](const Predicate& fact) { return !is_near(fact); });
    return {rest};
  }
  std::vector<Goal> goals;
  if (!rest.negative.empty() || goal.positive.empty()) goals.push_back(rest);
  for (const Predicate& fact : goal.positive) goals.push_back(Goal{{fact}, {}, goal.confidence});
  return goals;
}

std::string misfit(const Goal& goal, const FactSet& facts) {
  for (const Predicate& wanted : goal.positive) {
    for (const Predicate& fact : facts) {
      if (fact.relation != "Unfit") continue;
      const bool place = (wanted.relation == "On" || wanted.relation == "In") &&
                         wanted.subject == fact.subject && wanted.object == fact.object;
      // A content that is there once the thing is: (state Glass_1 Ramen).
      const bool content = wanted.relation == "state" && wanted.subject == fact.object &&
                           fact.subject.find(wanted.object) != std::string::npos;
      if (place || content)
        return fact.subject + " does not fit " + (wanted.relation == "On" ? "onto " : "into ") + fact.object +
               ": it is too large";
    }
  }
  return "";
}

}  // namespace goalnet::planner
