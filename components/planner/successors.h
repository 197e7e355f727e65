// The actions that apply in a state, without looking at all actions: each waits under one of its
// preconditions, the one that the fewest actions share, and is only looked at where that holds.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/ground_task.h"

namespace goalnet::planner {

class Successors {
 public:
  void restart(const GroundTask& task);
  void applicable(const Word* state, std::vector<std::int32_t>* actions) const;

 private:
  const GroundTask* task_ = nullptr;
  std::vector<std::int32_t> always_;  // actions without a literal among their preconditions
  std::vector<std::uint32_t> begin_;  // by literal, in waiting_
  std::vector<std::int32_t> waiting_;
  std::vector<Literal> watched_;  // literals under which some action waits
};

}  // namespace goalnet::planner
