// Verbs with their arguments, and what demonstrations say they may mean: sets of changed facts over the
// arguments.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/demonstration.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/network/lexicon.h"

namespace goalnet::inference::baseline {

// "take pot to sink" with pot -> {Kettle}, sink -> {Sink}: verb "take", two arguments.
struct VerbFrame {
  std::string verb;  // empty when the sentence has none
  std::vector<std::vector<std::string>>
      candidates;  // by argument, in the order of the sentence; never empty ones
};

// The verb is the first word that is neither an argument nor a filler ("and", "then", ...). Without a
// grounding the arguments are the words that have meant classes of objects which `state` has.
VerbFrame find_frame(const std::string& sentence, const Grounding* grounding, const network::Lexicon& lexicon,
                     const WorldState& state);

// A fact that changes; "?1" stands for the first argument.
struct Change {
  bool added = true;
  Predicate fact;
  auto operator<=>(const Change&) const = default;
};
// A hypothesis of what a verb means: changes that hold together. Sorted.
using Hypothesis = std::vector<Change>;

// Objects that are candidates of an argument become its variable.
Hypothesis generalise(const Goal& change, const VerbFrame& frame);
// The same hypothesis about things: variables become `arguments`. False when a variable has no argument.
bool instantiate(const Hypothesis& hypothesis, const std::vector<std::string>& arguments, Goal& goal);

// What a demonstration changed from its first to its last state. Near and the hand's way are means, not ends,
// where anything else changed: they are left out there.
Goal net_change(const Demonstration& demonstration);

}  // namespace goalnet::inference::baseline
