// Strong stubborn sets (Wehrle and Helmert, ICAPS 2014): which applicable actions an optimal search may leave
// out in a state, because some order of the same actions is still found.
//
// Conditional effects are treated as if they always happened where that is the careful side: an action
// interferes with another if any of its effects touches any condition of the other.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/relaxed_task.h"
#include "components/planner/successors.h"

namespace goalnet::planner {

class StubbornSets {
 public:
  void restart(const GroundTask& task, Budget& budget);
  // The applicable actions that must be tried. Empty if no plan leads on from here.
  const std::vector<std::int32_t>& applicable(const Word* state, Budget& budget);

 private:
  void add(std::int32_t action);
  void add_producers(const Word* state, ConditionId condition);
  void add_enabling(const Word* state, std::span<const ConditionId> conditions);
  std::size_t producer_count(const Word* state, ConditionId condition) const;
  const std::vector<std::int32_t>& interfering(std::int32_t action, Budget& budget);
  std::span<const std::int32_t> row(const std::vector<std::uint32_t>& begin,
                                    const std::vector<std::int32_t>& values, Literal literal) const {
    const auto i = static_cast<std::size_t>(literal);
    return {values.data() + begin[i], begin[i + 1] - begin[i]};
  }
  std::span<const std::int32_t> producers(Literal literal) const {
    return row(producer_begin_, producers_, literal);
  }
  std::span<const std::int32_t> readers(Literal literal) const {
    return row(reader_begin_, readers_, literal);
  }
  template <class Visit>
  void for_each_read(const GroundAction& action, const Visit& visit) const;
  template <class Visit>
  void for_each_leaf(ConditionId condition, const Visit& visit) const;

  const GroundTask* task_ = nullptr;
  // By literal: actions with an effect that makes it true; actions that read it in a precondition or
  // condition.
  std::vector<std::uint32_t> producer_begin_, reader_begin_;
  std::vector<std::int32_t> producers_, readers_;
  std::vector<std::vector<std::int32_t>>
      interfering_;                    // by action, computed when first asked for, while room is left
  std::vector<std::int32_t> passing_;  // one that is not kept
  std::size_t kept_ = 0;               // how many entries are
  std::vector<std::uint8_t> interfering_known_;
  std::vector<std::uint32_t> in_set_;  // by action: the round that added it
  std::vector<std::uint32_t> seen_;
  std::uint32_t round_ = 0, seen_round_ = 0;
  std::vector<std::int32_t> queue_, result_;
  Successors successors_;  // used where there are axioms: then every action may interfere with every other
};

}  // namespace goalnet::planner
