#include "tools/bench/physics.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "sim/world.h"

namespace goalnet::tools {
namespace {

using SteadyClock = std::chrono::steady_clock;

double micros_since(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::micro>(SteadyClock::now() - start).count();
}

// Sinusoids within the limits of speed and acceleration, for all joints at once.
class Motion {
 public:
  explicit Motion(const sim::World& world) : world_(world) {
    for (std::size_t i = 0; i < world.robot_joint_count(); ++i) start_.push_back(world.robot_joint(i).position);
  }
  double position(std::size_t joint, double t) const { return start_[joint] + size(joint) * (1.0 - std::cos(kRate * t)); }
  double velocity(std::size_t joint, double t) const { return size(joint) * kRate * std::sin(kRate * t); }

 private:
  static constexpr double kRate = 2.0;  // [rad/s]
  double size(std::size_t joint) const {
    const auto& limits = world_.robot().joints[joint].limits;
    const double range = std::isfinite(limits.lower) ? 0.2 * (limits.upper - limits.lower) : 1.0;
    const double size = 0.5 * std::min({range, 0.4 * limits.acceleration / (kRate * kRate), 0.4 * limits.velocity / kRate, 0.5});
    return start_[joint] + 2.0 * size > limits.upper ? -size : size;
  }
  const sim::World& world_;
  std::vector<double> start_;
};

}  // namespace

nlohmann::json bench_physics(const BenchOptions& options) {
  const auto load_start = SteadyClock::now();
  auto scene = scene::load_scene("kitchen");
  if (!scene) throw std::runtime_error(scene.error().message);
  const double load_us = micros_since(load_start);
  auto robot = robot::load_robot("default");
  if (!robot) throw std::runtime_error(robot.error().message);
  sim::WorldOptions world_options;
  world_options.seed = options.seed;
  auto created = sim::World::create(*scene, *robot, world_options);
  if (!created) throw std::runtime_error(created.error().message);
  sim::World& world = **created;
  const int steps = options.quick ? 500 : 5000;
  const double dt = world_options.physics_step;

  const auto time_steps = [&](const std::function<void()>& before) {
    std::vector<double> cost;
    for (int i = 0; i < steps; ++i) {
      before();
      const auto start = SteadyClock::now();
      world.step();
      cost.push_back(micros_since(start));
    }
    return cost;
  };
  for (int i = 0; i < 500; ++i) world.step();  // until everything sleeps
  const std::vector<double> idle = time_steps([] {});
  const Motion motion(world);
  const double began = world.time();
  double largest_error = 0.0;
  const std::vector<double> moving = time_steps([&] {
    const double now = world.time() - began;
    for (std::size_t i = 0; i < world.robot_joint_count(); ++i) {
      if (now > 0.0) largest_error = std::max(largest_error, std::abs(world.robot_joint(i).position - motion.position(i, now)));
      world.command(i, motion.position(i, now + dt), motion.velocity(i, now + dt));
    }
  });
  const auto factor = [&](const std::vector<double>& cost) {
    double total = 0.0;
    for (double value : cost) total += value;
    return static_cast<double>(cost.size()) * dt * 1e6 / total;
  };
  return {{"physics_step_s", dt},
          {"scene_load_us", load_us},
          {"step_idle", summary(idle, "us")},
          {"step_moving", summary(moving, "us")},
          {"real_time_factor_idle", factor(idle)},
          {"real_time_factor_moving", factor(moving)},
          {"largest_tracking_error", largest_error}};
}

}  // namespace goalnet::tools
