// The whole loop in one process, for tests that break something in it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "sim/world.h"
#include "tools/goalnet/lockstep_loop.h"

namespace goalnet::tools {

class LoopFixture : public testing::Test {
 protected:
  void SetUp() override {
    LoopOptions options;
    options.process_only = true;
    options.instruction_timeout = 300.0;
    LoopEvents events;
    events.on_status = [this](const coordinator::Report& report) { last_ = report; };
    events.on_world = [this](const WorldState& world) { world_ = world; };
    auto loop = LockstepLoop::create(options, std::move(events));
    ASSERT_TRUE(loop) << loop.error().message;
    loop_ = std::move(*loop);
    ASSERT_TRUE(loop_->settle());
  }

  // Until `condition`, or the end of the run; false if the run ended first.
  bool run_until(const std::function<bool()>& condition) {
    while (!last_.finished) {
      if (condition()) return true;
      loop_->step();
    }
    return false;
  }
  bool run_until_action(const std::string& action) {
    return run_until([&] { return to_string(last_.current_action) == action; });
  }
  void run_to_the_end() {
    static_cast<void>(run_until([] { return false; }));
    RecordProperty("message", last_.message);
    RecordProperty("sim_time", std::to_string(loop_->sim_time()));
  }
  void go_on(double seconds) {
    const double until = loop_->sim_time() + seconds;
    while (loop_->sim_time() < until) loop_->step();
  }

  std::size_t object(const std::string& name) {
    const scene::Scene& scene = loop_->world().scene();
    return static_cast<std::size_t>(scene.find_object(name) - scene.objects.data());
  }
  bool holds(const std::string& fact) { return world_.facts.contains(parse_predicate(fact).value()); }
  // Of the fastest joint [rad/s or m/s].
  double speed() {
    double fastest = 0.0;
    for (std::size_t j = 0; j < loop_->world().robot_joint_count(); ++j)
      fastest = std::max(fastest, std::abs(loop_->world().robot_joint(j).velocity));
    return fastest;
  }
  // Nothing moves any more once a run has ended.
  void expect_at_rest(double most = 0.02) {
    go_on(2.0);
    EXPECT_LT(speed(), most);
  }

  double joint_position(const std::string& name) {
    const int joint = loop_->world().robot().index_of(name);
    return loop_->world().robot_joint(static_cast<std::size_t>(joint)).position;
  }
  // No servo pushes hard: holding up its own weight takes less than half of what a joint of the arm can do.
  void expect_nothing_presses() {
    const auto& world = loop_->world();
    for (std::size_t j = 0; j < world.robot_joint_count(); ++j) {
      const auto& joint = world.robot().joints[j];
      if (joint.name.find("_arm_") == std::string::npos) continue;
      EXPECT_LT(std::abs(world.robot_joint(j).effort), 0.5 * joint.limits.effort) << joint.name;
    }
  }

  std::unique_ptr<LockstepLoop> loop_;
  coordinator::Report last_;
  WorldState world_;
};

inline const Goal kMugInSink{{{"On", "Mug_1", "Sink"}}, {}, 1.0};

}  // namespace goalnet::tools
