// The simulator on DDS: publishes what sensors and drivers of a robot would, takes joint commands.
//
// publishes  clock (relative: two robots on one network have a time each), joint_states (robot and fixtures),
// object_poses, object_states (latched), /tf, /tf_static (latched),
//            robot_description (latched)
// subscribes joint_commands (only when not in lockstep)
// Deactivated, simulated time stands still and nothing is published; activated again, it goes on from there.
// Cleaned up and configured again, the room is as at the start.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "components/core/outcome.h"
#include "components/ros/managed_component.h"
#include "executor/joint_sample.h"
#include "sim/world.h"

namespace goalnet::sim {

// What goes wrong with the sensors; each stays until lifted.
struct SensorFaults {
  bool poses_lost = false;   // object_poses falls silent
  bool joints_lost = false;  // so does joint_states, and the controller measures nothing (NaN)
  double poses_late = 0.0;   // [s] object_poses comes so much later than its stamp
};

// Belongs to the thread of the node's event loop.
class SimulatorNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string scene = "kitchen";
    std::string robot = "default";
    std::uint64_t seed = 0;
    bool lockstep = false;
    double real_time_factor = 1.0;
    double physics_step = 0.002;              // [s]
    double pose_rate = 50.0, tf_rate = 20.0;  // [Hz]
  };
  static void describe(ros::ParameterSet& set, Params& params);

  // Called every millisecond of simulated time with what the joints measure; leaves its command in `command`,
  // which still holds the previous one.
  using Controller = std::function<void(std::int64_t time_ns, const executor::JointSample& measured,
                                        executor::JointSample& command)>;

  static constexpr std::int64_t kTickNs = 10'000'000;
  static constexpr std::int64_t kCycleNs = 1'000'000;

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest on bad
  // parameters, scenes and robots.
  static Expected<std::unique_ptr<SimulatorNode>> create(ros::Node& node);
  ~SimulatorNode() override;

  // Lockstep: who commands the joints. Without one the robot holds still.
  void set_controller(Controller controller);
  // Advances by 10 ms and publishes. In lockstep the caller calls this; else a wall timer does. Nothing
  // happens while not active.
  void tick();
  std::int64_t time_ns() const;  // 0 while unconfigured

  // For faults, pictures and tests. Same thread as tick(). Throws std::logic_error while unconfigured.
  World& world();
  SensorFaults& sensor_faults() { return sensor_faults_; }

 private:
  struct Internals;
  explicit SimulatorNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;

  Params params_;
  Controller controller_;
  SensorFaults sensor_faults_;
  std::unique_ptr<Internals> internals_;  // from configure on
};

}  // namespace goalnet::sim
