// Which pairs of facts come together, by rows of bits: the h² fixpoint (Haslum and Geffner, AIPS 2000). Facts
// are plain numbers here; pair_reachability.h runs it forwards from the initial state, dead_pairs.h backwards
// from the goal. Internal to the planner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class PairFixpoint {
 public:
  struct Operator {
    std::vector<std::int32_t> needs, adds, deletes;
    std::vector<std::int32_t> within;  // what else is there where it adds; only together with `allowed`
    std::int32_t family = -1;          // of operators that may be applied together
    std::uint64_t judged = 0;
  };

  void restart(std::size_t count);
  void add(Operator op) { operators_.push_back(std::move(op)); }
  std::vector<std::int32_t>& family(std::int32_t number) {
    return families_[static_cast<std::size_t>(number)];
  }
  std::int32_t add_family() {
    families_.emplace_back();
    return static_cast<std::int32_t>(families_.size()) - 1;
  }
  std::size_t operators() const { return operators_.size(); }
  // Everything in the set comes together, to begin with; as far as it is allowed.
  void begin(const std::vector<Word>& facts);
  void begin(const std::vector<Word>& facts, const PairFixpoint& allowed);
  // Until nothing is added any more; pairs that are not in `allowed` (null: all are) never come together.
  // False if the budget has stopped it.
  bool run(const PairFixpoint* allowed, Budget& budget);

  bool together(std::int32_t p, std::int32_t q) const { return bit(row(p), q); }
  const Word* row(std::int32_t fact) const { return rows_.data() + static_cast<std::size_t>(fact) * words_; }
  std::size_t words() const { return words_; }
  std::int32_t count() const { return static_cast<std::int32_t>(changed_.size()); }

  static bool bit(const Word* words, std::int32_t i) {
    return ((words[static_cast<std::size_t>(i) >> 6] >> (static_cast<std::size_t>(i) & 63u)) & 1u) != 0;
  }
  static void set(Word* words, std::int32_t i) {
    words[static_cast<std::size_t>(i) >> 6] |= Word{1} << (static_cast<std::size_t>(i) & 63u);
  }

 private:
  void apply(Operator& op, const PairFixpoint* allowed);
  void reach(std::int32_t p, const Word* mask, const PairFixpoint* allowed);
  Word* mutable_row(std::int32_t fact) { return rows_.data() + static_cast<std::size_t>(fact) * words_; }

  std::size_t words_ = 0;
  std::vector<Word> rows_;              // bit q of row p: p and q come together
  std::vector<std::uint64_t> changed_;  // by fact: when its row last grew
  std::uint64_t now_ = 1;
  std::vector<Operator> operators_;
  std::vector<std::vector<std::int32_t>> families_;  // what the operators of one may add together
  std::vector<Word> mask_;
};

}  // namespace goalnet::planner
