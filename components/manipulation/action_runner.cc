#include "components/manipulation/action_runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace goalnet::manipulation {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;
// After a trajectory the executor settles for a second; after one that a joint did not follow it stops and
// gives way, which takes up to about five. Silence well beyond that is a fault.
constexpr std::int64_t kExecutorSlack = 8'000 * kMillisecond;
// A motion that the executor has not said a word about after this time is sent again: an executor that was
// just started may not have been found yet. It takes one of the same stamp only once.
constexpr std::int64_t kSendAgain = 500 * kMillisecond;
constexpr std::size_t kMostRemembered = 32;  // actions, and dead ends of each

// Whether nothing has moved but for the trembling of measurements.
bool alike(const WorldView& a, const WorldView& b) {
  constexpr double kStill = 0.002;  // [m, rad]
  const auto near = [](double x, double y) { return std::abs(x - y) < kStill; };
  return a.facts == b.facts && std::ranges::equal(a.robot, b.robot, near) &&
         std::ranges::equal(
             a.joints, b.joints,
             [&](const auto& x, const auto& y) { return x.first == y.first && near(x.second, y.second); }) &&
         std::ranges::equal(a.objects, b.objects, [](const auto& x, const auto& y) {
           return x.first == y.first && x.second.matrix().isApprox(y.second.matrix(), 0.1 * kStill);
         });
}

// Adds the wall time of a scope to a counter, for reports.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& total_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

ActionRunner::ActionRunner(Workbench& bench) : bench_(bench) {}
ActionRunner::~ActionRunner() = default;

Expected<void> ActionRunner::start(const Action& action) {
  if (running()) return fail(Outcome::kBusy, "still at '" + to_string(action_) + "'");
  auto skill = make_skill(bench_, action);
  if (!skill) return tl::unexpected<Error>(skill.error());
  skill_ = std::move(*skill);
  const auto known = dead_ends_.find(action);
  bench_.set_dead_ends(known == dead_ends_.end() ? std::vector<DeadEnd>() : known->second);
  action_ = action;
  bench_.tried().begin_action(to_string(action));
  moved_ = false;
  attempt_ = 0;
  planning_time_ = 0;
  cancelled_ = false;
  first_failure_.clear();
  phases_.clear();
  phase_ = 0;
  waiting_since_ns_ = -1;
  stage_ = "planning";
  state_ = State::kPlanning;
  return {};
}

void ActionRunner::begin_instruction() {
  bench_.tried().begin_instruction();
  dead_ends_.clear();
  vain_.reset();
}

void ActionRunner::cancel() {
  if (running()) cancelled_ = true;
}

double ActionRunner::progress() const {
  if (state_ == State::kFinished) return 1.0;
  if (phases_.empty()) return 0.0;
  return static_cast<double>(phase_) / static_cast<double>(phases_.size());
}

ActionRunner::Orders ActionRunner::update(const WorldView& world, const executor::ExecutorStatus& status) {
  Orders orders;
  if (!running()) return orders;
  now_ns_ = world.time_ns;
  if (cancelled_ && state_ != State::kStopping) {
    if (state_ == State::kMoving) {
      orders.stop = true;
      state_ = State::kStopping;
    } else {
      finish(Outcome::kCancelled, "'" + to_string(action_) + "' was cancelled");
      return orders;
    }
  }
  if (state_ == State::kStopping) {
    if (status.state == executor::ExecutorState::kIdle || status.state == executor::ExecutorState::kFault) {
      bench_.forget_command();
      finish(Outcome::kCancelled, "'" + to_string(action_) + "' was cancelled; the robot stands");
    }
    return orders;
  }
  if (state_ == State::kMoving) watch_motion(status);
  const bool unheard =
      status.trajectory_stamp_ns != sent_.stamp_ns && status.rejected_stamp_ns != sent_.stamp_ns;
  if (state_ == State::kMoving && unheard && now_ns_ - sent_again_at_ns_ > kSendAgain) {
    sent_again_at_ns_ = now_ns_;
    orders.send = sent_;
    return orders;
  }
  if (state_ == State::kSettling && now_ns_ >= settled_at_ns_) {
    bench_.observe(world);
    settle();
  }
  const bool plans = state_ == State::kPlanning || state_ == State::kNextPhase;
  if (plans && waits_for_standstill(status, orders)) return orders;
  // An attempt that fails in planning is followed by the next at once: the robot stands still meanwhile.
  while ((state_ == State::kPlanning || state_ == State::kNextPhase) && !orders.send) {
    if (bench_.stopped()) {
      finish(Outcome::kCancelled, "'" + to_string(action_) + "' was cancelled");
      return orders;
    }
    bench_.observe(world);
    if (state_ == State::kPlanning && attempt_ == 0 && !moved_ && fails_again()) return orders;
    if (state_ == State::kPlanning) {
      plan_attempt();
    } else {
      next_phase(orders);
    }
  }
  return orders;
}

// The same was tried in the same world, in vain, and before anything moved.
bool ActionRunner::fails_again() {
  if (!vain_ || vain_->action != action_ || !alike(vain_->world, bench_.world())) return false;
  finish(vain_->error.outcome, vain_->error.message);
  return true;
}

// The executor moves although no motion of ours is under way. It comes to rest after somebody pushed the
// standing robot; or it follows what another one sent, who was killed, and is told to stop.
bool ActionRunner::waits_for_standstill(const executor::ExecutorStatus& status, Orders& orders) {
  const bool follows = status.state == executor::ExecutorState::kExecuting;
  if (!follows && status.state != executor::ExecutorState::kStopping) {
    waiting_since_ns_ = -1;
    return false;
  }
  if (waiting_since_ns_ < 0) {
    waiting_since_ns_ = now_ns_;
    orders.stop = follows;
  }
  if (now_ns_ - waiting_since_ns_ > kExecutorSlack)
    finish(Outcome::kComponentLost, "the executor does not come to rest; is it running?");
  return true;
}

void ActionRunner::plan_attempt() {
  const Stopwatch watch(planning_time_);
  stage_ = "planning";
  auto phases = skill_->attempt(bench_, attempt_);
  const auto in_vain = [&] {
    return !phases && phases.error().outcome == Outcome::kMotionFailed && attempt_ == 0 && !moved_;
  };
  if (in_vain() && !bench_.dead_ends().empty()) {
    // What led nowhere when it was tried before may lead somewhere now.
    bench_.set_dead_ends({});
    skill_ = std::move(*make_skill(bench_, action_));
    phases = skill_->attempt(bench_, attempt_);
  }
  if (in_vain()) vain_ = Vain{action_, bench_.world(), phases.error()};
  if (!phases) {
    const auto& error = phases.error();
    return finish(error.outcome,
                  first_failure_.empty() ? error.message : first_failure_ + "; then: " + error.message);
  }
  phases_ = std::move(*phases);
  phase_ = 0;
  state_ = State::kNextPhase;
}

void ActionRunner::next_phase(Orders& orders) {
  if (phase_ >= phases_.size()) {
    if (!skill_->unfinished()) return finish(Outcome::kDone, "");
    state_ = State::kPlanning;
    return;
  }
  const Phase& phase = phases_[phase_];
  stage_ = phase.stage;
  Expected<JointTrajectory> motion;
  {
    const Stopwatch watch(planning_time_);
    motion = phase.plan(bench_);
  }
  if (!motion) {
    if (motion.error().outcome == Outcome::kCancelled)
      return finish(Outcome::kCancelled, motion.error().message);
    if (!phase.optional) return attempt_failed(motion.error());
    motion = JointTrajectory{};
  }
  sent_ = std::move(*motion);
  if (sent_.points.empty()) {
    settled_at_ns_ = now_ns_;
    if (phase.check) {
      settle();
    } else {
      ++phase_;
    }
    return;
  }
  last_stamp_ = std::max(last_stamp_ + 1, now_ns_);
  sent_.stamp_ns = last_stamp_;
  sent_at_ns_ = sent_again_at_ns_ = now_ns_;
  moved_ = true;
  orders.send = sent_;
  state_ = State::kMoving;
}

void ActionRunner::watch_motion(const executor::ExecutorStatus& status) {
  using executor::ExecutorState;
  // In FAULT the executor takes nothing until somebody resets it: another way would not help.
  if (status.state == ExecutorState::kFault) {
    bench_.forget_command();
    const Outcome outcome = status.outcome == Outcome::kDone ? Outcome::kMotionFailed : status.outcome;
    return finish(outcome, "the executor is in fault and waits for a reset: " + status.message);
  }
  if (status.rejected_stamp_ns == sent_.stamp_ns) {
    bench_.forget_command();
    return attempt_failed(
        {Outcome::kMotionFailed, "the executor refused the motion: " + status.rejected_message});
  }
  if (status.trajectory_stamp_ns != sent_.stamp_ns || status.state == ExecutorState::kExecuting ||
      status.state == ExecutorState::kStopping) {
    if (now_ns_ - sent_at_ns_ > sent_.points.back().time_ns + kExecutorSlack) {
      bench_.forget_command();
      finish(Outcome::kComponentLost, "the executor did not report the end of a motion; is it running?");
    }
    return;
  }
  const Phase& phase = phases_[phase_];
  note_hindered(status.outcome != Outcome::kDone);
  if (status.outcome == Outcome::kDone) {
    bench_.set_command(sent_.joints, sent_.points.back().position);
  } else {
    bench_.forget_command();
    // A hand that cannot get away has done its work all the same: look at that.
    if (!phase.optional)
      return attempt_failed({Outcome::kMotionFailed, "the motion was not completed: " + status.message});
  }
  const double wait = phase.settle + (phase.check ? bench_.params().settle_time : 0.0);
  settled_at_ns_ = now_ns_ + static_cast<std::int64_t>(wait * 1e9);
  state_ = State::kSettling;
}

// The arm of the motion that has ended did, or did not, get through it.
void ActionRunner::note_hindered(bool is) {
  for (std::size_t arm = 0; arm < bench_.arm_count(); ++arm) {
    const auto& joints = bench_.model().arms[arm].joints;
    if (std::find(sent_.joints.begin(), sent_.joints.end(), joints.front()) != sent_.joints.end())
      bench_.note_hindered(arm, is);
  }
}

void ActionRunner::settle() {
  const Phase& phase = phases_[phase_];
  if (phase.check) {
    if (auto ok = phase.check(bench_); !ok) return attempt_failed(ok.error());
  }
  ++phase_;
  state_ = State::kNextPhase;
}

void ActionRunner::attempt_failed(const Error& why) {
  if (first_failure_.empty()) first_failure_ = why.message + " (while: " + stage_ + ")";
  if (++attempt_ >= bench_.params().attempts) {
    return finish(Outcome::kMotionFailed,
                  "'" + to_string(action_) + "' failed in " + std::to_string(attempt_) +
                      " ways; the first: " + first_failure_ + "; the last: " + why.message);
  }
  state_ = State::kPlanning;
}

void ActionRunner::finish(Outcome outcome, const std::string& message) {
  result_ = Error{outcome, message};
  bench_.tried().end_action(outcome == Outcome::kDone);
  if (outcome == Outcome::kMotionFailed && !bench_.dead_ends().empty()) {
    if (dead_ends_.size() >= kMostRemembered) dead_ends_.clear();
    auto& ends = dead_ends_[action_];
    ends = bench_.dead_ends();
    if (ends.size() > kMostRemembered)
      ends.erase(ends.begin(), ends.end() - static_cast<std::ptrdiff_t>(kMostRemembered));
  }
  stage_ = "finished";
  state_ = State::kFinished;
  skill_.reset();
}

}  // namespace goalnet::manipulation
