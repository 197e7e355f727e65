// SymSim: the rules of the benchmark domain (design/benchmark.pddl's rules, oddities included) on packed
// states. Thousands of times faster than a general planner; a test compares it with
// config/domains/benchmark.pddl.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

enum class Verb : std::uint8_t {
  kStop,  // no action: the run is over
  kMoveTo,
  kGrasp,
  kRelease,
  kPress,
  kTurn,
  kOpen,
  kClose,
  kKeepOn,
  kKeepIn,
  kKeepNear,
  kPour,  // away
  kPourInto,
  kAdd,
  kSqueeze,
  kScoop,
  kPlace,
  kInsert,
};
inline constexpr std::size_t kVerbs = 18;

struct SymAction {
  Verb verb = Verb::kStop;
  Symbol x = symbol::kNone;
  Symbol y = symbol::kNone;

  auto operator<=>(const SymAction&) const = default;
};

bool applicable(const SymAction& action, const SymState& state);
// The state after `action`. The precondition is not looked at.
void apply(const SymAction& action, SymState& state);

// As the demonstrations spell actions: "keep Mug_1 On Sink", "turn SinkKnob".
std::string to_string(const SymAction& action, const Symbols& symbols);
// The inverse; kInvalidRequest for an unknown verb. A malformed "keep X Y Z" reads as "release X"
// (domain.md).
Expected<SymAction> parse_action(std::string_view text, Symbols& symbols);

// The shortest run of actions, in the natural order (go there, take it, go on), that ends with `action`: go
// to what must be near, grasp what must be held, open what must be open, and do it. Empty when nothing leads
// there (for example grasping what is held, or what cannot be grasped).
std::vector<SymAction> with_means(const SymAction& action, const SymState& state);

}  // namespace goalnet::inference
