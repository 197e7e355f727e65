#include "components/planner/interpreter.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace goalnet::planner {
namespace {

// Arguments of an atom under a binding; predicates have at most 16.
struct Ground {
  std::array<ObjectId, 16> ids;
  std::size_t count;
  Ground(const AtomPattern& atom, const std::vector<ObjectId>& binding) : count(atom.arguments.size()) {
    for (std::size_t i = 0; i < count; ++i) ids[i] = atom.arguments[i].resolve(binding.data());
  }
};

}  // namespace

void AtomSet::assign(const AtomTable& atoms) {
  table_ = atoms;
  holds_.assign(static_cast<std::size_t>(atoms.size()), 1);
}

void AtomSet::set(PredicateId predicate, const ObjectId* arguments, std::size_t count, bool holds) {
  if (!holds) {
    const std::int32_t atom = table_.find(predicate, arguments, count);
    if (atom != AtomTable::kNone) holds_[static_cast<std::size_t>(atom)] = 0;
    return;
  }
  const std::int32_t atom = table_.add(predicate, arguments, count);
  holds_.resize(static_cast<std::size_t>(table_.size()), 0);
  holds_[static_cast<std::size_t>(atom)] = 1;
}

Interpreter::Interpreter(const Problem& problem) : problem_(problem) {
  definitions_.resize(static_cast<std::size_t>(problem.domain().predicates.size()));
  for (const DerivedPredicate& definition : problem.domain().derived) {
    if (problem.domain().recursive(definition.predicate)) continue;
    definitions_[static_cast<std::size_t>(definition.predicate)].push_back(&definition);
  }
}

const std::vector<ObjectId>& Interpreter::objects(const TypeSet& types) const {
  const auto [place, is_new] = objects_.try_emplace(types);
  if (is_new) {
    for (ObjectId id = 0; id < problem_.object_count(); ++id) {
      if (problem_.object_is_a(id, types)) place->second.push_back(id);
    }
  }
  return place->second;
}

bool Interpreter::for_each_binding(std::span<const std::int32_t> variables, std::size_t index,
                                   std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
                                   const std::function<bool()>& visit) const {
  if (index == variables.size()) return visit();
  const auto slot = static_cast<std::size_t>(variables[index]);
  for (const ObjectId id : objects(slots[slot])) {
    binding[slot] = id;
    if (!for_each_binding(variables, index + 1, slots, binding, visit)) return false;
  }
  return true;
}

bool Interpreter::decided(const Formula& inner, bool universal, const std::vector<ObjectId>& binding,
                          const AtomSet& state) const {
  const auto decides = [&](const Formula& part) {
    const bool negative = part.kind == Formula::Kind::kNot;
    const Formula& atom = negative ? part.children.front() : part;
    if (atom.kind != Formula::Kind::kAtom || problem_.domain().is_derived(atom.atom.predicate)) return false;
    const auto& arguments = atom.atom.arguments;
    const bool open = std::any_of(arguments.begin(), arguments.end(),
                                  [&](Term term) { return term.resolve(binding.data()) < 0; });
    return !open && (atom_holds(atom.atom, binding, state) != negative) == universal;
  };
  if (inner.kind != (universal ? Formula::Kind::kOr : Formula::Kind::kAnd)) return decides(inner);
  return std::any_of(inner.children.begin(), inner.children.end(), decides);
}

const std::vector<ObjectId>& Interpreter::partners(PredicateId predicate, std::size_t given, ObjectId object,
                                                   std::size_t wanted) const {
  auto& by_object = partners_[{predicate, given, wanted}];
  if (by_object.empty()) {
    by_object.resize(static_cast<std::size_t>(problem_.object_count()));
    for (std::int32_t atom = 0; atom < problem_.initial.size(); ++atom) {
      if (problem_.initial.predicate(atom) != predicate) continue;
      const auto arguments = problem_.initial.arguments(atom);
      by_object[static_cast<std::size_t>(arguments[given])].push_back(arguments[wanted]);
    }
  }
  return by_object[static_cast<std::size_t>(object)];
}

const std::vector<ObjectId>* Interpreter::candidates(const Formula& inner, bool universal, std::int32_t slot,
                                                     std::size_t most,
                                                     const std::vector<ObjectId>& binding) const {
  const Domain& domain = problem_.domain();
  if (fixed_.empty()) {
    fixed_.assign(static_cast<std::size_t>(domain.predicates.size()), 1);
    const auto note = [&](const auto& self, const Effect& effect) -> void {
      if (effect.kind == Effect::Kind::kAdd || effect.kind == Effect::Kind::kDelete) {
        fixed_[static_cast<std::size_t>(effect.atom.predicate)] = 0;
      }
      for (const Effect& child : effect.children) self(self, child);
    };
    for (const ActionSchema& action : domain.actions) note(note, action.effect);
    for (const DerivedPredicate& definition : domain.derived) {
      fixed_[static_cast<std::size_t>(definition.predicate)] = 0;
    }
  }
  const std::vector<ObjectId>* best = nullptr;
  const auto consider = [&](const Formula& part) {
    const bool negative = part.kind == Formula::Kind::kNot;
    const Formula& atom = negative ? part.children.front() : part;
    if (atom.kind != Formula::Kind::kAtom || negative != universal) return;
    if (fixed_[static_cast<std::size_t>(atom.atom.predicate)] == 0) return;
    const auto& arguments = atom.atom.arguments;
    const auto mine = std::find(arguments.begin(), arguments.end(), Term::variable(slot));
    if (mine == arguments.end()) return;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const ObjectId bound = arguments[i].resolve(binding.data());
      if (bound < 0) continue;
      const auto& found =
          partners(atom.atom.predicate, i, bound, static_cast<std::size_t>(mine - arguments.begin()));
      if (found.size() < (best == nullptr ? most : best->size())) best = &found;
    }
  };
  if (inner.kind != (universal ? Formula::Kind::kOr : Formula::Kind::kAnd)) {
    consider(inner);
  } else {
    for (const Formula& part : inner.children) consider(part);
  }
  return best;
}

template <class Visit>
bool Interpreter::quantified(std::span<const std::int32_t> variables, std::size_t index, const Formula& inner,
                             bool universal, std::span<const TypeSet> slots, std::vector<ObjectId>& binding,
                             const AtomSet& state, const Visit& visit) const {
  if (index == variables.size()) return visit();
  const auto slot = static_cast<std::size_t>(variables[index]);
  const std::vector<ObjectId>& all = objects(slots[slot]);
  const std::vector<ObjectId>* some = candidates(inner, universal, variables[index], all.size(), binding);
  for (const ObjectId id : some == nullptr ? all : *some) {
    if (some != nullptr && !problem_.object_is_a(id, slots[slot])) continue;
    binding[slot] = id;
    if (decided(inner, universal, binding, state)) continue;
    if (quantified(variables, index + 1, inner, universal, slots, binding, state, visit) != universal) {
      return !universal;
    }
  }
  binding[slot] = -1;
  return universal;
}

void Interpreter::complete(AtomSet& state) const {
  const Domain& domain = problem_.domain();
  if (!domain.has_recursion()) return;
  for (std::int32_t atom = 0; atom < state.table().size(); ++atom) {
    if (domain.recursive(state.table().predicate(atom))) state.set(atom, false);
  }
  const std::int32_t layers = *std::max_element(domain.layer.begin(), domain.layer.end()) + 1;
  for (std::int32_t layer = 0; layer < layers; ++layer) {
    for (bool grows = true; grows;) {
      grows = false;
      for (const DerivedPredicate& definition : domain.derived) {
        if (domain.layer[static_cast<std::size_t>(definition.predicate)] != layer) continue;
        std::vector<std::int32_t> parameters(static_cast<std::size_t>(definition.parameter_count));
        std::iota(parameters.begin(), parameters.end(), 0);
        std::vector<ObjectId> binding(definition.slots.size(), -1);
        // Nothing makes it stop early: it goes on as if nothing had been found yet.
        quantified(parameters, 0, definition.body, false, definition.slots, binding, state, [&] {
          if (state.contains(definition.predicate, binding.data(), parameters.size())) return false;
          std::vector<ObjectId> inner = binding;
          if (!holds(definition.body, definition.slots, inner, state)) return false;
          state.set(definition.predicate, binding.data(), parameters.size(), true);
          grows = true;
          return false;
        });
      }
    }
  }
}

bool Interpreter::atom_holds(const AtomPattern& atom, const std::vector<ObjectId>& binding,
                             const AtomSet& state) const {
  const Ground ground(atom, binding);
  for (const DerivedPredicate* defined : definitions_[static_cast<std::size_t>(atom.predicate)]) {
    const DerivedPredicate& definition = *defined;
    std::vector<ObjectId> inner(definition.slots.size(), 0);
    bool fits = true;
    for (std::size_t i = 0; i < ground.count; ++i) {
      inner[i] = ground.ids[i];
      fits = fits && problem_.object_is_a(inner[i], definition.slots[i]);
    }
    if (fits && holds(definition.body, definition.slots, inner, state)) return true;
  }
  return state.contains(atom.predicate, ground.ids.data(), ground.count);
}

bool Interpreter::holds(const Formula& formula, std::span<const TypeSet> slots,
                        std::vector<ObjectId>& binding, const AtomSet& state) const {
  const auto child = [&](const Formula& inner) { return holds(inner, slots, binding, state); };
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return true;
    case Formula::Kind::kFalse:
      return false;
    case Formula::Kind::kAtom:
      return atom_holds(formula.atom, binding, state);
    case Formula::Kind::kEqual:
      return formula.atom.arguments[0].resolve(binding.data()) ==
             formula.atom.arguments[1].resolve(binding.data());
    case Formula::Kind::kNot:
      return !child(formula.children.front());
    case Formula::Kind::kAnd:
      return std::all_of(formula.children.begin(), formula.children.end(), child);
    case Formula::Kind::kOr:
      return std::any_of(formula.children.begin(), formula.children.end(), child);
    case Formula::Kind::kForall:
    case Formula::Kind::kExists: {
      const Formula& inner = formula.children.front();
      for (const std::int32_t slot : formula.slots) binding[static_cast<std::size_t>(slot)] = -1;
      return quantified(formula.slots, 0, inner, formula.kind == Formula::Kind::kForall, slots, binding,
                        state, [&] { return child(inner); });
    }
  }
  return false;
}

void Interpreter::collect(const Effect& effect, std::span<const TypeSet> slots,
                          std::vector<ObjectId>& binding, const AtomSet& state,
                          std::vector<AtomChange>* added, std::vector<AtomChange>* deleted) const {
  switch (effect.kind) {
    case Effect::Kind::kAdd:
    case Effect::Kind::kDelete: {
      const Ground ground(effect.atom, binding);
      const bool add = effect.kind == Effect::Kind::kAdd;
      // Deleting what does not hold changes nothing, and quantified effects delete a lot of that.
      if (!add && !state.contains(effect.atom.predicate, ground.ids.data(), ground.count)) return;
      (add ? added : deleted)
          ->push_back({effect.atom.predicate,
                       {ground.ids.begin(), ground.ids.begin() + static_cast<std::ptrdiff_t>(ground.count)},
                       add});
      return;
    }
    case Effect::Kind::kAnd:
      for (const Effect& child : effect.children) collect(child, slots, binding, state, added, deleted);
      return;
    case Effect::Kind::kWhen:
      if (holds(effect.condition, slots, binding, state)) {
        collect(effect.children.front(), slots, binding, state, added, deleted);
      }
      return;
    case Effect::Kind::kForall:
      for_each_binding(effect.slots, 0, slots, binding, [&] {
        collect(effect.children.front(), slots, binding, state, added, deleted);
        return true;
      });
      return;
  }
}

std::vector<AtomChange> Interpreter::changes(const Effect& effect, std::span<const TypeSet> slots,
                                             std::vector<ObjectId>& binding, const AtomSet& state) const {
  std::vector<AtomChange> added, deleted;
  collect(effect, slots, binding, state, &added, &deleted);
  deleted.insert(deleted.end(), added.begin(), added.end());
  return deleted;
}

Expected<std::int64_t> Interpreter::cost(const ActionSchema& schema,
                                         const std::vector<ObjectId>& binding) const {
  if (!problem_.minimise_cost) return 1;
  std::int64_t total = schema.cost.constant;
  for (const AtomPattern& function : schema.cost.functions) {
    const Ground ground(function, binding);
    const std::int32_t index = problem_.cost_atoms.find(function.predicate, ground.ids.data(), ground.count);
    if (index == AtomTable::kNone) {
      return fail(Outcome::kInvalidRequest, "the problem gives no value for function " +
                                                problem_.domain().functions.name(function.predicate));
    }
    total += problem_.cost_values[static_cast<std::size_t>(index)];
  }
  return total;
}

}  // namespace goalnet::planner
