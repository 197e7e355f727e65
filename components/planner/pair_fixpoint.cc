#include "components/planner/pair_fixpoint.h"

#include <algorithm>
#include <bit>

namespace goalnet::planner {

void PairFixpoint::restart(std::size_t count) {
  words_ = (count + 63) / 64;
  rows_.assign(count * words_, 0);
  changed_.assign(count, 1);
  mask_.assign(words_, 0);
  now_ = 1;
  operators_.clear();
  families_.clear();
}

void PairFixpoint::begin(const std::vector<Word>& facts) {
  for (std::int32_t p = 0; p < count(); ++p) {
    if (bit(facts.data(), p)) std::copy(facts.begin(), facts.end(), mutable_row(p));
  }
}

void PairFixpoint::begin(const std::vector<Word>& facts, const PairFixpoint& allowed) {
  begin(facts);
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] &= allowed.rows_[i];
}

// p comes together with everything in the mask.
void PairFixpoint::reach(std::int32_t p, const Word* mask, const PairFixpoint* allowed) {
  Word* mine = mutable_row(p);
  const Word* possible = allowed == nullptr ? nullptr : allowed->row(p);
  bool grown = false;
  for (std::size_t w = 0; w < words_; ++w) {
    Word fresh = mask[w] & ~mine[w];
    if (possible != nullptr) fresh &= possible[w];
    if (fresh == 0) continue;
    grown = true;
    mine[w] |= fresh;
    while (fresh != 0) {
      const auto q = static_cast<std::int32_t>(64 * w) + std::countr_zero(fresh);
      fresh &= fresh - 1;
      set(mutable_row(q), p);
      changed_[static_cast<std::size_t>(q)] = now_;
    }
  }
  if (grown) changed_[static_cast<std::size_t>(p)] = now_;
}

void PairFixpoint::apply(Operator& op, const PairFixpoint* allowed) {
  const bool stale = op.judged == 0 || std::any_of(op.needs.begin(), op.needs.end(), [&](std::int32_t need) {
                       return changed_[static_cast<std::size_t>(need)] >= op.judged;
                     });
  if (!stale && !op.needs.empty()) return;
  op.judged = ++now_;
  if (op.needs.empty()) {
    std::fill(mask_.begin(), mask_.end(), Word{0});
    for (std::int32_t q = 0; q < count(); ++q) {
      if (bit(row(q), q)) set(mask_.data(), q);
    }
  } else {
    std::copy_n(row(op.needs[0]), words_, mask_.begin());
    for (std::size_t i = 1; i < op.needs.size(); ++i) {
      const Word* other = row(op.needs[i]);
      for (std::size_t w = 0; w < words_; ++w) mask_[w] &= other[w];
    }
    for (const std::int32_t need : op.needs) {
      if (!bit(mask_.data(), need)) return;  // not applicable yet
    }
  }
  for (const std::int32_t gone : op.deletes) {
    mask_[static_cast<std::size_t>(gone) >> 6] &= ~(Word{1} << (static_cast<std::size_t>(gone) & 63u));
  }
  if (op.family >= 0) {  // other operators of the family may be applied at the same time
    for (const std::int32_t fact : families_[static_cast<std::size_t>(op.family)]) set(mask_.data(), fact);
  }
  for (const std::int32_t fact : op.adds) set(mask_.data(), fact);
  for (const std::int32_t fact : op.within) {
    const Word* possible = allowed->row(fact);
    for (std::size_t w = 0; w < words_; ++w) mask_[w] &= possible[w];
  }
  for (const std::int32_t fact : op.adds) {
    if (op.within.empty() || bit(mask_.data(), fact)) reach(fact, mask_.data(), allowed);
  }
}

bool PairFixpoint::run(const PairFixpoint* allowed, Budget& budget) {
  for (bool grows = true; grows;) {
    const std::uint64_t before = now_;
    for (Operator& op : operators_) {
      if (budget.poll()) return false;
      apply(op, allowed);
    }
    grows = std::any_of(changed_.begin(), changed_.end(), [&](std::uint64_t when) { return when > before; });
  }
  return true;
}

}  // namespace goalnet::planner
