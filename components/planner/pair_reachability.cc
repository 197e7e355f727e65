#include "components/planner/pair_reachability.h"

#include <algorithm>
#include <bit>

namespace goalnet::planner {
namespace {
constexpr std::int32_t kMostLiterals = 6000;  // 4.5 MB of rows
constexpr std::size_t kMostOperators = 150'000;
}  // namespace

void PairReachability::add_operators(const GroundTask& task, Budget& budget) {
  operators_.clear();
  families_.clear();
  const auto indices = [this](auto conditions, std::vector<std::int32_t>* result) {
    for (const ConditionId condition : conditions) {
      if (condition >= 0 && index_of(condition) >= 0) result->push_back(index_of(condition));
    }
  };
  for (const GroundAction& action : task.actions) {
    if (budget.poll()) return;
    Operator base;
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
      if (family < 0) {
        family = static_cast<std::int32_t>(families_.size());
        families_.emplace_back();
      }
      Operator op;
      op.needs = base.needs;
      indices(task.conditions_of(effect), &op.needs);
      op.adds = {index_of(effect.literal)};
      op.deletes = base.deletes;
      if (index_of(opposite(effect.literal)) >= 0) op.deletes.push_back(index_of(opposite(effect.literal)));
      op.family = family;
      families_.back().push_back(index_of(effect.literal));
      for (const std::int32_t add : base.adds) families_.back().push_back(add);
      operators_.push_back(std::move(op));
    }
    if (!base.adds.empty()) operators_.push_back(std::move(base));
  }
}

// p can hold together with everything in the mask.
void PairReachability::reach(std::int32_t p, const Word* mask) {
  Word* mine = row(p);
  bool grown = false;
  for (std::size_t w = 0; w < words_; ++w) {
    Word fresh = mask[w] & ~mine[w];
    if (fresh == 0) continue;
    grown = true;
    mine[w] |= fresh;
    while (fresh != 0) {
      const auto q = static_cast<std::int32_t>(64 * w) + std::countr_zero(fresh);
      fresh &= fresh - 1;
      set(row(q), p);
      changed_[static_cast<std::size_t>(q)] = now_;
    }
  }
  if (grown) changed_[static_cast<std::size_t>(p)] = now_;
}

// True if the operator was looked at: something it needs has changed since the last time.
bool PairReachability::apply(Operator& op) {
  const bool stale = op.judged == 0 || std::any_of(op.needs.begin(), op.needs.end(), [&](std::int32_t need) {
                       return changed_[static_cast<std::size_t>(need)] >= op.judged;
                     });
  if (!stale && !op.needs.empty()) return false;
  op.judged = ++now_;
  if (op.needs.empty()) {
    std::fill(mask_.begin(), mask_.end(), Word{0});
    for (std::int32_t q = 0; q < static_cast<std::int32_t>(changed_.size()); ++q) {
      if (bit(row(q), q)) set(mask_.data(), q);
    }
  } else {
    std::copy_n(row(op.needs[0]), words_, mask_.begin());
    for (std::size_t i = 1; i < op.needs.size(); ++i) {
      const Word* other = row(op.needs[i]);
      for (std::size_t w = 0; w < words_; ++w) mask_[w] &= other[w];
    }
    for (const std::int32_t need : op.needs) {
      if (!bit(mask_.data(), need)) return true;  // not applicable yet
    }
  }
  for (const std::int32_t gone : op.deletes) {
    mask_[static_cast<std::size_t>(gone) >> 6] &= ~(Word{1} << (static_cast<std::size_t>(gone) & 63u));
  }
  if (op.family >= 0) {  // other conditional effects of the action may happen at the same time
    for (const std::int32_t add : families_[static_cast<std::size_t>(op.family)]) set(mask_.data(), add);
  }
  for (const std::int32_t add : op.adds) set(mask_.data(), add);
  fresh_ = mask_;
  for (const std::int32_t add : op.adds) reach(add, fresh_.data());
  return true;
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
  words_ = (static_cast<std::size_t>(count) + 63) / 64;
  rows_.assign(static_cast<std::size_t>(count) * words_, 0);
  changed_.assign(static_cast<std::size_t>(count), 1);
  mask_.assign(words_, 0);
  now_ = 1;
  add_operators(task, budget);
  if (operators_.size() > kMostOperators || budget.check()) return false;
  for (std::size_t literal = 0; literal < task.needed.size(); ++literal) {
    const bool holds = (task.initial[literal >> 1] != 0) == ((literal & 1u) == 0);
    if (index_[literal] >= 0 && holds) set(mask_.data(), index_[literal]);
  }
  const std::vector<Word> initial = mask_;
  for (std::int32_t p = 0; p < count; ++p) {
    if (bit(initial.data(), p)) std::copy(initial.begin(), initial.end(), row(p));
  }
  for (bool grows = true; grows;) {
    const std::uint64_t before = now_;
    for (Operator& op : operators_) {
      if (budget.poll()) return false;
      apply(op);
    }
    grows = std::any_of(changed_.begin(), changed_.end(), [&](std::uint64_t when) { return when > before; });
  }
  known_ = true;
  return true;
}

bool PairReachability::exclusive(Literal a, Literal b) const {
  if (b == opposite(a)) return true;
  if (!known_) return false;
  const std::int32_t p = index_of(a), q = index_of(b);
  return p >= 0 && q >= 0 && !bit(row(p), q);
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
