#include "components/planner/goal_mutex.h"

#include <algorithm>
#include <span>

namespace goalnet::planner {
namespace {

using Pair = std::pair<Literal, Literal>;
Pair ordered(Literal a, Literal b) { return a < b ? Pair{a, b} : Pair{b, a}; }

class Prover {
 public:
  Prover(const GroundTask& task, Budget& budget) : task_(task), budget_(budget) {
    for (std::size_t i = 0; i <= task.needed.size(); ++i) {
      if (budget.poll()) return;
      begin_.push_back(0);
    }
    const auto each = [&](const auto& visit) {
      for (std::size_t a = task.actions.size(); a-- > 0 && !budget.poll();) {
        for (const GroundEffect& effect : task.effects_of(task.actions[a]))
          visit(static_cast<std::size_t>(effect.literal), static_cast<std::int32_t>(a));
      }
    };
    each([&](std::size_t literal, std::int32_t) { ++begin_[literal]; });
    std::uint32_t total = 0;
    for (std::uint32_t& end : begin_) {
      if (budget.poll()) return;
      end = total += end;
    }
    actions_.resize_for_overwrite(total);
    each([&](std::size_t literal, std::int32_t action) { actions_[--begin_[literal]] = action; });
  }

  // Assumes the pair and all that its proof needs, until nothing is left to show or something fails.
  bool prove(Literal p, Literal q) {
    assumed_.clear();
    open_.clear();
    if (!assume(ordered(p, q))) return false;
    while (!open_.empty()) {
      const Pair pair = open_.back();
      open_.pop_back();
      if (!step(pair.first, pair.second) || !step(pair.second, pair.first)) return false;
      if (assumed_.size() > kMostPairs || budget_.poll()) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kMostPairs = 64;

  // In the order of the actions.
  std::span<const std::int32_t> producers(Literal literal) const {
    const auto i = static_cast<std::size_t>(literal);
    return {actions_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  bool initially(Literal literal) const {
    return (task_.initial[static_cast<std::size_t>(literal >> 1)] != 0) == ((literal & 1) == 0);
  }

  bool assume(Pair pair) {
    if (pair.second == opposite(pair.first)) return true;  // trivially
    if (pair.first == pair.second || (initially(pair.first) && initially(pair.second))) return false;
    if (std::find(assumed_.begin(), assumed_.end(), pair) != assumed_.end()) return true;
    assumed_.push_back(pair);
    open_.push_back(pair);
    return true;
  }

  // No action that produces p leaves q true.
  bool step(Literal p, Literal q) {
    for (const std::int32_t a : producers(p)) {
      if (budget_.poll()) return false;
      const GroundAction& action = task_.actions[static_cast<std::size_t>(a)];
      bool destroys = false, produces = false;
      for (const GroundEffect& effect : task_.effects_of(action)) {
        destroys = destroys || (effect.literal == opposite(q) && !effect.conditional());
        produces = produces || effect.literal == q;
      }
      if (produces) return false;
      if (destroys) continue;
      // A precondition that excludes q: q's opposite, or something for which the same must be shown.
      const auto needs = task_.preconditions(action);
      if (std::find(needs.begin(), needs.end(), opposite(q)) != needs.end()) continue;
      const bool excluded = std::any_of(needs.begin(), needs.end(), [&](ConditionId r) {
        return r >= 0 && r != p &&
               std::find(assumed_.begin(), assumed_.end(), ordered(r, q)) != assumed_.end();
      });
      if (excluded) continue;
      const bool shown = std::any_of(needs.begin(), needs.end(), [&](ConditionId r) {
        return r >= 0 && r != q && !initially_together(r, q) && plausible(r, q) && assume(ordered(r, q));
      });
      if (!shown) return false;
    }
    return true;
  }

  bool initially_together(Literal r, Literal q) const { return initially(r) && initially(q); }

  // Every producer of r destroys q at once: the cheap sufficient look before assuming.
  bool plausible(Literal r, Literal q) const {
    const auto makers = producers(r);
    return !makers.empty() && std::all_of(makers.begin(), makers.end(), [&](std::int32_t a) {
      const auto effects = task_.effects_of(task_.actions[static_cast<std::size_t>(a)]);
      return std::any_of(effects.begin(), effects.end(), [&](const GroundEffect& effect) {
        return effect.literal == opposite(q) && !effect.conditional();
      });
    });
  }

  const GroundTask& task_;
  Budget& budget_;
  Growing<std::uint32_t> begin_;  // by literal: first of its producers in actions_
  Growing<std::int32_t> actions_;
  std::vector<Pair> assumed_, open_;
};

}  // namespace

std::optional<std::pair<Literal, Literal>> find_goal_mutex(const GroundTask& task, Budget& budget) {
  constexpr std::size_t kMostGoals = 60;
  if (task.goal.size() > kMostGoals || !task.axioms.empty()) return std::nullopt;
  Prover prover(task, budget);
  if (budget.stopped()) return std::nullopt;
  for (std::size_t i = 0; i < task.goal.size(); ++i) {
    for (std::size_t j = 0; j < i && !budget.poll(); ++j) {
      if (task.goal[i] < 0 || task.goal[j] < 0) continue;
      if (prover.prove(task.goal[i], task.goal[j])) return Pair{task.goal[j], task.goal[i]};
    }
  }
  return std::nullopt;
}

}  // namespace goalnet::planner
