#include "tools/goalnet/component_registry.h"

#include <algorithm>
#include <utility>

#include "components/coordinator/coordinator_node.h"
#include "components/goalnet/goalnet_node.h"
#include "components/manipulation/manipulation_node.h"
#include "components/planner/planner_node.h"
#include "components/visualization/visualization_node.h"
#include "components/world_model/world_model_node.h"
#include "executor/executor_node.h"
#include "sim/simulator_node.h"

namespace goalnet::tools {
namespace {

template <class Component>
Expected<std::unique_ptr<ros::Component>> create(ros::Node& node) {
  auto component = Component::create(node);
  if (!component) return tl::unexpected<Error>(std::move(component.error()));
  return std::unique_ptr<ros::Component>(std::move(*component));
}

constexpr ComponentKind kKinds[] = {
    {"simulator", "the kitchen or living room in Bullet, with the robot in it", create<sim::SimulatorNode>},
    {"executor", "follows trajectories at 1 kHz within limits", create<executor::ExecutorNode>},
    {"world_model", "poses and joint positions to symbolic facts", create<world_model::WorldModelNode>},
    {"goalnet", "sentence and world to goal predicates", create<inference::GoalnetNode>},
    {"planner", "goal predicates to a plan", create<planner::PlannerNode>},
    {"manipulation", "symbolic actions to trajectories", create<manipulation::ManipulationNode>},
    {"coordinator", "the loop: infer, plan, act, observe", create<coordinator::CoordinatorNode>},
    {"visualization", "markers of objects, facts, goal and path for RViz",
     create<visualization::VisualizationNode>},
};

}  // namespace

std::span<const ComponentKind> component_kinds() { return kKinds; }

const ComponentKind* find_component_kind(std::string_view name) {
  const auto kinds = component_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [name](const ComponentKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace goalnet::tools
