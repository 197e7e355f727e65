// Carries out one symbolic action after the other: plans phase by phase, hands trajectories over, looks at
// what came of them, tries another way when something failed. A state machine without threads: whoever owns
// it calls update() with every new perception and every new word from the executor.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/manipulation/skill.h"
#include "components/manipulation/workbench.h"
#include "executor/executor_status.h"

namespace goalnet::manipulation {

class ActionRunner {
 public:
  // The workbench must outlive the runner; both belong to one thread.
  explicit ActionRunner(Workbench& bench);
  ~ActionRunner();

  // Begins an action. Fails with kBusy while one runs, and as make_skill does.
  Expected<void> start(const Action& action);
  // Ends the action as kCancelled once the robot stands. Harmless when nothing runs.
  void cancel();

  // What failed since then is remembered, so that actions that are asked for again are tried in other ways.
  void begin_instruction();
  void begin_step() { bench_.tried().begin_step(); }

  struct Orders {
    std::optional<JointTrajectory> send;  // to the executor; stamp_ns is set and unique
    bool stop = false;                    // tell the executor to stop smoothly
  };
  // Advances as far as it can. Planning happens in here and may take tens of milliseconds of wall time.
  Orders update(const WorldView& world, const executor::ExecutorStatus& status);

  bool running() const { return state_ != State::kIdle && state_ != State::kFinished; }
  bool finished() const { return state_ == State::kFinished; }
  // Valid when finished: kDone or why not.
  const Error& result() const { return result_; }

  const std::string& stage() const { return stage_; }
  double progress() const;                                   // 0..1
  double planning_time_s() const { return planning_time_; }  // wall clock, for reports only: decides nothing
  int attempts() const { return attempt_; }

 private:
  enum class State { kIdle, kPlanning, kNextPhase, kMoving, kSettling, kStopping, kFinished };
  bool fails_again();
  bool waits_for_standstill(const executor::ExecutorStatus& status, Orders& orders);
  void plan_attempt();
  void next_phase(Orders& orders);
  void watch_motion(const executor::ExecutorStatus& status);
  void note_hindered(bool is);
  void settle();
  void attempt_failed(const Error& why);
  void finish(Outcome outcome, const std::string& message);

  Workbench& bench_;
  std::unique_ptr<Skill> skill_;
  Action action_;
  State state_ = State::kIdle;
  Phases phases_;
  std::size_t phase_ = 0;
  int attempt_ = 0;
  std::string stage_;
  JointTrajectory sent_;
  std::int64_t last_stamp_ = 0;
  std::int64_t sent_at_ns_ = 0;
  std::int64_t sent_again_at_ns_ = 0;
  std::int64_t settled_at_ns_ = 0;
  std::int64_t waiting_since_ns_ = -1;  // for the executor to come to rest; -1: not
  std::int64_t now_ns_ = 0;
  bool cancelled_ = false;
  double planning_time_ = 0;
  Error result_;
  std::string first_failure_;
  bool moved_ = false;  // a motion was sent since the action began
  // An action that failed before anything moved, and the world it did so in: it would do so again.
  struct Vain {
    Action action;
    WorldView world;
    Error error;
  };
  std::optional<Vain> vain_;
  std::map<Action, std::vector<DeadEnd>> dead_ends_;  // of actions that failed
};

}  // namespace goalnet::manipulation
