// Manipulation, executor and simulated physics in one loop without DDS: for tests, benchmarks and
// goalnet_skill_trial.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "components/manipulation/action_runner.h"
#include "components/manipulation/workbench.h"
#include "components/world_model/world_model.h"
#include "executor/trajectory_executor.h"
#include "sim/world.h"

namespace goalnet::manipulation {

struct TrialResult {
  Error result;              // kDone or why not
  double sim_time = 0;       // [s] simulated
  double planning_time = 0;  // [s] wall clock
  int attempts = 0;          // ways that failed before
};

// One object, one thread. The same seed and actions give the same result.
class PhysicsHarness {
 public:
  static Expected<std::unique_ptr<PhysicsHarness>> create(const std::string& scene, const std::string& robot,
                                                          std::uint64_t seed);

  // Runs one action to its end, at most `limit` [s] of simulated time.
  TrialResult run(const Action& action, double limit = 60.0);
  // Lets the world go on without new motion.
  void wait(double seconds);

  // Told about every new stage, with the simulated time.
  std::function<void(double, const std::string&)> on_stage;
  // Asked every 10 ms; true cancels the action.
  std::function<bool(double)> cancel_when;

  sim::World& world() { return *world_; }
  Workbench& bench() { return *bench_; }
  WorldView view() const;
  // What the world model makes of it, 20 times a second.
  const FactSet& facts() const { return world_model_->world().facts; }
  executor::ExecutorStatus executor_status() { return executor_->status(); }

 private:
  PhysicsHarness() = default;
  void tick();  // 10 ms
  void observe_facts();

  std::unique_ptr<sim::World> world_;
  std::unique_ptr<executor::TrajectoryExecutor> executor_;
  std::unique_ptr<Workbench> bench_;
  std::unique_ptr<ActionRunner> runner_;
  std::unique_ptr<world_model::WorldModel> world_model_;
  std::int64_t time_ns_ = 0;
  int steps_per_tick_ = 5;
};

}  // namespace goalnet::manipulation
