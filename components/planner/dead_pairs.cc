#include "components/planner/dead_pairs.h"

#include <algorithm>

namespace goalnet::planner {

// Actions from after to before. What an action sets holds after it; whatever it sets, and does not ask for,
// may have been either way before. Effects under a condition, and conditions that are no literals, are taken
// for what excludes least.
void DeadPairs::add_operators(const GroundTask& task, const PairReachability& forwards, Budget& budget) {
  const auto index = [&](Literal literal) { return forwards.index_of(literal); };
  const auto add = [&](std::vector<std::int32_t>* list, Literal literal) {
    if (index(literal) >= 0) list->push_back(index(literal));
  };
  std::vector<Literal> before, set, perhaps;
  for (const GroundAction& action : task.actions) {
    if (budget.poll()) return;
    before.clear();
    set.clear();
    perhaps.clear();
    for (const ConditionId condition : task.preconditions(action)) {
      if (condition >= 0) before.push_back(condition);
    }
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (effect.conditional()) {
        perhaps.push_back(effect.literal);
        continue;
      }
      std::erase(set, opposite(effect.literal));
      if (std::find(set.begin(), set.end(), effect.literal) == set.end()) set.push_back(effect.literal);
    }
    const auto is_in = [](const std::vector<Literal>& list, Literal literal) {
      return std::find(list.begin(), list.end(), literal) != list.end();
    };
    const auto may_change = [&](Literal literal) {
      return is_in(perhaps, literal) || is_in(perhaps, opposite(literal));
    };
    PairFixpoint::Operator op;
    for (const Literal literal : set) {
      if (!may_change(literal)) add(&op.needs, literal);
      if (is_in(before, literal)) continue;
      if (is_in(before, opposite(literal))) {
        add(&op.deletes, literal);
      } else {
        add(&op.adds, literal);
        add(&op.adds, opposite(literal));
      }
    }
    for (const Literal literal : before) {
      add(&op.within, literal);
      if (is_in(set, opposite(literal)) || may_change(literal)) {
        add(&op.adds, literal);
      } else if (!is_in(set, literal)) {
        add(&op.needs, literal);
      }
    }
    for (const Literal literal : perhaps) {
      add(&op.adds, literal);
      add(&op.adds, opposite(literal));
    }
    if (!op.adds.empty()) pairs_.add(std::move(op));
  }
}

void DeadPairs::compute(const GroundTask& task, const PairReachability& forwards, Budget& budget) {
  rows_.clear();
  if (!forwards.known_) return;
  const PairFixpoint& reachable = forwards.pairs_;
  pairs_.restart(static_cast<std::size_t>(reachable.count()));
  add_operators(task, forwards, budget);
  if (budget.check()) return;
  // To begin with, all that fits the goal.
  std::vector<Word> fits(reachable.words(), ~Word{0});
  for (const ConditionId condition : task.goal) {
    if (condition < 0) continue;
    const std::int32_t goal = forwards.index_of(condition), against = forwards.index_of(opposite(condition));
    if (against >= 0)
      fits[static_cast<std::size_t>(against) >> 6] &= ~(Word{1} << (static_cast<std::size_t>(against) & 63u));
    if (goal < 0) continue;
    for (std::size_t w = 0; w < fits.size(); ++w) fits[w] &= reachable.row(goal)[w];
  }
  pairs_.begin(fits, reachable);
  if (!pairs_.run(&reachable, budget)) return;
  words_ = task.words();
  place_.assign(task.needed.size(), -1);
  std::int32_t places = 0;
  for (std::size_t p = 0; p < place_.size(); ++p) {
    const std::int32_t mine = forwards.index_of(static_cast<Literal>(p));
    if (mine < 0) continue;
    if (budget.poll()) {
      rows_.clear();
      return;
    }
    const Word* possible = reachable.row(mine);
    const Word* alive = pairs_.row(mine);
    if (std::equal(possible, possible + reachable.words(), alive)) continue;
    place_[p] = places++;
    rows_.resize(static_cast<std::size_t>(places) * 2 * words_, 0);
    Word* if_true = rows_.data() + static_cast<std::size_t>(place_[p]) * 2 * words_;
    for (std::size_t q = 0; q < place_.size(); ++q) {
      const std::int32_t other = forwards.index_of(static_cast<Literal>(q));
      if (other < 0 || !PairFixpoint::bit(possible, other) || PairFixpoint::bit(alive, other)) continue;
      PairFixpoint::set((q & 1) == 0 ? if_true : if_true + words_, static_cast<std::int32_t>(q / 2));
    }
  }
}

bool DeadPairs::dead(const Word* state) const {
  if (rows_.empty()) return false;
  for (std::size_t literal = 0; literal < place_.size(); ++literal) {
    const auto l = static_cast<Literal>(literal);
    if (place_[literal] >= 0 && literal_holds(state, l) && dead(state, l)) return true;
  }
  return false;
}

}  // namespace goalnet::planner
