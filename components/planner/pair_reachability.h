// Which pairs of literals can hold together: the h² reachability analysis (Haslum and Geffner, AIPS 2000) on
// rows of bits. A pair that is never reached is mutually exclusive in every state that a plan can lead to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class PairReachability {
 public:
  // False where nothing is known: the task is too large for it to pay, or the budget ran out. Disjunctions in
  // conditions are taken to hold, and effects that happen under a condition to delete nothing, so that what
  // is found exclusive is.
  bool compute(const GroundTask& task, Budget& budget);

  // Both literals must be needed by the task, otherwise the answer is false.
  bool exclusive(Literal a, Literal b) const;
  // Whether the conditions can never hold together because a pair of their literals cannot.
  bool impossible(std::span<const ConditionId> conditions) const;

 private:
  struct Operator {
    std::vector<std::int32_t> needs, adds, deletes;  // indices of literals
    std::int32_t family = -1;                        // conditional effects of one action
    std::uint64_t judged = 0;
  };

  void add_operators(const GroundTask& task, Budget& budget);
  bool apply(Operator& op);
  void reach(std::int32_t p, const Word* mask);
  Word* row(std::int32_t index) { return rows_.data() + static_cast<std::size_t>(index) * words_; }
  const Word* row(std::int32_t index) const {
    return rows_.data() + static_cast<std::size_t>(index) * words_;
  }
  static bool bit(const Word* words, std::int32_t index) {
    return ((words[static_cast<std::size_t>(index) >> 6] >> (static_cast<std::size_t>(index) & 63u)) & 1u) !=
           0;
  }
  static void set(Word* words, std::int32_t index) {
    words[static_cast<std::size_t>(index) >> 6] |= Word{1} << (static_cast<std::size_t>(index) & 63u);
  }
  std::int32_t index_of(Literal literal) const { return index_[static_cast<std::size_t>(literal)]; }

  bool known_ = false;
  std::size_t words_ = 0;
  std::vector<std::int32_t> index_;     // by literal; -1 = not needed
  std::vector<Word> rows_;              // bit q of row p: p and q can hold together
  std::vector<std::uint64_t> changed_;  // by index: when its row last grew
  std::uint64_t now_ = 1;
  std::vector<Operator> operators_;
  std::vector<std::vector<std::int32_t>>
      families_;  // what the conditional effects of an action may add together
  std::vector<Word> mask_, fresh_;
};

}  // namespace goalnet::planner
