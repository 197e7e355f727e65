// What the world must show after an action and after a step. The symbolic rules are stricter than the world
// in two places: moving somewhere forgets all other Near facts although the robot may still be near, and
// which hand or tray slot holds an object is manipulation's choice. Neither is a reason to call an action
// failed.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::coordinator {

// Whether `fact` says where the robot stands.
bool is_robot_near(const Predicate& fact);

// The difference that one action should make.
struct Expectation {
  FactSet added;    // must hold afterwards
  FactSet removed;  // must not hold afterwards
};

// From the facts before the action to those the rules predict.
Expectation expected_change(const FactSet& before, const FactSet& predicted);

// What `facts` still lacks: an empty result means the action did what it should. Negative entries are facts
// that should have gone.
struct Shortfall {
  std::vector<Predicate> missing;
  std::vector<Predicate> remaining;

  bool empty() const { return missing.empty() && remaining.empty(); }
};
Shortfall shortfall(const Expectation& expectation, const FactSet& facts);

// Whether what is lacking is only what the rules say of things that the action was not done with and that
// nobody asked for, while the action did what it was done for: a tap that is turned on fills all that is in
// the sink by the rules, but only what stands under it in the world.
bool only_besides(const Shortfall& shortfall, const Expectation& expectation, const Action& action,
                  const Goal& goal);

// The goal to take something in the hand that an action on something else should have changed where it
// stands, but did not: from there it can be put right, under the tap. Rather what `goal` asks for than what
// stands beside it. Empty if there is no such thing.
Goal taking_in_hand(const Shortfall& shortfall, const Action& action, const FactSet& facts, const Goal& goal);

// "lacks (On Mug_1 Sink), still has (Grasping Robot Mug_1)"; at most a handful are named.
std::string to_string(const Shortfall& shortfall);

// What of `goal` the world still owes. Positive (Near Robot x) is a means where anything else is asked for,
// as in the planner; where nothing else is asked for they are visits, and having been there since the step
// began (`visited`) counts. Negative (Near Robot x) is never owed.
Shortfall goal_shortfall(const Goal& goal, const FactSet& facts, const FactSet& visited);

}  // namespace goalnet::coordinator
