#include "components/planner/pair_reachability.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int32_t kMostLiterals = 6000;  // 4.5 MB of rows
constexpr std::size_t kMostOperators = 150'000;
}  // namespace

void PairReachability::add_operators(const GroundTask& task, Budget& budget) {
  const auto indices = [this](auto conditions, std::vector<std::int32_t>* result) {
    for (const ConditionId condition : conditions) {
      if (condition >= 0 && index_of(condition) >= 0) result->push_back(index_of(condition));
    }
  };
  for (const GroundAction& action : task.actions) {
    if (budget.poll()) return;
    PairFixpoint::Operator base;
    indices(task.preconditions(action), &base.needs);
    std::vector<Literal> literals;  // unconditional; what is deleted and added holds afterwards
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (effect.conditional()) continue;
      std::erase(literals, opposite(effect.literal));
      literals.push_back(effect.literal);
    }
    for (const Literal literal : literals) {
      if (index_of(literal) >= 0) base.adds.push_back(index_of(literal));
      if (index_of(opposite(literal)) >= 0) base.deletes.push_back(index_of(opposite(literal)));
    }
    std::int32_t family = -1;
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (!effect.conditional() || index_of(effect.literal) < 0) continue;
      if (family < 0) family = pairs_.add_family();
      PairFixpoint::Operator op;
      op.needs = base.needs;
      indices(task.conditions_of(effect), &op.needs);
      op.adds = {index_of(effect.literal)};
      op.deletes = base.deletes;
      if (index_of(opposite(effect.literal)) >= 0) op.deletes.push_back(index_of(opposite(effect.literal)));
      op.family = family;
      pairs_.family(family).push_back(index_of(effect.literal));
      for (const std::int32_t add : base.adds) pairs_.family(family).push_back(add);
      pairs_.add(std::move(op));
    }
    if (!base.adds.empty()) pairs_.add(std::move(base));
  }
}

bool PairReachability::compute(const GroundTask& task, Budget& budget) {
  known_ = false;
  if (!task.axioms.empty()) return false;  // derived facts come and go without an action's effect
  index_.assign(task.needed.size(), -1);
  std::int32_t count = 0;
  for (std::size_t literal = 0; literal < task.needed.size(); ++literal) {
    if (task.needed[literal] != 0) index_[literal] = count++;
  }
  if (count > kMostLiterals || task.actions.size() > kMostOperators) return false;
  pairs_.restart(static_cast<std::size_t>(count));
  add_operators(task, budget);
  if (pairs_.operators() > kMostOperators || budget.check()) return false;
  std::vector<Word> initial(pairs_.words(), 0);
  for (std::size_t literal = 0; literal < task.needed.size(); ++literal) {
    const bool holds = (task.initial[literal >> 1] != 0) == ((literal & 1u) == 0);
    if (index_[literal] >= 0 && holds) PairFixpoint::set(initial.data(), index_[literal]);
  }
  pairs_.begin(initial);
  if (!pairs_.run(nullptr, budget)) return false;
  known_ = true;
  return true;
}

bool PairReachability::exclusive(Literal a, Literal b) const {
  if (b == opposite(a)) return true;
  if (!known_) return false;
  const std::int32_t p = index_of(a), q = index_of(b);
  return p >= 0 && q >= 0 && !pairs_.together(p, q);
}

bool PairReachability::impossible(std::span<const ConditionId> conditions) const {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (conditions[i] < 0 || conditions[j] < 0) continue;
      if (i != j ? exclusive(conditions[i], conditions[j])
                 : known_ && exclusive(conditions[i], conditions[i]))
        return true;
    }
  }
  return false;
}

}  // namespace goalnet::planner
