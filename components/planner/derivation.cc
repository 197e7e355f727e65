#include "components/planner/derivation.h"

#include <algorithm>
#include <utility>

#include "components/planner/ground_task.h"

namespace goalnet::planner {
namespace {

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;  // from whom, to which gate

}  // namespace

void Derivation::clear() {
  gates_.clear();
  derived_.clear();
}

void Derivation::build(const GroundTask& task) {
  clear();
  open_at_once_.clear();
  given_.clear();
  negative_.clear();
  if (task.axioms.empty() && task.derived.empty()) return;
  Edges from_literal, from_gate;
  std::vector<std::int32_t> gate_of_junction(task.junctions.size(), -1);
  std::vector<std::int32_t> open;  // junctions whose gates have no inputs yet
  const auto connect = [&](ConditionId condition, std::int32_t gate) {
    if (condition >= 0) {
      from_literal.emplace_back(condition, gate);
      return;
    }
    std::int32_t& source = gate_of_junction[static_cast<std::size_t>(~condition)];
    if (source < 0) {
      source = static_cast<std::int32_t>(gates_.size());
      gates_.push_back({});
      open.push_back(~condition);
    }
    from_gate.emplace_back(source, gate);
  };
  for (const GroundAxiom& axiom : task.axioms) {
    const auto gate = static_cast<std::int32_t>(gates_.size());
    const auto conditions = task.conditions_of(axiom);
    gates_.push_back({static_cast<std::int32_t>(conditions.size()), axiom.head});
    for (const ConditionId condition : conditions) connect(condition, gate);
    if (conditions.empty()) open_at_once_.push_back(gate);
  }
  while (!open.empty()) {
    const Junction& junction = task.junctions[static_cast<std::size_t>(open.back())];
    const std::int32_t gate = gate_of_junction[static_cast<std::size_t>(open.back())];
    open.pop_back();
    const auto children = task.children(junction);
    gates_[static_cast<std::size_t>(gate)].waits_for =
        junction.conjunction ? static_cast<std::int32_t>(children.size()) : 1;
    for (const ConditionId child : children) connect(child, gate);
    if (junction.conjunction && children.empty()) open_at_once_.push_back(gate);
  }
  const auto fill = [](const Edges& edges, std::size_t count, Table* table) {
    table->begin.assign(count + 1, 0);
    for (const auto& edge : edges) ++table->begin[static_cast<std::size_t>(edge.first) + 1];
    for (std::size_t i = 1; i <= count; ++i) table->begin[i] += table->begin[i - 1];
    table->gates.resize(edges.size());
    std::vector<std::uint32_t> next(table->begin.begin(), table->begin.end() - 1);
    for (const auto& edge : edges) table->gates[next[static_cast<std::size_t>(edge.first)]++] = edge.second;
  };
  const std::size_t literals = 2 * task.initial.size();
  fill(from_literal, literals, &of_literal_);
  fill(from_gate, gates_.size(), &of_gate_);
  first_waits_.resize(gates_.size());
  std::transform(gates_.begin(), gates_.end(), first_waits_.begin(),
                 [](const Gate& g) { return g.waits_for; });
  for (std::size_t atom = 0; atom < task.derived.size(); ++atom) {
    if (task.derived[atom] != 0) derived_.push_back(static_cast<std::int32_t>(atom));
  }
  for (std::size_t literal = 0; literal < literals; ++literal) {
    if (of_literal_.begin[literal] == of_literal_.begin[literal + 1]) continue;
    const std::int32_t layer = task.derived[literal / 2] - 1;
    if (layer < 0) {
      given_.push_back(static_cast<std::int32_t>(literal));
    } else if ((literal & 1u) != 0) {
      const auto i = static_cast<std::size_t>(layer);
      if (negative_.size() <= i) negative_.resize(i + 1);
      negative_[i].push_back(static_cast<std::int32_t>(literal));
    }
  }
}

void Derivation::open(std::int32_t gate, std::uint64_t* state) const {
  const std::int32_t head = gates_[static_cast<std::size_t>(gate)].head;
  if (head < 0) {
    fresh_.push_back(~gate);
  } else if (!literal_holds(state, head)) {
    make_true(state, head);
    fresh_.push_back(head);
  }
}

void Derivation::signal(const Table& table, std::int32_t from, std::uint64_t* state) const {
  const auto i = static_cast<std::size_t>(from);
  for (std::uint32_t k = table.begin[i]; k < table.begin[i + 1]; ++k) {
    if (--waits_[static_cast<std::size_t>(table.gates[k])] == 0) open(table.gates[k], state);
  }
}

void Derivation::propagate(std::uint64_t* state) const {
  while (!fresh_.empty()) {
    const std::int32_t from = fresh_.back();  // a literal, or ~ a gate
    fresh_.pop_back();
    from >= 0 ? signal(of_literal_, from, state) : signal(of_gate_, ~from, state);
  }
}

void Derivation::run(std::uint64_t* state) const {
  waits_ = first_waits_;
  fresh_.clear();
  for (const std::int32_t atom : derived_) make_true(state, 2 * atom + 1);
  for (const std::int32_t gate : open_at_once_) open(gate, state);
  for (const std::int32_t literal : given_) {
    if (literal_holds(state, literal)) signal(of_literal_, literal, state);
  }
  propagate(state);
  // That something does not follow counts once its layer is complete.
  for (const auto& layer : negative_) {
    for (const std::int32_t literal : layer) {
      if (literal_holds(state, literal)) fresh_.push_back(literal);
    }
    propagate(state);
  }
}

}  // namespace goalnet::planner
