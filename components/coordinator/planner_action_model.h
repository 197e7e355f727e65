// The action model that the planner plans with: config/domains/household.pddl.
#pragma once

#include "components/coordinator/action_model.h"
#include "components/planner/domain.h"

namespace goalnet::coordinator {

class PlannerActionModel : public ActionModel {
 public:
  explicit PlannerActionModel(planner::Domain domain) : domain_(std::move(domain)) {}

  Expected<void> applicable(const WorldState& world, const Action& action) const override;
  Expected<FactSet> apply(const WorldState& world, const Action& action) const override;
  Goal as_spelled(const Goal& goal) const override;

 private:
  planner::Domain domain_;
};

}  // namespace goalnet::coordinator
