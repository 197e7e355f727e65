#include "components/manipulation/testing/physics_harness.h"

#include <algorithm>
#include <cmath>

#include "components/setting/setting.h"
#include "executor/joint_limits.h"

namespace goalnet::manipulation {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

executor::ExecutorParams executor_params(const robot::RobotModel& robot) {
  executor::ExecutorParams params;
  params.joints = executor::joint_limits(robot, executor::Tolerances());
  params.settle_time = 1.0;
  return params;
}

}  // namespace

Expected<std::unique_ptr<PhysicsHarness>> PhysicsHarness::create(const std::string& scene_name,
                                                                 const std::string& robot_name,
                                                                 std::uint64_t seed) {
  auto setting = load_setting(scene_name, robot_name);
  if (!setting) return tl::unexpected<Error>(setting.error());
  std::unique_ptr<PhysicsHarness> out(new PhysicsHarness);
  sim::WorldOptions options;
  options.seed = seed;
  auto world = sim::World::create(setting->scene, setting->robot, options);
  if (!world) return tl::unexpected<Error>(world.error());
  out->world_ = std::move(*world);
  auto runner = executor::TrajectoryExecutor::create(executor_params(setting->robot));
  if (!runner) return tl::unexpected<Error>(runner.error());
  out->executor_ = std::move(*runner);
  auto bench = Workbench::create(std::move(setting->robot), std::move(setting->scene), ManipulationParams());
  if (!bench) return tl::unexpected<Error>(bench.error());
  out->bench_ = std::move(*bench);
  out->runner_ = std::make_unique<ActionRunner>(*out->bench_);
  out->world_model_ = std::make_unique<world_model::WorldModel>(out->world_->scene(), out->world_->robot());
  out->steps_per_tick_ = std::max(1, static_cast<int>(std::lround(0.01 / options.physics_step)));
  out->wait(0.5);  // things settle on what they stand on
  return out;
}

void PhysicsHarness::tick() {
  const int cycles_per_step = std::max(1, 10 / steps_per_tick_);
  executor::JointSample measured, command;
  for (int step = 0; step < steps_per_tick_; ++step) {
    for (std::size_t j = 0; j < world_->robot_joint_count(); ++j) {
      const auto reading = world_->robot_joint(j);
      measured.position[j] = reading.position;
      measured.velocity[j] = reading.velocity;
    }
    for (int cycle = 0; cycle < cycles_per_step; ++cycle) {
      time_ns_ += kMillisecond;
      executor_->cycle(time_ns_, measured, command);
    }
    for (std::size_t j = 0; j < world_->robot_joint_count(); ++j) {
      world_->command(j, command.position[j], command.velocity[j]);
    }
    world_->step();
  }
  if (time_ns_ / kMillisecond % 50 == 0) observe_facts();
}

void PhysicsHarness::observe_facts() {
  world_model::ObservedPoses poses{time_ns_, {}};
  const auto& objects = world_->scene().objects;
  for (std::size_t i = 0; i < objects.size(); ++i)
    poses.objects.push_back({objects[i].name, world_->object_pose(i)});
  world_model::ObservedJoints joints{time_ns_, {}, {}};
  for (std::size_t j = 0; j < world_->robot_joint_count(); ++j) {
    joints.names.push_back(world_->robot().joints[j].name);
    joints.positions.push_back(world_->robot_joint(j).position);
  }
  for (std::size_t j = 0; j < world_->fixture_joint_count(); ++j) {
    joints.names.push_back(world_->fixture_joint_name(j));
    joints.positions.push_back(world_->fixture_joint(j).position);
  }
  std::vector<world_model::ObservedState> states;
  for (const auto& fact : world_->facts()) {
    if (states.empty() || states.back().name != fact.subject) states.push_back({fact.subject, {}});
    states.back().values.push_back(fact.object);
  }
  world_model_->observe(joints);
  world_model_->observe(states);
  world_model_->observe(poses);
  world_model_->update();
}

void PhysicsHarness::wait(double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.01)); ++i) tick();
}

WorldView PhysicsHarness::view() const {
  WorldView view;
  view.time_ns = time_ns_;
  for (std::size_t j = 0; j < world_->robot_joint_count(); ++j)
    view.robot.push_back(world_->robot_joint(j).position);
  for (std::size_t j = 0; j < world_->fixture_joint_count(); ++j) {
    view.joints[world_->fixture_joint_name(j)] = world_->fixture_joint(j).position;
  }
  const auto& objects = world_->scene().objects;
  for (std::size_t i = 0; i < objects.size(); ++i) view.objects[objects[i].name] = world_->object_pose(i);
  view.facts = facts();
  return view;
}

TrialResult PhysicsHarness::run(const Action& action, double limit) {
  TrialResult out;
  const std::int64_t start = time_ns_;
  if (auto started = runner_->start(action); !started) {
    out.result = started.error();
    return out;
  }
  std::string stage;
  while (!runner_->finished()) {
    const double elapsed = static_cast<double>(time_ns_ - start) * 1e-9;
    if (elapsed > limit || (cancel_when && cancel_when(elapsed))) runner_->cancel();
    const auto orders = runner_->update(view(), executor_->status());
    if (runner_->stage() != stage && on_stage)
      on_stage(static_cast<double>(time_ns_) * 1e-9, runner_->stage());
    stage = runner_->stage();
    if (orders.stop) executor_->stop();
    if (orders.send) {
      if (auto accepted = executor_->submit(*orders.send); !accepted) {
        runner_->cancel();
        out.result = accepted.error();
        return out;
      }
    }
    if (runner_->finished()) break;
    tick();
  }
  out.result = runner_->result();
  out.sim_time = static_cast<double>(time_ns_ - start) * 1e-9;
  out.planning_time = runner_->planning_time_s();
  out.attempts = runner_->attempts();
  return out;
}

}  // namespace goalnet::manipulation
