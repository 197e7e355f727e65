// In what order landmarks come: by need, and by what would have to be given up otherwise.
#include <algorithm>
#include <iterator>

#include "components/planner/landmarks.h"

namespace goalnet::planner {

void Landmarks::add_order(std::int32_t before, std::int32_t after, bool reasonable) {
  if (before == after || in(row(after_all_, after), before)) return;  // no circles
  if (reasonable) put(row(before_, after), before);
  if (in(row(after_all_, before), after)) return;
  const Word* later = row(after_all_, after);
  for (std::int32_t i = 0; i < count(); ++i) {
    Word* mine = row(after_all_, i);
    if (i != before && !in(mine, before)) continue;
    for (std::size_t w = 0; w < words_; ++w) mine[w] |= later[w];
    put(mine, after);
  }
}

// What must have been true before a landmark can first become true, and what holds right before that.
void Landmarks::order_by_need(Budget& budget) {
  just_before_.assign(conditions_.size(), {});
  just_after_.assign(conditions_.size(), {});
  needed_for_.assign(conditions_.size(), {});
  comes_with_.assign(conditions_.size(), {});
  for (std::int32_t b = 0; b < count(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    const Proposition p = relaxed_->of(conditions_[i]);
    for (const Proposition other : sets_[static_cast<std::size_t>(p)]) {
      const std::int32_t a = of_proposition_[static_cast<std::size_t>(other)];
      if (a >= 0) add_order(a, b, false);
    }
    bool first = true, any = false;
    std::vector<std::int32_t> shared, always;
    std::vector<Literal> effects;
    for (const std::int32_t producer : relaxed_->producers(p)) {
      if (budget.poll()) return;
      const RelaxedOperator& op = relaxed_->operators()[static_cast<std::size_t>(producer)];
      std::vector<std::int32_t> needs;
      bool can_be_first = true;
      for (const Proposition need : relaxed_->preconditions(op)) {
        if (known_[static_cast<std::size_t>(need)] == 0) can_be_first = false;
        const auto& set = sets_[static_cast<std::size_t>(need)];
        if (std::binary_search(set.begin(), set.end(), p)) can_be_first = false;
        const std::int32_t a = of_proposition_[static_cast<std::size_t>(need)];
        if (a >= 0 && a != b) needs.push_back(a);
      }
      std::sort(needs.begin(), needs.end());
      if (any) {
        std::vector<std::int32_t> both;
        std::set_intersection(always.begin(), always.end(), needs.begin(), needs.end(),
                              std::back_inserter(both));
        always.swap(both);
      } else {
        always = needs;
      }
      any = true;
      if (!can_be_first) continue;
      std::vector<Literal> does;
      if (op.action >= 0) {
        for (const GroundEffect& effect :
             task_->effects_of(task_->actions[static_cast<std::size_t>(op.action)])) {
          if (!effect.conditional() && effect.literal != conditions_[i]) does.push_back(effect.literal);
        }
      }
      std::sort(does.begin(), does.end());
      if (first) {
        shared = needs;
        effects = does;
      } else {
        std::vector<std::int32_t> both;
        std::set_intersection(shared.begin(), shared.end(), needs.begin(), needs.end(),
                              std::back_inserter(both));
        shared.swap(both);
        std::vector<Literal> common;
        std::set_intersection(effects.begin(), effects.end(), does.begin(), does.end(),
                              std::back_inserter(common));
        effects.swap(common);
      }
      first = false;
    }
    for (const std::int32_t a : always) needed_for_[static_cast<std::size_t>(a)].push_back(b);
    if (known_[static_cast<std::size_t>(p)] == 2) continue;  // holds at first
    for (const std::int32_t a : shared) {
      add_order(a, b, false);
      just_before_[i].push_back(a);
      just_after_[static_cast<std::size_t>(a)].push_back(b);
    }
    comes_with_[i] = std::move(effects);
  }
}

// Whether reaching `first` later than `second` means that `second` has to be given up in between.
bool Landmarks::interferes(std::int32_t first, std::int32_t second, const PairReachability& pairs) const {
  const ConditionId a = conditions_[static_cast<std::size_t>(first)],
                    b = conditions_[static_cast<std::size_t>(second)];
  if (a < 0 || b < 0) return false;
  if (pairs.exclusive(a, b)) return true;
  for (const Literal effect : comes_with_[static_cast<std::size_t>(first)]) {
    if (effect != b && pairs.exclusive(effect, b)) return true;
  }
  for (const std::int32_t x : just_before_[static_cast<std::size_t>(first)]) {
    const ConditionId condition = conditions_[static_cast<std::size_t>(x)];
    if (condition >= 0 && condition != b && pairs.exclusive(condition, b)) return true;
  }
  return false;
}

void Landmarks::order_reasonably(const PairReachability& pairs, Budget& budget) {
  for (std::int32_t b = 0; b < count() && !budget.poll(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (is_goal_[i] != 0) {  // b holds in the end, so what would destroy it comes before it
      for (std::int32_t a = 0; a < count() && !budget.poll(); ++a) {
        if (a != b &&
            known_[static_cast<std::size_t>(relaxed_->of(conditions_[static_cast<std::size_t>(a)]))] != 2 &&
            interferes(a, b, pairs)) {
          add_order(a, b, true);
        }
      }
      continue;
    }
    // b is needed right before some c; whatever else must come before c and would destroy b comes before b.
    for (const std::int32_t c : just_after_[i]) {
      for (std::int32_t a = 0; a < count() && !budget.poll(); ++a) {
        if (a == b || a == c || !in(row(after_all_, a), c)) continue;
        if (interferes(a, b, pairs)) add_order(a, b, true);
      }
    }
  }
}

}  // namespace goalnet::planner
