// What the coordinator needs to know of actions: whether one can be done here, and what it should change.
#pragma once

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::coordinator {

// Called from the coordinator's thread only. The planner's domain implements it (planner_action_model.h);
// tests bring smaller worlds.
class ActionModel {
 public:
  virtual ~ActionModel() = default;

  // Nothing if `action` can be carried out in `world`; otherwise an error that names the violated
  // precondition.
  virtual Expected<void> applicable(const WorldState& world, const Action& action) const = 0;

  // The facts after `action` in `world`.
  virtual Expected<FactSet> apply(const WorldState& world, const Action& action) const = 0;

  // The goal with its names spelled as in facts, where only capital letters differ: rules do not tell (state
  // Mug_1 Spoon) from (state Mug_1 spoon), sets of facts do.
  virtual Goal as_spelled(const Goal& goal) const { return goal; }
};

}  // namespace goalnet::coordinator
