// The simulator on DDS: publishes what sensors and drivers of a robot would, takes joint commands.
//
// publishes  /clock, joint_states (robot and fixtures), object_poses, object_states (latched), /tf,
// /tf_static (latched),
//            robot_description (latched)
// subscribes joint_commands (only when not in lockstep)
// parameters scene, robot, seed, lockstep, real_time_factor, physics_step, pose_rate, tf_rate (see README.md)
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "components/core/outcome.h"
#include "components/ros/node.h"
#include "executor/joint_sample.h"
#include "sim/world.h"

namespace goalnet::sim {

class SimulatorNode : public ros::Component {
 public:
  // Called every millisecond of simulated time with what the joints measure; leaves its command in `command`,
  // which still holds the previous one.
  using Controller = std::function<void(std::int64_t time_ns, const executor::JointSample& measured,
                                        executor::JointSample& command)>;

  static constexpr std::int64_t kTickNs = 10'000'000;
  static constexpr std::int64_t kCycleNs = 1'000'000;

  // Reads its parameters through the node. Fails with kInvalidRequest on bad parameters, scenes and robots.
  static Expected<std::unique_ptr<SimulatorNode>> create(ros::Node& node);
  ~SimulatorNode() override;

  // Lockstep: who commands the joints. Without one the robot holds still.
  void set_controller(Controller controller);
  // Advances by 10 ms and publishes. In lockstep the caller calls this; else a wall timer does.
  void tick();
  std::int64_t time_ns() const;

  // For faults, pictures and tests. Same thread as tick().
  World& world();

 private:
  struct Internals;
  explicit SimulatorNode(std::unique_ptr<Internals> internals);
  std::unique_ptr<Internals> internals_;
};

}  // namespace goalnet::sim
