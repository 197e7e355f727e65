#include "components/planner/landmarks.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <iterator>

namespace goalnet::planner {
namespace {

constexpr std::int64_t kMostWork = 60'000'000;  // elements of sets looked at: about 0.2 s
constexpr std::size_t kMostLandmarks = 1000;

}  // namespace

// sets_ of all propositions: the landmarks of an operator are those of what it needs; those of a proposition
// are what all its producers share. Sets only shrink, so this ends.
void Landmarks::collect(const Word* initial, Budget& budget) {
  const auto propositions = static_cast<std::size_t>(relaxed_->proposition_count());
  const auto& operators = relaxed_->operators();
  sets_.assign(propositions, {});
  known_.assign(propositions, 0);
  std::vector<std::int32_t> waiting_for(operators.size());
  std::vector<std::uint8_t> queued(operators.size(), 0);
  std::deque<std::int32_t> queue;
  for (std::size_t i = 0; i < operators.size(); ++i) {
    waiting_for[i] =
        static_cast<std::int32_t>(operators[i].precondition_end - operators[i].precondition_begin);
  }
  const auto wake = [&](Proposition p, bool first) {
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      if (first) --waiting_for[i];
      if (waiting_for[i] > 0 || queued[i] != 0) continue;
      queued[i] = 1;
      queue.push_back(user);
    }
  };
  const auto given = [&](Proposition p) {
    known_[static_cast<std::size_t>(p)] = 2;  // holds at first: nothing must come before it
    sets_[static_cast<std::size_t>(p)] = {p};
    wake(p, true);
  };
  relaxed_->for_each_true(initial, budget, given);
  given(relaxed_->always());
  std::int64_t work = 0;
  std::vector<Proposition> needs, merged;
  while (!queue.empty()) {
    if (budget.poll() || work > kMostWork) {
      sets_[static_cast<std::size_t>(relaxed_->goal())].clear();
      return;
    }
    const std::int32_t index = queue.front();
    queue.pop_front();
    queued[static_cast<std::size_t>(index)] = 0;
    const RelaxedOperator& op = operators[static_cast<std::size_t>(index)];
    needs.clear();
    for (const Proposition p : relaxed_->preconditions(op)) {
      const auto& set = sets_[static_cast<std::size_t>(p)];
      merged.clear();
      std::set_union(needs.begin(), needs.end(), set.begin(), set.end(), std::back_inserter(merged));
      needs.swap(merged);
    }
    for (const Proposition p : relaxed_->effects(op)) {
      const auto i = static_cast<std::size_t>(p);
      work += static_cast<std::int64_t>(needs.size() + sets_[i].size());
      if (known_[i] == 2) continue;
      if (known_[i] == 0) {
        known_[i] = 1;
        sets_[i] = needs;
        const auto place = std::lower_bound(sets_[i].begin(), sets_[i].end(), p);
        if (place == sets_[i].end() || *place != p) sets_[i].insert(place, p);
        wake(p, true);
        continue;
      }
      merged.clear();
      std::set_intersection(sets_[i].begin(), sets_[i].end(), needs.begin(), needs.end(),
                            std::back_inserter(merged));
      const auto place = std::lower_bound(merged.begin(), merged.end(), p);
      if (place == merged.end() || *place != p) merged.insert(place, p);
      if (merged.size() == sets_[i].size()) continue;
      sets_[i].swap(merged);
      wake(p, false);
    }
  }
}

void Landmarks::find(const RelaxedTask& relaxed, const PairReachability& pairs, const Word* initial,
                     Budget& budget) {
  relaxed_ = &relaxed;
  task_ = &relaxed.task();
  collect(initial, budget);
  conditions_.clear();
  const auto add = [&](ConditionId condition) {
    if (std::find(conditions_.begin(), conditions_.end(), condition) == conditions_.end())
      conditions_.push_back(condition);
  };
  for (const ConditionId goal : task_->goal) {
    if (conditions_.size() < kMostLandmarks) conditions_.push_back(goal);
  }
  const std::size_t goals = conditions_.size();
  const auto literals = static_cast<Proposition>(task_->needed.size());
  for (const Proposition p : sets_[static_cast<std::size_t>(relaxed.goal())]) {
    if (p >= relaxed.goal() || relaxed.is_gate(p) || conditions_.size() >= kMostLandmarks) continue;
    add(p < literals ? p : ~(p - literals));
  }
  words_ = std::max<std::size_t>(1, (conditions_.size() + 63) / 64);
  is_goal_.assign(conditions_.size(), 0);
  std::fill_n(is_goal_.begin(), goals, std::uint8_t{1});
  of_proposition_.assign(static_cast<std::size_t>(relaxed.proposition_count()), -1);
  for (std::int32_t i = 0; i < count(); ++i) {
    of_proposition_[static_cast<std::size_t>(relaxed.of(conditions_[static_cast<std::size_t>(i)]))] = i;
  }
  before_.assign(conditions_.size() * words_, 0);
  after_all_.assign(conditions_.size() * words_, 0);
  order_by_need(budget);
  order_reasonably(pairs, budget);
  sets_ = {};
  std::vector<int> later(conditions_.size(), 0);
  latest_first_.resize(conditions_.size());
  for (std::int32_t i = 0; i < count(); ++i) {
    latest_first_[static_cast<std::size_t>(i)] = i;
    for (std::size_t w = 0; w < words_; ++w)
      later[static_cast<std::size_t>(i)] += std::popcount(row(after_all_, i)[w]);
  }
  std::stable_sort(latest_first_.begin(), latest_first_.end(), [&](std::int32_t a, std::int32_t b) {
    return later[static_cast<std::size_t>(a)] < later[static_cast<std::size_t>(b)];
  });
  ordered_.clear();
  for (auto landmark = latest_first_.rbegin(); landmark != latest_first_.rend(); ++landmark) {
    const Word* before = row(before_, *landmark);
    if (std::any_of(before, before + words_, [](Word w) { return w != 0; })) ordered_.push_back(*landmark);
  }
  open_.assign(conditions_.size(), 0);
  settled_.assign(words_, 0);
}

bool Landmarks::too_early(std::int32_t landmark) const {
  const Word* before = row(before_, landmark);
  for (std::size_t w = 0; w < words_; ++w) {
    if ((before[w] & ~settled_[w]) != 0) return true;
  }
  return false;
}

void Landmarks::note(const Word* state, Word* reached) const {
  for (std::size_t w = 0; w < words_; ++w) {
    const std::size_t left = conditions_.size() - 64 * w;
    Word open = ~reached[w] & (left >= 64 ? ~Word{0} : (Word{1} << left) - 1);
    for (; open != 0; open &= open - 1) {
      const auto i = 64 * w + static_cast<std::size_t>(std::countr_zero(open));
      if (condition_holds(*task_, state, conditions_[i])) reached[w] |= open & (~open + 1);
    }
  }
}

std::int32_t Landmarks::missing(const Word* state, const Word* reached) {
  std::copy_n(reached, words_, settled_.begin());
  for (const std::int32_t landmark : ordered_) {
    if (in(reached, landmark) && too_early(landmark)) {
      settled_[static_cast<std::size_t>(landmark) >> 6] &=
          ~(Word{1} << (static_cast<std::size_t>(landmark) & 63u));
    }
  }
  std::int32_t result = 0;
  for (const std::int32_t landmark : latest_first_) {
    const auto i = static_cast<std::size_t>(landmark);
    const auto& next = just_after_[i];
    const auto& always = needed_for_[i];
    const auto needed_again = [&] {
      if (condition_holds(*task_, state, conditions_[i])) return false;
      return is_goal_[i] != 0 ||
             std::any_of(next.begin(), next.end(), [&](std::int32_t b) { return !in(reached, b); }) ||
             std::any_of(always.begin(), always.end(),
                         [&](std::int32_t b) { return open_[static_cast<std::size_t>(b)] != 0; });
    };
    open_[i] = !in(settled_.data(), landmark) || needed_again() ? 1 : 0;
    result += open_[i];
  }
  return result;
}

bool Landmarks::leads_on(const GroundAction& action) const {
  for (const GroundEffect& effect : task_->effects_of(action)) {
    const std::int32_t landmark = of_proposition_[static_cast<std::size_t>(effect.literal)];
    if (landmark >= 0 && open_[static_cast<std::size_t>(landmark)] != 0 && !too_early(landmark)) return true;
  }
  return false;
}

}  // namespace goalnet::planner
