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
Expected<std::unique_ptr<ros::ManagedComponent>> create(ros::Node& node) {
  auto component = Component::create(node);
  if (!component) return tl::unexpected<Error>(std::move(component.error()));
  return std::unique_ptr<ros::ManagedComponent>(std::move(*component));
}

template <class Component>
std::string table(bool markdown) {
  typename Component::Params params;
  ros::ParameterSet set;
  Component::describe(set, params);
  return markdown ? ros::to_markdown(set) : ros::to_text(set);
}

template <class Component>
constexpr ComponentKind kind(std::string_view name, std::string_view summary) {
  return {name, summary, create<Component>, table<Component>};
}

constexpr ComponentKind kKinds[] = {
    kind<sim::SimulatorNode>("simulator", "the kitchen or living room in Bullet, with the robot in it"),
    kind<executor::ExecutorNode>("executor", "follows trajectories at 1 kHz within limits"),
    kind<world_model::WorldModelNode>("world_model", "poses and joint positions to symbolic facts"),
    kind<inference::GoalnetNode>("goalnet", "sentence and world to goal predicates"),
    kind<planner::PlannerNode>("planner", "goal predicates to a plan"),
    kind<manipulation::ManipulationNode>("manipulation", "symbolic actions to trajectories"),
    kind<coordinator::CoordinatorNode>("coordinator", "the loop: infer, plan, act, observe"),
    kind<visualization::VisualizationNode>("visualization",
                                           "markers of objects, facts, goal and path for RViz"),
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
