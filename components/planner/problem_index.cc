#include "components/planner/problem_index.h"

#include <array>

namespace goalnet::planner {

void ProblemIndex::restart(const Problem& problem, Budget& budget) {
  problem_ = &problem;
  budget_ = &budget;
  type_count_ = static_cast<std::size_t>(compiled_.domain.types.size());
  objects_.resize(compiled_.type_sets.size());
  objects_built_.assign(compiled_.type_sets.size(), 0);
  const auto predicate_count = static_cast<std::size_t>(compiled_.domain.predicates.size());
  predicates_.resize(predicate_count);
  for (ByPredicate& entry : predicates_) {
    entry.begin = entry.end = 0;
    for (ByArgument& position : entry.positions) position.built = false;
  }
  const AtomTable& initial = problem.initial;
  ByPredicate* const predicates = predicates_.data();
  const bool counted = initial.each_predicate([&](PredicateId predicate) {
    ++predicates[predicate].end;
    return !budget.poll();
  });
  if (!counted) return;
  std::uint32_t total = 0;
  for (ByPredicate& entry : predicates_) {
    const std::uint32_t count = entry.end;
    entry.begin = entry.end = total;
    total += count;
  }
  atoms_.clear();
  atoms_.resize_for_overwrite(total);
  std::int32_t atom = 0;
  initial.each_predicate([&, atoms = atoms_.data()](PredicateId predicate) {
    atoms[predicates[predicate].end++] = atom++;
    return !budget.poll();
  });
}

std::span<const ObjectId> ProblemIndex::objects(std::int32_t type_set) {
  const auto set = static_cast<std::size_t>(type_set);
  if (objects_built_[set] == 0) {
    objects_built_[set] = 1;
    objects_[set].clear();
    for (ObjectId id = 0; id < problem_->object_count() && !budget_->poll(); ++id) {
      if (object_fits(id, type_set)) objects_[set].push_back(id);
    }
  }
  return {objects_[set].data(), objects_[set].size()};
}

std::span<const std::int32_t> ProblemIndex::facts(PredicateId predicate) {
  const ByPredicate& entry = predicates_[static_cast<std::size_t>(predicate)];
  return {atoms_.data() + entry.begin, entry.end - entry.begin};
}

std::span<const std::int32_t> ProblemIndex::facts(PredicateId predicate, std::size_t position,
                                                  ObjectId object) {
  constexpr std::size_t kFew = 16;
  const auto all = facts(predicate);
  if (all.size() <= kFew) return all;
  ByPredicate& entry = predicates_[static_cast<std::size_t>(predicate)];
  if (entry.positions.size() <= position) entry.positions.resize(position + 1);
  ByArgument& index = entry.positions[position];
  const AtomTable& initial = problem_->initial;
  if (!index.built) {
    index.built = true;
    const auto poll = [this] { return budget_->poll(); };
    const auto place = [&](std::int32_t atom, std::size_t beyond) -> std::uint32_t& {
      return index.begin[static_cast<std::size_t>(initial.arguments(atom)[position]) + beyond];
    };
    if (!index.begin.assign(static_cast<std::size_t>(problem_->object_count()) + 2, 0, poll)) return all;
    for (const std::int32_t atom : all) {
      if (poll()) return all;
      ++place(atom, 2);
    }
    for (std::size_t i = 2; i < index.begin.size(); ++i) {
      if (poll()) return all;
      index.begin[i] += index.begin[i - 1];
    }
    index.atoms.clear();
    index.atoms.resize_for_overwrite(all.size());
    for (const std::int32_t atom : all) {
      if (poll()) return all;
      index.atoms[place(atom, 1)++] = atom;
    }
  }
  if (budget_->stopped()) return all;
  const auto id = static_cast<std::size_t>(object);
  return {index.atoms.data() + index.begin[id], index.begin[id + 1] - index.begin[id]};
}

bool ProblemIndex::holds_initially(const AtomPattern& atom, const ObjectId* binding) const {
  std::array<ObjectId, 16> ids{};
  for (std::size_t i = 0; i < atom.arguments.size(); ++i) ids[i] = atom.arguments[i].resolve(binding);
  return problem_->initial.contains(atom.predicate, ids.data(), atom.arguments.size());
}

std::int64_t ProblemIndex::cost(const CostExpression& expression, const ObjectId* binding) const {
  if (!problem_->minimise_cost) return 1;
  std::int64_t total = expression.constant;
  for (const AtomPattern& function : expression.functions) {
    std::array<ObjectId, 16> ids{};
    for (std::size_t i = 0; i < function.arguments.size(); ++i)
      ids[i] = function.arguments[i].resolve(binding);
    const std::int32_t index =
        problem_->cost_atoms.find(function.predicate, ids.data(), function.arguments.size());
    if (index == AtomTable::kNone) return -1;
    total += problem_->cost_values[static_cast<std::size_t>(index)];
  }
  return total;
}

}  // namespace goalnet::planner
