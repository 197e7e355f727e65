#include "sim/simulator_node.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <stdexcept>
#include <utility>

#include "components/setting/setting.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "sim/world_messages.h"
#include "std_msgs/msg/String.h"

namespace goalnet::sim {
namespace {

// A command older than this is no longer extrapolated with its velocity [s].
constexpr double kCommandHorizon = 0.02;

int every_so_many_ticks(double rate_hz) { return static_cast<int>(std::lround(100.0 / rate_hz)); }

// The step must divide the tick, or simulated time and published time would drift apart.
Expected<void> check_step(const ros::ParameterValue& value) {
  const double step = std::get<double>(value), steps = std::round(0.01 / step);
  if (std::abs(steps * step - 0.01) <= 1e-9) return {};
  return fail(Outcome::kInvalidRequest, "it must divide 0.01 s, for example 0.001, 0.002 or 0.005");
}

}  // namespace

struct SimulatorNode::Internals {
  Internals(ros::Node& the_node, const Params& the_params, const Controller& the_controller,
            const SensorFaults& the_faults, std::unique_ptr<World> the_world)
      : node(the_node),
        params(the_params),
        controller(the_controller),
        faults(the_faults),
        step_ns(std::llround(the_params.physics_step * 1e9)),
        poses_every(every_so_many_ticks(the_params.pose_rate)),
        transforms_every(every_so_many_ticks(the_params.tf_rate)),
        world(std::move(the_world)) {
    joints = std::min(world->robot_joint_count(), executor::kMaxJoints);
    for (std::size_t i = 0; i < joints; ++i) {
      command.position[i] = world->robot_joint(i).position;
      index[world->robot().joints[i].name] = i;
    }
  }

  void open_topics() {
    clock = node.advertise<rosgraph_msgs::msg::Clock>("clock", ros::Qos::clock());
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
    first_tick = true;
    if (params.lockstep) return;
    commands = node.subscribe<sensor_msgs::msg::JointState>(
        "joint_commands", ros::Qos::standard().keep_last(1),
        [this](const sensor_msgs::msg::JointState& m) { take_command(m); });
    const auto period =
        std::chrono::nanoseconds(std::llround(static_cast<double>(kTickNs) / params.real_time_factor));
    timer = node.create_timer(period, [this] { tick(); });
  }

  void close_topics() {
    timer.reset();
    commands.reset();
    clock.reset();
    joint_states.reset();
    object_poses.reset();
    object_states.reset();
    transforms.reset();
    static_transforms.reset();
    description.reset();
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
      if (faults.joints_lost) sample.position[i] = std::nan("");
    }
  }

  void publish_poses() {
    fill_object_poses(*world, stamp(), pose_message);
    late_poses.emplace_back(time_ns, pose_message);
    const auto delay = static_cast<std::int64_t>(1e9 * faults.poses_late);
    while (!late_poses.empty() && late_poses.front().first <= time_ns - delay) {
      if (!faults.poses_lost) object_poses->publish(late_poses.front().second);
      late_poses.pop_front();
    }
  }

  // One physics step. The controller runs each millisecond before it; its last command, one cycle ahead, is
  // the target.
  void step(std::int64_t start_ns) {
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
    } else if (!params.lockstep) {
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
    for (std::int64_t done = 0; done < kTickNs; done += step_ns) step(time_ns + done);
    time_ns += kTickNs;
    ++ticks;
    const bool first = std::exchange(first_tick, false);
    rosgraph_msgs::msg::Clock now;
    now.clock(stamp());
    clock->publish(now);
    fill_joint_states(*world, stamp(), joint_message);
    if (!faults.joints_lost) joint_states->publish(joint_message);
    if (ticks % poses_every == 0 || first) publish_poses();
    if (ticks % transforms_every == 0 || first) {
      fill_transforms(*world, stamp(), true, transform_message);
      transforms->publish(transform_message);
    }
    // First with the first tick: what is published before a reader exists reaches it some time later, from a
    // DDS thread, and in lockstep nothing may depend on when.
    if (first || !(world->facts() == published_facts)) publish_states();
  }

  ros::Node& node;
  const Params& params;
  const Controller& controller;
  const SensorFaults& faults;
  const std::int64_t step_ns;
  const int poses_every, transforms_every;  // ticks
  std::unique_ptr<World> world;
  std::size_t joints = 0;
  std::map<std::string, std::size_t> index;
  executor::JointSample command;
  std::int64_t commanded_ns = 0;
  bool complained = false;
  std::int64_t time_ns = 0;
  long ticks = 0;
  bool first_tick = true;  // since activation
  FactSet published_facts;
  sensor_msgs::msg::JointState joint_message;
  goalnet_msgs::msg::ObjectPoses pose_message;
  std::deque<std::pair<std::int64_t, goalnet_msgs::msg::ObjectPoses>>
      late_poses;  // by when they were seen [ns]
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

void SimulatorNode::describe(ros::ParameterSet& set, Params& params) {
  set.text("scene", params.scene, "room that is simulated", "a name in config/scenes or a file");
  set.text("robot", params.robot, "robot that is simulated", "a name in config/robots or a file");
  set.whole("seed", params.seed, "varies where objects stand; 0: as the scene says", 0, 1e15);
  set.flag("lockstep", params.lockstep, "the caller ticks and controls; no wall clock, no joint_commands")
      .settable = ros::Settable::kAtStart;
  set.number("real_time_factor", params.real_time_factor,
             "simulated seconds per real second, if not in lockstep", 0.01, 100);
  set.number("physics_step", params.physics_step, "one step of the physics; must divide 0.01 s [s]", 0.0005,
             0.01)
      .check = check_step;
  set.number("pose_rate", params.pose_rate, "how often object_poses are published [Hz]", 1, 100);
  set.number("tf_rate", params.tf_rate, "how often /tf is published [Hz]", 1, 100);
}

Expected<std::unique_ptr<SimulatorNode>> SimulatorNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<SimulatorNode>(new SimulatorNode(node)));
}

SimulatorNode::SimulatorNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, params_); }
SimulatorNode::~SimulatorNode() = default;

Expected<void> SimulatorNode::on_configure() {
  auto setting = load_setting(params_.scene, params_.robot);
  if (!setting) return tl::unexpected<Error>(std::move(setting.error()));
  WorldOptions options;
  options.seed = params_.seed;
  options.physics_step = params_.physics_step;
  auto world = World::create(setting->scene, setting->robot, options);
  if (!world) return tl::unexpected<Error>(std::move(world.error()));
  internals_ = std::make_unique<Internals>(node_, params_, controller_, sensor_faults_, std::move(*world));
  return {};
}

Expected<void> SimulatorNode::on_activate() {
  internals_->open_topics();
  return {};
}

Expected<void> SimulatorNode::on_deactivate() {
  if (internals_) internals_->close_topics();
  return {};
}

Expected<void> SimulatorNode::on_cleanup() {
  internals_.reset();
  return {};
}

void SimulatorNode::set_controller(Controller controller) { controller_ = std::move(controller); }

void SimulatorNode::tick() {
  if (active()) internals_->tick();
}

std::int64_t SimulatorNode::time_ns() const { return internals_ ? internals_->time_ns : 0; }

World& SimulatorNode::world() {
  if (!internals_) throw std::logic_error("the simulator has no world before it is configured");
  return *internals_->world;
}

}  // namespace goalnet::sim
