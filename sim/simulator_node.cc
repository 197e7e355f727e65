#include "sim/simulator_node.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "rosgraph_msgs/msg/Clock.h"
#include "sim/world_messages.h"
#include "std_msgs/msg/String.h"

namespace goalnet::sim {
namespace {

// A command older than this is no longer extrapolated with its velocity [s].
constexpr double kCommandHorizon = 0.02;

struct Parameters {
  std::string scene, robot;
  WorldOptions world;
  bool lockstep = false;
  double real_time_factor = 1.0;
  int poses_every = 2, transforms_every = 5;  // ticks
};

Expected<Parameters> read_parameters(ros::Node& node) {
  Parameters p;
  const auto ranged = [](const char* text, double from, double to) {
    return ros::ParameterDescriptor{
        .description = text, .read_only = true, .range = ros::ParameterRange{from, to, 0}};
  };
  const ros::ParameterDescriptor scene_text{.description = "name in config/scenes or path of a scene file",
                                            .read_only = true};
  const ros::ParameterDescriptor robot_text{.description = "name in config/robots or path; empty: default",
                                            .read_only = true};
  const ros::ParameterDescriptor lockstep_text{
      .description = "the caller ticks and controls; no wall clock, no joint_commands", .read_only = true};
  auto scene = node.declare_parameter<std::string>("scene", "kitchen", scene_text);
  auto robot = node.declare_parameter<std::string>("robot", "", robot_text);
  auto seed = node.declare_parameter<std::int64_t>(
      "seed", 0, ranged("varies where objects stand; 0: as the scene says", 0, 1e15));
  auto lockstep = node.declare_parameter<bool>("lockstep", false, lockstep_text);
  auto factor = node.declare_parameter<double>(
      "real_time_factor", 1.0, ranged("simulated seconds per real second, if not in lockstep", 0.01, 100));
  auto step = node.declare_parameter<double>(
      "physics_step", 0.002, ranged("[s] one step of the physics; divides 10 ms", 0.0005, 0.01));
  auto poses = node.declare_parameter<double>("pose_rate", 50.0, ranged("[Hz] of object_poses", 1, 100));
  auto transforms = node.declare_parameter<double>("tf_rate", 20.0, ranged("[Hz] of /tf", 1, 100));
  if (!scene) return tl::unexpected(scene.error());
  if (!robot) return tl::unexpected(robot.error());
  if (!seed) return tl::unexpected(seed.error());
  if (!lockstep) return tl::unexpected(lockstep.error());
  if (!factor) return tl::unexpected(factor.error());
  if (!step) return tl::unexpected(step.error());
  if (!poses) return tl::unexpected(poses.error());
  if (!transforms) return tl::unexpected(transforms.error());
  p.scene = *scene;
  p.robot = robot->empty() ? "default" : *robot;
  p.world.seed = static_cast<std::uint64_t>(*seed);
  // The step must divide the tick, or simulated time and published time would drift apart.
  const double steps = std::round(0.01 / *step);
  if (std::abs(steps * *step - 0.01) > 1e-9) {
    return fail(Outcome::kInvalidRequest,
                "parameter physics_step must divide 0.01 s, for example 0.001, 0.002 or 0.005");
  }
  p.world.physics_step = *step;
  p.lockstep = *lockstep;
  p.real_time_factor = *factor;
  p.poses_every = static_cast<int>(std::lround(100.0 / *poses));
  p.transforms_every = static_cast<int>(std::lround(100.0 / *transforms));
  return p;
}

}  // namespace

struct SimulatorNode::Internals {
  Internals(ros::Node& the_node, Parameters the_parameters, std::unique_ptr<World> the_world)
      : node(the_node), parameters(std::move(the_parameters)), world(std::move(the_world)) {
    joints = std::min(world->robot_joint_count(), executor::kMaxJoints);
    for (std::size_t i = 0; i < joints; ++i) {
      command.position[i] = world->robot_joint(i).position;
      index[world->robot().joints[i].name] = i;
    }
    clock = node.advertise<rosgraph_msgs::msg::Clock>("/clock", ros::Qos::clock());
    joint_states = node.advertise<sensor_msgs::msg::JointState>("joint_states");
    object_poses = node.advertise<goalnet_msgs::msg::ObjectPoses>("object_poses");
    object_states = node.advertise<goalnet_msgs::msg::ObjectStates>("object_states", ros::Qos::latched());
    transforms = node.advertise<tf2_msgs::msg::TFMessage>("/tf", ros::Qos::tf());
    static_transforms = node.advertise<tf2_msgs::msg::TFMessage>("/tf_static", ros::Qos::tf_static());
    description = node.advertise<std_msgs::msg::String>("robot_description", ros::Qos::latched());
    std_msgs::msg::String xml;
    xml.data(world->robot().urdf_xml);
    description->publish(xml);
    tf2_msgs::msg::TFMessage fixed;
    fill_transforms(*world, stamp(), false, fixed);
    static_transforms->publish(fixed);
  }

  builtin_interfaces::msg::Time stamp() const { return ros::Time(time_ns).to_msg(); }

  void publish_states() {
    goalnet_msgs::msg::ObjectStates message;
    fill_object_states(world->facts(), stamp(), message);
    object_states->publish(message);
    published_facts = world->facts();
  }

  void measure(executor::JointSample& sample) const {
    for (std::size_t i = 0; i < joints; ++i) {
      const JointReading reading = world->robot_joint(i);
      sample.position[i] = reading.position;
      sample.velocity[i] = reading.velocity;
    }
  }

  // One physics step. The controller runs each millisecond before it; its last command, one cycle ahead, is
  // the target.
  void step(std::int64_t start_ns, std::int64_t step_ns) {
    const double step_s = static_cast<double>(step_ns) * 1e-9;
    if (controller) {
      executor::JointSample measured;
      measure(measured);
      std::int64_t cycle =
          (start_ns + kCycleNs - 1) / kCycleNs * kCycleNs;  // first cycle not before this step
      double ahead = -1.0;
      for (; cycle < start_ns + step_ns; cycle += kCycleNs) {
        controller(cycle, measured, command);
        ahead = static_cast<double>(start_ns + step_ns - cycle) * 1e-9;
        commanded_ns = cycle;
      }
      if (ahead < 0.0) ahead = static_cast<double>(start_ns + step_ns - commanded_ns) * 1e-9;
      apply(ahead);
    } else if (!parameters.lockstep) {
      const double age = static_cast<double>(start_ns - commanded_ns) * 1e-9 + step_s;
      apply(age <= kCommandHorizon ? age : -1.0);
    }
    world->step();
  }

  // ahead: [s] from the command's moment to the end of the step; negative: the command is stale, hold its
  // position.
  void apply(double ahead) {
    for (std::size_t i = 0; i < joints; ++i) {
      const double velocity = ahead < 0.0 ? 0.0 : command.velocity[i];
      world->command(i, command.position[i] + velocity * std::max(ahead, 0.0), velocity);
    }
  }

  void take_command(const sensor_msgs::msg::JointState& message) {
    const auto& names = message.name();
    if (message.position().size() != names.size() ||
        (!message.velocity().empty() && message.velocity().size() != names.size())) {
      if (!complained)
        node.log().warn("joint_commands ignored: name, position and velocity differ in length");
      complained = true;
      return;
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto found = index.find(names[k]);
      if (found == index.end() || !std::isfinite(message.position()[k])) continue;
      const double velocity = message.velocity().empty() ? 0.0 : message.velocity()[k];
      command.position[found->second] = message.position()[k];
      command.velocity[found->second] = std::isfinite(velocity) ? velocity : 0.0;
    }
    commanded_ns = time_ns;
  }

  void tick() {
    const std::int64_t step_ns = std::llround(parameters.world.physics_step * 1e9);
    for (std::int64_t done = 0; done < kTickNs; done += step_ns) step(time_ns + done, step_ns);
    time_ns += kTickNs;
    ++ticks;
    rosgraph_msgs::msg::Clock now;
    now.clock(stamp());
    clock->publish(now);
    fill_joint_states(*world, stamp(), joint_message);
    joint_states->publish(joint_message);
    if (ticks % parameters.poses_every == 0 || ticks == 1) {
      fill_object_poses(*world, stamp(), pose_message);
      object_poses->publish(pose_message);
    }
    if (ticks % parameters.transforms_every == 0 || ticks == 1) {
      fill_transforms(*world, stamp(), true, transform_message);
      transforms->publish(transform_message);
    }
    // First with the first tick: what is published before a reader exists reaches it some time later, from a
    // DDS thread, and in lockstep nothing may depend on when.
    if (ticks == 1 || !(world->facts() == published_facts)) publish_states();
  }

  ros::Node& node;
  Parameters parameters;
  std::unique_ptr<World> world;
  Controller controller;
  std::size_t joints = 0;
  std::map<std::string, std::size_t> index;
  executor::JointSample command;
  std::int64_t commanded_ns = 0;
  bool complained = false;
  std::int64_t time_ns = 0;
  long ticks = 0;
  FactSet published_facts;
  sensor_msgs::msg::JointState joint_message;
  goalnet_msgs::msg::ObjectPoses pose_message;
  tf2_msgs::msg::TFMessage transform_message;
  std::shared_ptr<ros::Publisher<rosgraph_msgs::msg::Clock>> clock;
  std::shared_ptr<ros::Publisher<sensor_msgs::msg::JointState>> joint_states;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ObjectPoses>> object_poses;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ObjectStates>> object_states;
  std::shared_ptr<ros::Publisher<tf2_msgs::msg::TFMessage>> transforms, static_transforms;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> description;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> commands;
  std::shared_ptr<ros::Timer> timer;
};

SimulatorNode::SimulatorNode(std::unique_ptr<Internals> internals) : internals_(std::move(internals)) {}
SimulatorNode::~SimulatorNode() = default;

Expected<std::unique_ptr<SimulatorNode>> SimulatorNode::create(ros::Node& node) {
  auto parameters = read_parameters(node);
  if (!parameters) return tl::unexpected(parameters.error());
  auto scene = scene::load_scene(parameters->scene);
  if (!scene) return tl::unexpected(scene.error());
  auto robot = robot::load_robot(parameters->robot);
  if (!robot) return tl::unexpected(robot.error());
  auto world = World::create(*scene, *robot, parameters->world);
  if (!world) return tl::unexpected(world.error());
  auto internals = std::make_unique<Internals>(node, *parameters, std::move(*world));
  Internals* self = internals.get();
  if (!self->parameters.lockstep) {
    self->commands = node.subscribe<sensor_msgs::msg::JointState>(
        "joint_commands", ros::Qos::standard().keep_last(1),
        [self](const sensor_msgs::msg::JointState& m) { self->take_command(m); });
    const auto period = std::chrono::nanoseconds(
        std::llround(static_cast<double>(kTickNs) / self->parameters.real_time_factor));
    self->timer = node.create_timer(period, [self] { self->tick(); });
  }
  return std::unique_ptr<SimulatorNode>(new SimulatorNode(std::move(internals)));
}

void SimulatorNode::set_controller(Controller controller) { internals_->controller = std::move(controller); }
void SimulatorNode::tick() { internals_->tick(); }
std::int64_t SimulatorNode::time_ns() const { return internals_->time_ns; }
World& SimulatorNode::world() { return *internals_->world; }

}  // namespace goalnet::sim
