#include "components/coordinator/expectation.h"

#include <algorithm>

namespace goalnet::coordinator {
namespace {

bool is_free_of_choice(const Predicate& fact) { return fact.relation == "Held"; }

void append(std::string& text, const char* introduction, const std::vector<Predicate>& facts) {
  constexpr std::size_t kShown = 4;
  if (facts.empty()) return;
  if (!text.empty()) text += ", ";
  text += introduction;
  for (std::size_t i = 0; i < std::min(facts.size(), kShown); ++i) {
    text += (i == 0 ? " " : ", ") + goalnet::to_string(facts[i]);
  }
  if (facts.size() > kShown) text += " and " + std::to_string(facts.size() - kShown) + " more";
}

}  // namespace

bool is_robot_near(const Predicate& fact) {
  return fact.relation == "Near" && (fact.subject == "Robot" || fact.object == "Robot");
}

Expectation expected_change(const FactSet& before, const FactSet& predicted) {
  std::vector<Predicate> added, removed;
  for (const Predicate& fact : difference(predicted, before)) {
    if (!is_free_of_choice(fact)) added.push_back(fact);
  }
  for (const Predicate& fact : difference(before, predicted)) {
    if (!is_free_of_choice(fact) && !is_robot_near(fact)) removed.push_back(fact);
  }
  return {FactSet(std::move(added)), FactSet(std::move(removed))};
}

Shortfall shortfall(const Expectation& expectation, const FactSet& facts) {
  Shortfall result;
  for (const Predicate& fact : expectation.added) {
    if (!facts.contains(fact)) result.missing.push_back(fact);
  }
  for (const Predicate& fact : expectation.removed) {
    if (facts.contains(fact)) result.remaining.push_back(fact);
  }
  return result;
}

bool only_besides(const Shortfall& shortfall, const Expectation& expectation, const Action& action,
                  const Goal& goal) {
  const std::size_t expected = expectation.added.size() + expectation.removed.size();
  if (shortfall.missing.size() + shortfall.remaining.size() >= expected) return false;
  const auto among = [](const auto& list, const auto& one) {
    return std::find(list.begin(), list.end(), one) != list.end();
  };
  const auto besides = [&](const Predicate& fact, const std::vector<Predicate>& asked_for) {
    return !among(action.arguments, fact.subject) && !among(action.arguments, fact.object) &&
           !among(asked_for, fact);
  };
  return std::all_of(shortfall.missing.begin(), shortfall.missing.end(),
                     [&](const Predicate& fact) { return besides(fact, goal.positive); }) &&
         std::all_of(shortfall.remaining.begin(), shortfall.remaining.end(),
                     [&](const Predicate& fact) { return besides(fact, goal.negative); });
}

Goal taking_in_hand(const Shortfall& shortfall, const Action& action, const FactSet& facts,
                    const Goal& goal) {
  const auto may_be_taken = [&](const Predicate& missing) {
    const std::string& thing = missing.subject;
    const auto stands = [&](const Predicate& fact) { return fact.relation == "On" && fact.subject == thing; };
    return missing.relation == "state" &&
           std::ranges::find(action.arguments, thing) == action.arguments.end() &&
           std::ranges::any_of(facts, stands);
  };
  const auto asked_for = [&](const Predicate& missing) {
    return std::ranges::find(goal.positive, missing) != goal.positive.end();
  };
  const auto taking = [](const Predicate& missing) {
    return Goal{{{"Grasping", "Robot", missing.subject}}, {}, 1.0};
  };
  for (const Predicate& missing : shortfall.missing)
    if (may_be_taken(missing) && asked_for(missing)) return taking(missing);
  for (const Predicate& missing : shortfall.missing)
    if (may_be_taken(missing)) return taking(missing);
  return {};
}

std::string to_string(const Shortfall& shortfall) {
  std::string text;
  append(text, "lacks", shortfall.missing);
  append(text, "still has", shortfall.remaining);
  return text;
}

Shortfall goal_shortfall(const Goal& goal, const FactSet& facts, const FactSet& visited) {
  const bool visits_only = std::all_of(goal.positive.begin(), goal.positive.end(), is_robot_near);
  Shortfall result;
  for (const Predicate& fact : goal.positive) {
    if (facts.contains(fact)) continue;
    if (is_robot_near(fact) && (!visits_only || visited.contains(fact))) continue;
    result.missing.push_back(fact);
  }
  for (const Predicate& fact : goal.negative) {
    if (facts.contains(fact) && !is_robot_near(fact)) result.remaining.push_back(fact);
  }
  return result;
}

}  // namespace goalnet::coordinator
