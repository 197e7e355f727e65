#include "components/planner/stubborn_sets.h"

#include <algorithm>

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostKept = 2'000'000;  // entries of interfering_: 8 MB

template <class ForEach>
void fill_rows(std::size_t rows, std::vector<std::uint32_t>& begin, std::vector<std::int32_t>& values,
               const ForEach& for_each) {
  begin.assign(rows + 1, 0);
  for_each([&](Literal row, std::int32_t) { ++begin[static_cast<std::size_t>(row)]; });
  std::uint32_t total = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    total += begin[i];
    begin[i] = total;
  }
  begin[rows] = total;
  values.resize(total);
  for_each([&](Literal row, std::int32_t value) {
    auto& place = begin[static_cast<std::size_t>(row)];
    if (place > 0) values[--place] = value;  // 0 only where counting was stopped
  });
}

}  // namespace

template <class Visit>
void StubbornSets::for_each_leaf(ConditionId condition, const Visit& visit) const {
  if (condition >= 0) {
    visit(condition);
    return;
  }
  for (const ConditionId child : task_->children(task_->junctions[static_cast<std::size_t>(~condition)])) {
    for_each_leaf(child, visit);
  }
}

// Literals that the action reads: of preconditions as they are, of effects' conditions in both polarities.
template <class Visit>
void StubbornSets::for_each_read(const GroundAction& action, const Visit& visit) const {
  for (const ConditionId condition : task_->preconditions(action)) for_each_leaf(condition, visit);
  for (const GroundEffect& effect : task_->effects_of(action)) {
    for (const ConditionId condition : task_->conditions_of(effect)) {
      for_each_leaf(condition, [&](Literal literal) {
        visit(literal);
        visit(opposite(literal));
      });
    }
  }
}

void StubbornSets::restart(const GroundTask& task, Budget& budget) {
  task_ = &task;
  if (!task.axioms.empty()) return successors_.restart(task);
  const std::size_t literals = task.needed.size();
  fill_rows(literals, producer_begin_, producers_, [&](const auto& visit) {
    for (std::size_t a = 0; a < task.actions.size() && !budget.poll(); ++a) {
      for (const GroundEffect& effect : task.effects_of(task.actions[a])) {
        visit(effect.literal, static_cast<std::int32_t>(a));
      }
    }
  });
  fill_rows(literals, reader_begin_, readers_, [&](const auto& visit) {
    for (std::size_t a = 0; a < task.actions.size() && !budget.poll(); ++a) {
      for_each_read(task.actions[a], [&](Literal literal) { visit(literal, static_cast<std::int32_t>(a)); });
    }
  });
  interfering_.resize(std::max(interfering_.size(), task.actions.size()));
  interfering_known_.assign(task.actions.size(), 0);
  in_set_.assign(task.actions.size(), 0);
  seen_.assign(task.actions.size(), 0);
  round_ = seen_round_ = 0;
  kept_ = 0;
}

const std::vector<std::int32_t>& StubbornSets::interfering(std::int32_t action, Budget& budget) {
  const auto a = static_cast<std::size_t>(action);
  if (interfering_known_[a] != 0) return interfering_[a];
  const bool keep = kept_ < kMostKept;
  auto& list = keep ? interfering_[a] : passing_;
  list.clear();
  ++seen_round_;
  seen_[a] = seen_round_;
  const auto add_all = [&](std::span<const std::int32_t> others) {
    for (const std::int32_t other : others) {
      if (budget.poll()) return;
      auto& mark = seen_[static_cast<std::size_t>(other)];
      if (mark == seen_round_) continue;
      mark = seen_round_;
      list.push_back(other);
    }
  };
  const GroundAction& ground = task_->actions[a];
  for (const GroundEffect& effect : task_->effects_of(ground)) {
    add_all(readers(opposite(effect.literal)));    // it destroys what they read
    add_all(producers(opposite(effect.literal)));  // they and it leave different values
  }
  for_each_read(
      ground, [&](Literal literal) { add_all(producers(opposite(literal))); });  // they destroy what it reads
  if (keep && !budget.stopped()) {
    interfering_known_[a] = 1;
    kept_ += list.size();
  }
  return list;
}

void StubbornSets::add(std::int32_t action) {
  auto& mark = in_set_[static_cast<std::size_t>(action)];
  if (mark == round_) return;
  mark = round_;
  queue_.push_back(action);
}

std::size_t StubbornSets::producer_count(const Word* state, ConditionId condition) const {
  std::size_t count = 0;
  for_each_leaf(condition, [&](Literal literal) {
    if (literal_holds(state, literal)) return;
    for (const std::int32_t action : producers(literal)) {
      count += in_set_[static_cast<std::size_t>(action)] == round_ ? 0 : 1;  // those in the set cost nothing
    }
  });
  return count;
}

// Some action among these must happen before `condition`, which does not hold, can hold.
void StubbornSets::add_producers(const Word* state, ConditionId condition) {
  for_each_leaf(condition, [&](Literal literal) {
    if (literal_holds(state, literal)) return;
    for (const std::int32_t action : producers(literal)) add(action);
  });
}

// One condition that does not hold is enough; the one with the fewest producers keeps the set small.
void StubbornSets::add_enabling(const Word* state, std::span<const ConditionId> conditions) {
  bool found = false;
  ConditionId best = 0;
  std::size_t fewest = SIZE_MAX;
  for (const ConditionId condition : conditions) {
    if (condition_holds(*task_, state, condition)) continue;
    const std::size_t count = producer_count(state, condition);
    if (found && count >= fewest) continue;
    found = true;
    best = condition;
    fewest = count;
  }
  if (found) add_producers(state, best);
}

const std::vector<std::int32_t>& StubbornSets::applicable(const Word* state, Budget& budget) {
  if (!task_->axioms.empty()) {
    successors_.applicable(state, &result_);
    return result_;
  }
  ++round_;
  queue_.clear();
  result_.clear();
  add_enabling(state, task_->goal);
  for (std::size_t i = 0; i < queue_.size() && !budget.poll(); ++i) {
    const std::int32_t action = queue_[i];
    const GroundAction& ground = task_->actions[static_cast<std::size_t>(action)];
    if (action_applies(*task_, state, ground)) {
      result_.push_back(action);
      for (const std::int32_t other : interfering(action, budget)) add(other);
    } else {
      add_enabling(state, task_->preconditions(ground));
    }
  }
  return result_;
}

}  // namespace goalnet::planner
