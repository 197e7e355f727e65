// Splits actions that switch something into two, on and off. Internal to the planner.
#pragma once

#include <vector>

#include "components/planner/compiled_domain.h"

namespace goalnet::planner {

inline bool same(const LiteralPattern& left, const LiteralPattern& right) {
  return left.negative == right.negative && left.atom == right.atom;
}
inline bool opposite(const LiteralPattern& left, const LiteralPattern& right) {
  return left.negative != right.negative && left.atom == right.atom;
}

// Appends the cases of a schema, or nothing where it can never run or has no effect.
void split_toggles(const CompiledSchema& schema, Arena& arena, Chunks<CompiledSchema>* result);

}  // namespace goalnet::planner
