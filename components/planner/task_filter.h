// A smaller ground task for a given upper bound on the plan's cost.
//
// LM-cut leaves each action with the part of its cost that no cut has taken. A plan that uses action a costs
// at least the sum of the cuts, plus what is left of the cost of reaching a's precondition, plus what is left
// of a. Where that exceeds the bound, a is in no plan of interest and goes (the reduced-cost fixing of linear
// programming); with it goes what only it needed. Effects whose conditions are out of reach go likewise.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/ground_task.h"
#include "components/planner/lm_cut.h"

namespace goalnet::planner {

class TaskFilter {
 public:
  // Keeps what plans cheaper than `bound` may use; `estimate` and `lm_cut` are of the initial state of
  // `from`. Atoms and actions get new numbers; atoms that nothing changes any more are folded into the
  // conditions. Returns how many actions were left out although they are reachable. Stopped, `to` must not be
  // used.
  std::int64_t filter(const GroundTask& from, const RelaxedTask& relaxed, const LmCut& lm_cut,
                      std::int64_t estimate, std::int64_t bound, GroundTask& to, Budget& budget);
  // The task as it is: axioms are not filtered.
  void copy(const GroundTask& from, GroundTask& to);
  // By action of the filtered task: its number in `from`.
  const std::vector<std::int32_t>& original() const { return original_; }

 private:
  enum class Value : std::uint8_t { kFalse, kTrue, kOpen };

  void find_relevant(Budget& budget);
  void need(ConditionId condition);
  void need_opposite(ConditionId condition);
  bool relevant(const GroundEffect& effect) const {
    return needed_[static_cast<std::size_t>(effect.literal)] != 0 ||
           needed_[static_cast<std::size_t>(opposite(effect.literal))] != 0;
  }
  Value translate(ConditionId condition, GroundTask& to, ConditionId* result);
  bool translate_all(std::span<const ConditionId> conditions, GroundTask& to);

  const GroundTask* from_ = nullptr;
  std::vector<std::uint8_t> keep_action_, keep_effect_;
  std::vector<std::uint8_t> needed_;   // by literal of `from`
  std::vector<std::uint8_t> changes_;  // by atom of `from`
  std::vector<Literal> queue_;
  std::vector<std::int32_t> new_atom_;
  std::vector<std::int32_t> original_;
};

}  // namespace goalnet::planner
