#include "components/planner/successors.h"

namespace goalnet::planner {

void Successors::restart(const GroundTask& task) {
  task_ = &task;
  always_.clear();
  watched_.clear();
  const std::size_t literals = task.needed.size();
  std::vector<std::uint32_t> uses(literals, 0);
  for (const GroundAction& action : task.actions) {
    for (const ConditionId c : task.preconditions(action)) {
      if (c >= 0) ++uses[static_cast<std::size_t>(c)];
    }
  }
  std::vector<Literal> watch(task.actions.size(), -1);
  begin_.assign(literals + 1, 0);
  for (std::size_t a = 0; a < task.actions.size(); ++a) {
    for (const ConditionId c : task.preconditions(task.actions[a])) {
      if (c >= 0 &&
          (watch[a] < 0 || uses[static_cast<std::size_t>(c)] < uses[static_cast<std::size_t>(watch[a])]))
        watch[a] = c;
    }
    if (watch[a] < 0) {
      always_.push_back(static_cast<std::int32_t>(a));
    } else {
      ++begin_[static_cast<std::size_t>(watch[a])];
    }
  }
  std::uint32_t total = 0;
  for (std::size_t literal = 0; literal < literals; ++literal) {
    if (begin_[literal] > 0) watched_.push_back(static_cast<Literal>(literal));
    total += begin_[literal];
    begin_[literal] = total;
  }
  begin_[literals] = total;
  waiting_.resize(total);
  for (std::size_t a = task.actions.size(); a-- > 0;) {
    if (watch[a] >= 0) waiting_[--begin_[static_cast<std::size_t>(watch[a])]] = static_cast<std::int32_t>(a);
  }
}

void Successors::applicable(const Word* state, std::vector<std::int32_t>* actions) const {
  actions->clear();
  const auto look = [&](std::int32_t action) {
    if (action_applies(*task_, state, task_->actions[static_cast<std::size_t>(action)]))
      actions->push_back(action);
  };
  for (const std::int32_t action : always_) look(action);
  for (const Literal literal : watched_) {
    if (!literal_holds(state, literal)) continue;
    const auto i = static_cast<std::size_t>(literal);
    for (std::uint32_t k = begin_[i]; k < begin_[i + 1]; ++k) look(waiting_[k]);
  }
}

}  // namespace goalnet::planner
