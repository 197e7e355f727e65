#include "components/planner/toggles.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostToggles = 3;  // per schema

// A literal over parameters and constants that some effect is conditional on, while another is on its
// opposite.
const LiteralPattern* find_toggle(const CompiledSchema& schema) {
  constexpr std::size_t kMostEffects = 400;  // every one is compared with every other
  if (schema.effects.size() > kMostEffects) return nullptr;
  const auto ground_with_action = [&](const LiteralPattern& literal) {
    return std::all_of(literal.atom.arguments.begin(), literal.atom.arguments.end(), [&](Term term) {
      return !term.is_variable() || term.slot() < schema.parameter_count;
    });
  };
  for (const CompiledEffect& one : schema.effects) {
    for (const LiteralPattern& literal : one.condition.fluent) {
      if (!ground_with_action(literal)) continue;
      for (const CompiledEffect& other : schema.effects) {
        for (const LiteralPattern& second : other.condition.fluent) {
          if (opposite(literal, second)) return &literal;
        }
      }
    }
  }
  return nullptr;
}

CompiledSchema assume(const CompiledSchema& schema, const LiteralPattern& literal, Arena& arena) {
  CompiledSchema result = schema;
  std::vector<CompiledEffect> effects;
  for (const CompiledEffect& effect : schema.effects) {
    const auto& known = effect.condition.fluent;
    if (std::any_of(known.begin(), known.end(), [&](const auto& l) { return opposite(l, literal); }))
      continue;
    effects.push_back(effect);
    std::vector<LiteralPattern> others;
    std::copy_if(known.begin(), known.end(), std::back_inserter(others),
                 [&](const auto& l) { return !same(l, literal); });
    effects.back().condition.fluent = arena.copy(others);
  }
  result.effects = arena.copy(effects);
  const auto& fluent = schema.precondition.fluent;
  if (std::none_of(fluent.begin(), fluent.end(), [&](const auto& l) { return same(l, literal); })) {
    std::vector<LiteralPattern> with(fluent.begin(), fluent.end());
    with.push_back(literal);
    result.precondition.fluent = arena.copy(with);
  }
  return result;
}

// Asks only where that is quick; an action that can never run does no harm.
bool contradictory(const Condition& condition) {
  constexpr std::size_t kMostLiterals = 1000;
  if (condition.fluent.size() > kMostLiterals) return false;
  for (std::size_t i = 0; i < condition.fluent.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (opposite(condition.fluent[i], condition.fluent[j])) return true;
    }
  }
  return false;
}

void split(const CompiledSchema& schema, std::size_t budget, Arena& arena, Chunks<CompiledSchema>* result) {
  const LiteralPattern* toggle = budget == 0 ? nullptr : find_toggle(schema);
  if (toggle == nullptr) {
    if (!schema.effects.empty() && !contradictory(schema.precondition)) result->push_back(schema);
    return;
  }
  LiteralPattern literal = *toggle;
  split(assume(schema, literal, arena), budget - 1, arena, result);
  literal.negative = !literal.negative;
  split(assume(schema, literal, arena), budget - 1, arena, result);
}

}  // namespace

void split_toggles(const CompiledSchema& schema, Arena& arena, Chunks<CompiledSchema>* result) {
  split(schema, kMostToggles, arena, result);
}

}  // namespace goalnet::planner
