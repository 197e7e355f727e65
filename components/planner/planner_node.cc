#include "components/planner/planner_node.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "components/core/config_path.h"
#include "components/messages/conversions.h"
#include "components/planner/household_goal.h"
#include "components/planner/world.h"

namespace goalnet::planner {

using goalnet_msgs::msg::GoalPredicates;

void PlannerNode::describe(ros::ParameterSet& set, Params& params) {
  set.text("domain", params.domain, "PDDL domain to plan with", "a name in config/domains or a file");
  set.whole("node_limit", params.node_limit,
            "states the optimal search may expand before a quicker, not optimal one takes over; 0: no limit",
            0.0, 1e12)
      .settable = ros::Settable::kAnyTime;
  set.number("time_limit", params.time_limit, "wall-clock time for one plan [s]; 0: no limit", 0.0, 1e6)
      .settable = ros::Settable::kAnyTime;
  set.flag("lockstep", params.lockstep,
           "search in the event loop, so that simulated time stands still; no thread of its own");
}

Expected<std::unique_ptr<PlannerNode>> PlannerNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<PlannerNode>(new PlannerNode(node)));
}

PlannerNode::PlannerNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, params_); }

Expected<void> PlannerNode::on_configure() {
  std::stop_token stop;
  {
    const std::lock_guard lock(stop_mutex_);
    stop_ = std::stop_source();
    stop = stop_.get_token();
  }
  auto domain = load_domain(config_file("domains", params_.domain, ".pddl"), stop);
  if (!domain) return tl::unexpected<Error>(std::move(domain.error()));
  domain_ = std::make_unique<const Domain>(std::move(*domain));
  planner_.emplace(*domain_, stop);
  if (stop.stop_requested()) return fail(Outcome::kCancelled, "preparing the domain was cancelled");
  return {};
}

Expected<void> PlannerNode::on_activate() {
  plan_ = node_.advertise<goalnet_msgs::msg::Plan>("plan");
  // A goal must end the search for the one before it even while that keeps the event loop busy (lockstep),
  // and before its own turn comes: else it would itself be taken for the one before.
  goal_ = node_.subscribe<GoalPredicates>(
      "goal_predicates", ros::Qos::standard(), [this](const GoalPredicates& message) { on_goal(message); },
      {}, [this](const GoalPredicates& message) { on_newer(message); });
  world_state_ = node_.subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", ros::Qos::latched(),
      [this](const goalnet_msgs::msg::WorldState& message) { on_world(message); });
  // A cancel must not wait for the event loop either.
  cancel_ = node_.subscribe<goalnet_msgs::msg::CancelInstruction>(
      "cancel_instruction", ros::Qos::standard(),
      [this](const goalnet_msgs::msg::CancelInstruction& message) { on_cancel(message); },
      {.immediate = true});
  return {};
}

Expected<void> PlannerNode::on_deactivate() {
  cancel_.reset();
  goal_.reset();
  stop_searching();
  world_state_.reset();
  plan_.reset();
  waiting_.reset();
  world_.reset();
  return {};
}

Expected<void> PlannerNode::on_cleanup() {
  planner_.reset();
  domain_.reset();
  return {};
}

PlannerNode::~PlannerNode() { stop_searching(); }

// Nobody is answered. Takes as long as a search needs to see that it is to stop: about a millisecond.
void PlannerNode::stop_searching() {
  interrupt();
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  search_.reset();
}

void PlannerNode::interrupt() {
  const std::lock_guard lock(stop_mutex_);
  stop_.request_stop();
}

void PlannerNode::on_cancel(const goalnet_msgs::msg::CancelInstruction& message) {
  const std::lock_guard lock(stop_mutex_);
  const std::uint64_t id = message.instruction_id();
  if (id != 0)
    cancelled_[next_cancelled_++ % cancelled_.size()] = id;  // its goal may still wait in the loop's queue
  if (id == 0 || id == instruction_) stop_.request_stop();
}

PlannerNode::GoalKey PlannerNode::key_of(const GoalPredicates& message) {
  const auto& stamp = message.header().stamp();
  return {message.instruction_id(), message.step(), stamp.sec(), stamp.nanosec()};
}

void PlannerNode::on_newer(const GoalPredicates& message) {
  const std::lock_guard lock(stop_mutex_);
  newest_ = key_of(message);
  if (newest_ != current_) stop_.request_stop();
}

void PlannerNode::on_world(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) {
    return bad_worlds_.write(
        [&](const std::string& more) { node_.log().warn("world_state: {}{}", world.error().message, more); });
  }
  world_ = std::move(*world);
  if (waiting_ && !search_) start(*std::exchange(waiting_, {}));
}

void PlannerNode::on_goal(const GoalPredicates& message) {
  if (message.complete() || message.outcome() != 0) return;  // nothing is asked for
  if (world_ && !search_) return start(message);
  if (!world_ && !waiting_) node_.log().info("a goal waits for the first world state");
  wait(message);
}

// The newest goal waits; one that waited before has had its time.
void PlannerNode::wait(const GoalPredicates& message) {
  const auto before = std::exchange(waiting_, message);
  // The same goal again is one question.
  if (before && key_of(*before) != key_of(message))
    finish({*before, fail(Outcome::kCancelled, "a newer goal has come")});
}

void PlannerNode::start(const GoalPredicates& message) {
  auto search = std::make_shared<Search>(Search{message});
  SolveOptions options;
  options.node_limit = params_.node_limit;
  options.time_limit = std::chrono::nanoseconds(static_cast<std::int64_t>(params_.time_limit * 1e9));
  options.stop = note_current(message);
  if (params_.lockstep) {
    search->plan = plan_for(message, *world_, options);
    return finish(*search);
  }
  search_ = search;
  thread_ = std::jthread([this, search, options, world = *world_](const std::stop_token& end) mutable {
    search->plan = plan_for(search->message, std::move(world), options);
    // Whoever drops search_ wants no answer.
    const auto done = [this, weak = std::weak_ptr<Search>(search)] {
      const std::shared_ptr<Search> ended = weak.lock();
      if (!ended || ended != search_) return;
      search_.reset();
      finish(*ended);
      if (waiting_ && world_) start(*std::exchange(waiting_, {}));
    };
    while (!node_.loop().post(done) && !end.stop_requested())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
}

// Notes what is planned for now. The token is stopped already where nobody wants the answer any more.
std::stop_token PlannerNode::note_current(const GoalPredicates& message) {
  const std::lock_guard lock(stop_mutex_);
  stop_ = std::stop_source();
  current_ = key_of(message);
  instruction_ = message.instruction_id();
  const bool cancelled = std::find(cancelled_.begin(), cancelled_.end(), instruction_) != cancelled_.end();
  if ((instruction_ != 0 && cancelled) || newest_ != current_) stop_.request_stop();
  return stop_.get_token();
}

// Publishes the answer, unless it could be taken for the answer to a newer goal.
void PlannerNode::finish(const Search& search) {
  const GoalPredicates& message = search.message;
  goalnet_msgs::msg::Plan answer;
  answer.instruction_id(message.instruction_id());
  answer.step(message.step());
  if (search.plan) {
    answer.actions(messages::to_message(search.plan->actions));
    answer.optimal(search.plan->optimal);
  } else {
    answer.outcome(static_cast<std::int32_t>(search.plan.error().outcome));
    answer.message(search.plan.error().message);
  }
  {
    const std::lock_guard lock(stop_mutex_);
    const bool superseded = newest_ != key_of(message);
    if (superseded && !search.plan && search.plan.error().outcome == Outcome::kCancelled) {
      const auto [instruction, step, sec, nanosec] = newest_;
      if (instruction == message.instruction_id() && step == message.step()) return;
      answer.message("a newer goal has come");
    }
  }
  answer.header().stamp(node_.now());
  plan_->publish(answer);
}

// A goal of visits is several goals, each planned from where the one before ends. In whichever thread
// searches.
Expected<Plan> PlannerNode::plan_for(const GoalPredicates& message, WorldState state,
                                     const SolveOptions& options) {
  const auto goal = messages::goal_from_message(message);
  if (!goal) return tl::unexpected<Error>(goal.error());
  Plan whole;
  whole.optimal = true;
  for (const Goal& part : normalise_household_goal(*goal)) {
    auto plan = planner_->solve(state, part, options);
    if (!plan) {
      if (plan.error().outcome != Outcome::kNoPlan) return plan;
      const std::string reason = misfit(part, state.facts);
      return reason.empty() ? plan : fail(Outcome::kNoPlan, "there is no plan: " + reason);
    }
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
