#include "components/planner/planner_node.h"

#include <chrono>
#include <utility>

#include "components/core/config_path.h"
#include "components/messages/conversions.h"
#include "components/planner/household_goal.h"
#include "components/planner/world.h"

namespace goalnet::planner {

using goalnet_msgs::msg::GoalPredicates;

Expected<std::unique_ptr<PlannerNode>> PlannerNode::create(ros::Node& node) {
  const auto path = node.declare_parameter<std::string>("domain", config_path("domains/household.pddl"),
                                                        {.description = "PDDL domain to plan with",
                                                         .read_only = true,
                                                         .range = {},
                                                         .additional_constraints = "a file"});
  if (!path) return tl::unexpected<Error>(path.error());
  const auto node_limit = node.declare_parameter<std::int64_t>(
      "node_limit", 100'000,
      {.description =
           "States the optimal search may expand before a quicker, not optimal one takes over; 0: no limit",
       .read_only = true,
       .range = ros::ParameterRange{0.0, 1e12, 0.0},
       .additional_constraints = ""});
  if (!node_limit) return tl::unexpected<Error>(node_limit.error());
  const auto time_limit =
      node.declare_parameter<double>("time_limit", 10.0,
                                     {.description = "Wall-clock time for one plan [s]; 0: no limit",
                                      .read_only = true,
                                      .range = ros::ParameterRange{0.0, 1e6, 0.0},
                                      .additional_constraints = ""});
  if (!time_limit) return tl::unexpected<Error>(time_limit.error());
  auto domain = load_domain(*path);
  if (!domain) return tl::unexpected<Error>(std::move(domain.error()));
  SolveOptions options;
  options.node_limit = *node_limit;
  options.time_limit = std::chrono::nanoseconds(static_cast<std::int64_t>(*time_limit * 1e9));
  auto planner = std::unique_ptr<PlannerNode>(
      new PlannerNode(node, std::make_unique<const Domain>(std::move(*domain)), options));
  planner->open_topics();
  return planner;
}

PlannerNode::PlannerNode(ros::Node& node, std::unique_ptr<const Domain> domain, const SolveOptions& options)
    : node_(node), domain_(std::move(domain)), planner_(*domain_), options_(options) {}

void PlannerNode::open_topics() {
  plan_ = node_.advertise<goalnet_msgs::msg::Plan>("plan");
  goal_ = node_.subscribe<GoalPredicates>("goal_predicates", ros::Qos::standard(),
                                          [this](const GoalPredicates& message) { on_goal(message); });
  world_state_ = node_.subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", ros::Qos::latched(),
      [this](const goalnet_msgs::msg::WorldState& message) { on_world(message); });
}

void PlannerNode::interrupt() {
  const std::lock_guard lock(stop_mutex_);
  stop_.request_stop();
}

void PlannerNode::on_world(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) return node_.log().warn("world_state: {}", world.error().message);
  world_ = std::move(*world);
  if (waiting_) answer(*std::exchange(waiting_, {}));
}

void PlannerNode::on_goal(const GoalPredicates& message) {
  if (message.complete() || message.outcome() != 0) return;  // nothing is asked for
  if (world_) return answer(message);
  node_.log().info("a goal waits for the first world state");
  waiting_ = message;
}

void PlannerNode::answer(const GoalPredicates& message) {
  goalnet_msgs::msg::Plan answer;
  answer.instruction_id(message.instruction_id());
  answer.step(message.step());
  const auto goal = messages::goal_from_message(message);
  const Expected<Plan> plan = goal ? plan_for(*goal) : Expected<Plan>(tl::unexpected<Error>(goal.error()));
  if (plan) {
    answer.actions(messages::to_message(plan->actions));
    answer.optimal(plan->optimal);
  } else {
    answer.outcome(static_cast<std::int32_t>(plan.error().outcome));
    answer.message(plan.error().message);
  }
  answer.header().stamp(node_.now());
  plan_->publish(answer);
}

// A goal of visits is several goals, each planned from where the one before ends.
Expected<Plan> PlannerNode::plan_for(const Goal& goal) {
  SolveOptions options = options_;
  {
    const std::lock_guard lock(stop_mutex_);
    stop_ = std::stop_source();
    options.stop = stop_.get_token();
  }
  WorldState state = *world_;
  Plan whole;
  whole.optimal = true;
  for (const Goal& part : normalise_household_goal(goal)) {
    auto plan = planner_.solve(state, part, options);
    if (!plan) return plan;
    for (Action& action : plan->actions) {
      auto facts = apply(*domain_, state, action);
      if (!facts) return tl::unexpected<Error>(std::move(facts.error()));
      state.facts = std::move(*facts);
      whole.actions.push_back(std::move(action));
    }
    whole.cost += plan->cost;
    whole.optimal = whole.optimal && plan->optimal;
  }
  return whole;
}

}  // namespace goalnet::planner
