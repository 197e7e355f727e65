#include "components/coordinator/planner_action_model.h"

#include "components/planner/world.h"

namespace goalnet::coordinator {

Expected<void> PlannerActionModel::applicable(const WorldState& world, const Action& action) const {
  return planner::applicable(domain_, world, action);
}

Expected<FactSet> PlannerActionModel::apply(const WorldState& world, const Action& action) const {
  return planner::apply(domain_, world, action);
}

}  // namespace goalnet::coordinator
