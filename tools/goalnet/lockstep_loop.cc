#include "tools/goalnet/lockstep_loop.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

#include "components/coordinator/coordinator_node.h"
#include "components/coordinator/status_message.h"
#include "components/messages/conversions.h"
#include "components/ros/bag/recorder.h"
#include "components/ros/node.h"
#include "executor/executor_node.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sim/render.h"
#include "sim/simulator_node.h"
#include "std_msgs/msg/String.h"
#include "tools/goalnet/component_registry.h"
#include "tools/goalnet/parameter_check.h"

namespace goalnet::tools {
namespace {

// [s] simulated: how much longer a recording goes on, so that what follows from the end is in it, too.
constexpr double kEpilogue = 0.3;

// Behind the robot and to its left, above its head: shows what its hands do wherever it stands.
sim::Camera over_the_shoulder(const sim::World& world) {
  const scene::Pose base = world.robot_link_pose("base_link");
  sim::Camera camera;
  camera.eye = base * Eigen::Vector3d(-0.75, 1.15, 1.95);
  camera.target = base * Eigen::Vector3d(0.65, 0.0, 0.95);
  camera.width = 960;
  camera.height = 720;
  return camera;
}

using goalnet_msgs::msg::ActionStatus;
using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;

// What one node is told; people's own arguments come after and win.
ros::Arguments node_arguments(const LoopOptions& options, std::string_view component) {
  ros::Arguments arguments = options.arguments;
  std::vector<ros::ParameterOverride> own;
  const auto set = [&](const char* name, ros::ParameterValue value) {
    own.push_back({"/**", name, std::move(value), "goalnet run"});  // in any namespace, under any name
  };
  const bool simulator = component == "simulator", executor = component == "executor";
  const bool manipulation = component == "manipulation", world_model = component == "world_model";
  const bool visualization = component == "visualization";
  set("use_sim_time", true);  // the simulator's own diagnostics and log, too
  if (simulator || executor || component == "planner") set("lockstep", true);
  if (simulator || manipulation || world_model || visualization) set("scene", options.scene);
  if (simulator) set("seed", static_cast<std::int64_t>(options.seed));
  if ((simulator || executor || manipulation || world_model || visualization) && !options.robot.empty())
    set("robot", options.robot);
  if (component == "goalnet" && !options.model.empty()) set("model", options.model);
  if (component == "coordinator") {
    if (options.max_steps > 0) set("max_steps", static_cast<std::int64_t>(options.max_steps));
    if (options.instruction_timeout > 0.0) set("instruction_timeout", options.instruction_timeout);
  }
  if (component == "coordinator") set("first_id", std::int64_t{1});  // the same in every run
  own.insert(own.end(), arguments.parameters.begin(), arguments.parameters.end());
  set("autostart", true);  // nobody else would; a loop without one of its components is none
  arguments.parameters = std::move(own);
  arguments.console = options.console && arguments.console;
  // One name cannot be for all.
  std::erase_if(arguments.remaps, [](const ros::Remap& rule) {
    return rule.kind == ros::RemapKind::kNodeName && rule.node.empty();
  });
  return arguments;
}

}  // namespace

// Members are destroyed from the last to the first: components before their nodes, nodes before the context.
struct LockstepLoop::Impl {
  std::unique_ptr<ros::Context> context;
  ros::EventLoop loop;
  std::vector<std::unique_ptr<ros::Node>> nodes;
  std::map<std::string, std::unique_ptr<ros::ManagedComponent>, std::less<>> components;
  LoopEvents events;
  std::unique_ptr<ros::Recorder> recorder;
  ros::Node* observer = nullptr;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> instruction;
  std::shared_ptr<ros::Publisher<GoalPredicates>> goal;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status;
  std::shared_ptr<ros::Subscription<ActionStatus>> action_status;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state;
  sim::SimulatorNode* simulator = nullptr;
  coordinator::CoordinatorNode* coordinator = nullptr;
  bool world_seen = false;

  ~Impl() {
    recorder.reset();
    world_state.reset();
    action_status.reset();
    status.reset();
    goal.reset();
    instruction.reset();
    components.clear();
    nodes.clear();
  }

  Expected<ros::Node*> add_node(ros::NodeOptions options) {
    auto node = ros::Node::create(*context, loop, std::move(options));
    if (!node) return tl::unexpected<Error>(std::move(node.error()));
    nodes.push_back(std::move(*node));
    return nodes.back().get();
  }
  // Whether to go on.
  Expected<void> asked() const {
    if (events.stop_asked && events.stop_asked())
      return fail(Outcome::kCancelled, "interrupted before it began");
    return {};
  }
  Expected<void> alone() const;
  Expected<void> add_recorder(const LoopOptions& options);
  Expected<void> add_components(const LoopOptions& options);
  Expected<void> add_observer(const LoopOptions& options);
};

// Two robots of the same names would obey each other's commands and clocks, and neither run would mean
// anything.
Expected<void> LockstepLoop::Impl::alone() const {
  const std::vector<std::string> others = context->other_nodes();
  for (const auto& node : nodes) {
    if (!std::binary_search(others.begin(), others.end(), node->full_name())) continue;
    return fail(Outcome::kBusy,
                "another robot is up on ROS_DOMAIN_ID " + std::to_string(context->domain_id()) + ": it has " +
                    node->full_name() +
                    ", too; give this run another ROS_DOMAIN_ID, a namespace (--ros-args -r __ns:=/NAME), or "
                    "nobody else to talk to (--private)");
  }
  return {};
}

// Before all others, so that it hears them from their first word.
Expected<void> LockstepLoop::Impl::add_recorder(const LoopOptions& options) {
  if (options.record.empty()) return {};
  ros::RecorderOptions recorder_options;
  auto storage = ros::parse_bag_storage(options.record_storage);
  if (!storage) return tl::unexpected<Error>(std::move(storage.error()));
  recorder_options.bag.directory = options.record;
  recorder_options.bag.storage = *storage;
  recorder_options.lockstep = true;
  ros::NodeOptions node_options;
  node_options.name = "goalnet_record";
  node_options.arguments = node_arguments(options, "goalnet_record");
  auto node = add_node(std::move(node_options));
  if (!node) return tl::unexpected<Error>(std::move(node.error()));
  auto made = ros::Recorder::create(**node, std::move(recorder_options));
  if (!made) return tl::unexpected<Error>(std::move(made.error()));
  recorder = std::move(*made);
  return {};
}

Expected<void> LockstepLoop::Impl::add_components(const LoopOptions& options) {
  for (const ComponentKind& kind : component_kinds()) {
    ros::NodeOptions node_options;
    node_options.name = kind.name;
    node_options.arguments = node_arguments(options, kind.name);
    auto node = add_node(std::move(node_options));
    if (!node) return tl::unexpected<Error>(std::move(node.error()));
    if (auto go_on = asked(); !go_on) return go_on;
    auto component = kind.create(**node);
    if (!component) return tl::unexpected<Error>(std::move(component.error()));
    components.emplace(kind.name, std::move(*component));
  }
  simulator = dynamic_cast<sim::SimulatorNode*>(components.at("simulator").get());
  coordinator = dynamic_cast<coordinator::CoordinatorNode*>(components.at("coordinator").get());
  auto* executor = dynamic_cast<executor::ExecutorNode*>(components.at("executor").get());
  simulator->set_controller(executor->lockstep_hook());
  return {};
}

Expected<void> LockstepLoop::Impl::add_observer(const LoopOptions& options) {
  ros::NodeOptions node_options;
  node_options.name = "goalnet_run";
  node_options.arguments = node_arguments(options, "goalnet_run");
  auto node = add_node(std::move(node_options));
  if (!node) return tl::unexpected<Error>(std::move(node.error()));
  observer = *node;
  instruction = observer->advertise<std_msgs::msg::String>("instruction");
  goal = observer->advertise<GoalPredicates>("goal");
  // Latched topics keep one message for latecomers; we want to see every one.
  const ros::Qos every = ros::Qos::latched().keep_last(1000);
  status = observer->subscribe<InstructionStatus>("instruction_status", every,
                                                  [this](const InstructionStatus& message) {
                                                    if (events.on_status)
                                                      events.on_status(coordinator::from_message(message));
                                                  });
  action_status = observer->subscribe<ActionStatus>("action_status", ros::Qos::standard(),
                                                    [this](const ActionStatus& message) {
                                                      if (events.on_stage)
                                                        events.on_stage(message.stage(), message.progress());
                                                    });
  world_state = observer->subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", every, [this](const goalnet_msgs::msg::WorldState& message) {
        const auto world = messages::from_message(message);
        if (!world) return;
        world_seen = true;
        if (events.on_world) events.on_world(*world);
      });
  return {};
}

LockstepLoop::LockstepLoop(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LockstepLoop::~LockstepLoop() = default;

Expected<std::unique_ptr<LockstepLoop>> LockstepLoop::create(const LoopOptions& options, LoopEvents events) {
  auto impl = std::make_unique<Impl>();
  ros::ContextOptions context_options;
  context_options.process_only = options.process_only;
  if (options.arguments.enclave) context_options.enclave = *options.arguments.enclave;
  auto context = ros::Context::create(context_options);
  if (!context) return tl::unexpected<Error>(std::move(context.error()));
  impl->context = std::move(*context);
  impl->events = std::move(events);
  if (auto added = impl->add_recorder(options); !added)
    return tl::unexpected<Error>(std::move(added.error()));
  if (auto added = impl->add_components(options); !added)
    return tl::unexpected<Error>(std::move(added.error()));
  if (auto added = impl->add_observer(options); !added)
    return tl::unexpected<Error>(std::move(added.error()));
  std::vector<ros::Node*> nodes;
  for (const auto& node : impl->nodes) nodes.push_back(node.get());
  if (auto known = check_given_parameters(options.arguments, nodes, true); !known)
    return tl::unexpected<Error>(std::move(known.error()));
  // By now there was time to hear of others, and nothing has been said that could disturb them.
  if (auto alone = impl->alone(); !alone) return tl::unexpected<Error>(std::move(alone.error()));
  return std::unique_ptr<LockstepLoop>(new LockstepLoop(std::move(impl)));
}

Expected<void> LockstepLoop::settle(double at_least, double limit) {
  const double start = sim_time();
  while (sim_time() - start < at_least || !impl_->world_seen) {
    if (auto go_on = impl_->asked(); !go_on) return go_on;
    if (sim_time() - start > limit) {
      return fail(Outcome::kWorldStale,
                  "the world model has said nothing for " + std::to_string(limit) + " s");
    }
    step();
  }
  return impl_->alone();
}

void LockstepLoop::instruct(const std::string& instruction) {
  std_msgs::msg::String message;
  message.data(instruction);
  impl_->instruction->publish(message);
}

void LockstepLoop::pursue(const Goal& goal) {
  GoalPredicates message;
  message.header().stamp(impl_->observer->now());
  messages::fill(message, goal);
  impl_->goal->publish(message);
}

void LockstepLoop::cancel(const std::string& reason) { impl_->coordinator->cancel(reason); }

void LockstepLoop::step() {
  while (impl_->loop.run_pending()) {
  }
  impl_->simulator->tick();
  // Whoever deactivated it by ros2 lifecycle may activate it again; until then we wait instead of spinning.
  if (!impl_->simulator->active()) impl_->loop.run_for(std::chrono::milliseconds(10));
}

sim::World& LockstepLoop::world() { return impl_->simulator->world(); }

ros::ManagedComponent& LockstepLoop::component(std::string_view name) {
  const auto found = impl_->components.find(name);
  if (found == impl_->components.end()) throw std::out_of_range("no component " + std::string(name));
  return *found->second;
}

Expected<void> LockstepLoop::picture(const std::string& path) const {
  const sim::World& world = impl_->simulator->world();
  return sim::write_png(sim::render(world, over_the_shoulder(world)), path);
}

Expected<void> LockstepLoop::finish_recording() {
  if (impl_->recorder == nullptr) return {};
  const double end = sim_time() + kEpilogue;
  while (sim_time() < end) step();
  while (impl_->loop.run_pending()) {
  }
  return impl_->recorder->close();
}

double LockstepLoop::sim_time() const { return impl_->observer->now().seconds(); }

void LockstepLoop::interrupt() {
  for (const auto& [name, component] : impl_->components) component->interrupt();
}

}  // namespace goalnet::tools
