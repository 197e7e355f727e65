// The events that come from outside, and what did not come in time. The loop itself is in
// coordinator_loop.cc.
#include "components/coordinator/coordinator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "components/coordinator/request.h"

namespace goalnet::coordinator {
namespace {

// Whether there is no point in trying the same thing again.
bool is_final(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCancelled:
    case Outcome::kWorldStale:
    case Outcome::kComponentLost:
    case Outcome::kEmergencyStop:
    case Outcome::kInternal:
    case Outcome::kInvalidRequest:
    case Outcome::kNoPlan:  // manipulation: it does not fit, whatever is tried
      return true;
    default:
      return false;
  }
}

}  // namespace

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::kWaiting:
      return "waiting";
    case Stage::kInferring:
      return "inferring";
    case Stage::kPlanning:
      return "planning";
    case Stage::kActing:
      return "acting";
    case Stage::kStopping:
      return "stopping";
    case Stage::kFinished:
      return "finished";
  }
  return "finished";
}

Coordinator::Coordinator(const CoordinatorParams& params, const ActionModel& model, Port& port,
                         std::uint64_t first_id)
    : params_(params), model_(model), port_(port), last_id_(first_id - 1) {}

Expected<std::uint64_t> Coordinator::instruct(const std::string& instruction, std::uint32_t max_steps,
                                              TimeNs now) {
  if (const auto checked = coordinator::check_instruction(instruction); !checked) {
    refuse("", checked.error());  // what cannot be shown is not repeated
    return tl::unexpected<Error>(checked.error());
  }
  Request request;
  request.instruction = instruction;
  request.max_steps = max_steps == 0 ? params_.max_steps : max_steps;
  return accept(std::move(request), now);
}

Expected<std::uint64_t> Coordinator::pursue(const Goal& goal, TimeNs now) {
  if (const auto checked = coordinator::check_goal(goal); !checked) {
    refuse("", checked.error());
    return tl::unexpected<Error>(checked.error());
  }
  Request request;
  request.goal = model_.as_spelled(goal);
  request.max_steps = 1;
  return accept(std::move(request), now);
}

void Coordinator::refuse(const std::string& instruction, const Error& error) {
  Report refused;
  refused.id = ++last_id_;
  refused.instruction = instruction;
  refused.stage = Stage::kFinished;
  refused.finished = true;
  refused.outcome = error.outcome;
  refused.message = error.message;
  port_.report(refused);
  // The status is latched: who comes later must find the instruction that runs.
  if (task_) {
    port_.report(report_);
  } else {
    report_ = refused;
  }
}

Expected<std::uint64_t> Coordinator::accept(Request request, TimeNs now) {
  if (!task_) {
    const std::uint64_t id = ++last_id_;
    begin(std::move(request), id, now);
    return id;
  }
  if (params_.when_busy == WhenBusy::kQueue && queue_.size() < params_.queue_length) {
    queue_.emplace_back(++last_id_, std::move(request));
    return last_id_;
  }
  Error error{Outcome::kBusy, "instruction " + std::to_string(task_->id) +
                                  " is still running; cancel it or ask again when it has finished"};
  if (params_.when_busy == WhenBusy::kQueue) error.message += " (the queue is full)";
  refuse(request.instruction, error);
  return tl::unexpected<Error>(std::move(error));
}

void Coordinator::cancel(TimeNs now, const std::string& reason) {
  for (const auto& [id, request] : std::exchange(queue_, {})) drop(id, request, reason);
  if (task_ && report_.stage != Stage::kStopping) stop(Outcome::kCancelled, reason, now);
}

bool Coordinator::cancel_one(std::uint64_t id, TimeNs now, const std::string& reason) {
  if (task_ && task_->id == id) {
    if (report_.stage != Stage::kStopping) stop(Outcome::kCancelled, reason, now);
    return true;
  }
  const auto waiting =
      std::find_if(queue_.begin(), queue_.end(), [id](const auto& entry) { return entry.first == id; });
  if (waiting == queue_.end()) return false;
  const Request request = std::move(waiting->second);
  queue_.erase(waiting);
  drop(id, request, reason);
  return true;
}

void Coordinator::world_lost(TimeNs now, const std::string& reason) {
  if (!task_) return;
  if (report_.stage != Stage::kStopping) stop(Outcome::kWorldStale, reason, now);
  if (task_)
    finish(task_->stop_outcome, task_->stop_message, now);  // time stands still: nothing would confirm it
}

void Coordinator::abandon(TimeNs now, const std::string& reason) {
  for (const auto& [id, request] : std::exchange(queue_, {})) drop(id, request, reason);
  if (!task_) return;
  if (report_.stage != Stage::kStopping) stop(Outcome::kCancelled, reason, now);
  if (task_) finish(task_->stop_outcome, task_->stop_message, now);
}

void Coordinator::drop(std::uint64_t id, const Request& request, const std::string& reason) {
  Report dropped;
  dropped.id = id;
  dropped.instruction = request.instruction;
  dropped.stage = Stage::kFinished;
  dropped.finished = true;
  dropped.outcome = Outcome::kCancelled;
  dropped.message = reason;
  port_.report(dropped);
  if (task_) port_.report(report_);  // latched: see refuse()
}

void Coordinator::on_world(WorldState world, TimeNs stamp, TimeNs now) {
  world_heard_ = now;
  const bool older = has_world_ && stamp < world_stamp_;
  const bool clock_restarted = older && now < world_stamp_;  // a simulator that was started again
  if (older && !clock_restarted) return;                     // late
  world_ = std::move(world);
  world_stamp_ = stamp;
  has_world_ = true;
  if (!task_) return;
  if (clock_restarted)
    return stop(Outcome::kWorldStale, "time jumped back; was the simulator restarted?", now);
  for (const Predicate& fact : world_.facts) {
    if (fact.relation == "Near") task_->visited.insert(fact);
  }
  advance(now);
}

void Coordinator::on_goal(const GoalAnswer& answer, TimeNs now) {
  if (!task_ || report_.stage != Stage::kInferring || answer.id != task_->id || answer.step != report_.step)
    return;
  if (answer.outcome != Outcome::kDone) return stop(answer.outcome, answer.message, now);
  if (answer.complete || answer.goal.empty()) {
    return finish(Outcome::kDone, report_.step == 0 ? "nothing needs to be done" : "nothing is left to do",
                  now);
  }
  take_goal(model_.as_spelled(answer.goal), now);
}

void Coordinator::on_plan(const PlanAnswer& answer, TimeNs now) {
  if (!task_ || answer.id != task_->id || answer.step != report_.step) return;
  // Between processes the plan can overtake the goal it is for.
  if (report_.stage == Stage::kInferring) task_->early_plan = answer;
  if (report_.stage == Stage::kPlanning) take_plan(answer, now);
}

void Coordinator::on_action(const ActionReport& report, TimeNs now) {
  // What runs for an instruction that nobody watches any more is stopped: its coordinator was killed, or it
  // did not stop in time. What people ask of manipulation by hand has the number 0, and is theirs.
  const bool watched = task_ && report.id == task_->id;
  if (!watched && !report.finished && report.id != 0)
    return port_.cancel(ActionOrder{report.id, report.step, report.index, {}});
  if (!task_ || report.id != task_->order.id || report.step != task_->order.step ||
      report.index != task_->order.index) {
    return;
  }
  Task& task = *task_;
  const bool running = report_.stage == Stage::kActing && task.act == Act::kRunning;
  if (!running && report_.stage != Stage::kStopping) return;
  task.order_heard = true;
  if (running) task.waiting_since = now;
  if (!report.finished) {
    if (!running || task.plan_size == 0) return;
    const double part = std::isfinite(report.progress) ? std::clamp(report.progress, 0.0, 1.0) : 0.0;
    const double progress = (static_cast<double>(task.next) + part) / static_cast<double>(task.plan_size);
    if (progress > report_.progress + 0.01) {
      report_.progress = progress;
      publish();
    }
    return;
  }
  task.world_needed = now;
  if (report.outcome == Outcome::kDone) {
    report_.actions.push_back(task.order.action);
    report_.current_action = Action{};
    publish();
  }
  if (!running) return finish(task.stop_outcome, task.stop_message, now);
  task.act = Act::kCheckEffects;  // the robot stands still now, whatever the outcome
  if (report.outcome == Outcome::kDone) return advance(now);
  if (is_final(report.outcome)) return finish(report.outcome, report.message, now);
  action_failed(task.order.action, report.outcome, report.message, now);
}

void Coordinator::tick(TimeNs now) {
  if (!task_) return;
  check_timeouts(now);
  if (task_) advance(now);
  if (task_) send_again(now);
}

void Coordinator::check_timeouts(TimeNs now) {
  Task& task = *task_;
  const TimeNs waited = now - task.waiting_since;
  const auto after = [waited](double seconds) { return waited > nanoseconds(seconds); };
  switch (report_.stage) {
    case Stage::kWaiting:
      if (after(params_.first_world_timeout)) {
        finish(Outcome::kWorldStale, why_stale("no fresh world state arrived", now), now);
      }
      return;
    case Stage::kStopping:
      if (after(params_.cancel_timeout)) {
        finish(task.stop_outcome, task.stop_message + "; manipulation did not confirm the stop", now);
      }
      return;
    case Stage::kInferring:
      if (after(params_.inference_timeout)) {
        return stop(Outcome::kComponentLost, "goalnet did not answer; is it running?", now);
      }
      break;
    case Stage::kPlanning:
      if (after(params_.planning_timeout)) {
        return stop(Outcome::kComponentLost, "the planner did not answer; is it running?", now);
      }
      break;
    case Stage::kActing:
      if (task.act != Act::kRunning) break;
      if (after(params_.action_silence_timeout)) {
        return stop(Outcome::kComponentLost,
                    "manipulation went silent during \"" + goalnet::to_string(task.order.action) + "\"", now);
      }
      if (now - task.order_started > nanoseconds(params_.action_timeout)) {
        return stop(Outcome::kTimeLimit, "\"" + goalnet::to_string(task.order.action) + "\" took too long",
                    now);
      }
      break;
    case Stage::kFinished:
      return;
  }
  if (now - world_stamp_ > nanoseconds(params_.world_timeout)) {
    return stop(Outcome::kWorldStale, why_stale("the world state is no longer updated", now), now);
  }
  if (now - task.started > nanoseconds(params_.instruction_timeout)) {
    stop(Outcome::kTimeLimit, "the instruction took too long", now);
  }
}

std::string Coordinator::why_stale(const std::string& what, TimeNs now) const {
  if (!has_world_ || now - world_heard_ > nanoseconds(params_.world_timeout))
    return what + "; is the world model running?";
  char age[32];
  std::snprintf(age, sizeof age, "%.1f", 1e-9 * static_cast<double>(now - world_stamp_));
  return "world states arrive, but the newest is " + std::string(age) +
         " s old; do the clocks of all computers agree?";
}

void Coordinator::send_again(TimeNs now) {
  Task& task = *task_;
  if (now - task.last_sent < nanoseconds(params_.resend_period)) return;
  task.last_sent = now;
  if (report_.stage == Stage::kInferring) {
    port_.request_goal(task.id, report_.step, report_.instruction, world_stamp_);
  } else if (report_.stage == Stage::kPlanning) {
    port_.request_plan(task.id, report_.step, report_.instruction, planned_goal());
  } else if (report_.stage == Stage::kActing && task.act == Act::kRunning && !task.order_heard) {
    port_.execute(task.order);
  } else if (report_.stage == Stage::kStopping) {
    port_.cancel(task.order);
  }
}

}  // namespace goalnet::coordinator
