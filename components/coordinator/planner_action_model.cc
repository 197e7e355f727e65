#include "components/coordinator/planner_action_model.h"

#include "components/planner/world.h"

namespace goalnet::coordinator {

Expected<void> PlannerActionModel::applicable(const WorldState& world, const Action& action) const {
  return planner::applicable(domain_, world, action);
}

Expected<FactSet> PlannerActionModel::apply(const WorldState& world, const Action& action) const {
  return planner::apply(domain_, world, action);
}

Goal PlannerActionModel::as_spelled(const Goal& goal) const {
  const auto spell = [](const planner::SymbolTable& table, std::string& name) {
    if (const auto id = table.find(name); id != planner::SymbolTable::kNone) name = table.name(id);
  };
  Goal out = goal;
  for (auto* facts : {&out.positive, &out.negative}) {
    for (Predicate& fact : *facts) {
      spell(domain_.predicates, fact.relation);
      spell(domain_.constants, fact.subject);
      spell(domain_.constants, fact.object);
    }
  }
  return out;
}

}  // namespace goalnet::coordinator
