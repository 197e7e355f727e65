// The loop from instruction to changed world: infer a goal, plan, act, observe, until nothing is left to do.
//
// A pure state machine: events come in with the time at which they happened, orders go out through a Port,
// and nothing waits, sleeps or reads a clock. Whoever drives it calls tick() a few times a second at least,
// because that is where timeouts are noticed.
//
//   waiting ── world known ──► inferring ── goal ──► planning ── plan ──► acting ──┐ goal reached: next step
//      ▲ a goal given by a person skips inferring ──────►▲                  │      └──► inferring
//      │                                                 └─ world differs ──┘
//   every stage ── refusal, limit, fault, cancel ──► stopping (while the robot moves) ──► finished
//
// What a caller may rely on:
// - Every instruction ends in exactly one report with finished = true and a typed outcome; kDone only if
//   the world was seen to hold the goal of every step.
// - Before each action its preconditions are checked in a world state observed after the previous action;
//   after it, its effects. A difference leads to a new plan, at most max_replans times a step.
// - A step that asks for the same goal in the same world as an earlier one ends the loop.
//
// Thread role: one thread calls everything; the Port is called back inside these calls.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/coordinator/action_model.h"
#include "components/coordinator/expectation.h"
#include "components/coordinator/params.h"
#include "components/coordinator/port.h"

namespace goalnet::coordinator {

struct GoalAnswer {
  std::uint64_t id = 0;
  std::uint32_t step = 0;
  Goal goal;
  bool complete = false;  // nothing is left to do
  Outcome outcome = Outcome::kDone;
  std::string message;
};

struct PlanAnswer {
  std::uint64_t id = 0;
  std::uint32_t step = 0;
  std::vector<Action> actions;
  Outcome outcome = Outcome::kDone;
  std::string message;
};

struct ActionReport {
  std::uint64_t id = 0;
  std::uint32_t step = 0;
  std::uint32_t index = 0;
  bool finished = false;
  double progress = 0.0;  // 0..1 of the action
  Outcome outcome = Outcome::kDone;
  std::string message;
};

class Coordinator {
 public:
  // `model` and `port` must outlive the coordinator. Ids count from `first_id`.
  Coordinator(const CoordinatorParams& params, const ActionModel& model, Port& port,
              std::uint64_t first_id = 1);

  // Starts (or queues) an instruction; max_steps 0 means the parameter's. Returns its id. Refusals
  // (kInvalidRequest, kBusy) are returned and also reported under an id of their own.
  Expected<std::uint64_t> instruct(const std::string& instruction, std::uint32_t max_steps, TimeNs now);

  // The same with the goal given by a person: no inference, one step.
  Expected<std::uint64_t> pursue(const Goal& goal, TimeNs now);

  // Stops the running instruction with kCancelled (nothing if none runs) and forgets waiting ones.
  void cancel(TimeNs now, const std::string& reason = "cancelled on request");

  // The same for one instruction, running or waiting. False if it is neither.
  bool cancel_one(std::uint64_t id, TimeNs now, const std::string& reason = "cancelled on request");

  // Stops the running instruction at once: manipulation is told, but its word that the robot stands is not
  // waited for. For a coordinator that is about to go. Waiting ones are forgotten.
  void abandon(TimeNs now, const std::string& reason);

  // The world can no longer be known, for a reason that no timeout would show. Ends what runs as kWorldStale.
  void world_lost(TimeNs now, const std::string& reason);

  // `stamp` is when the world was observed.
  void on_world(WorldState world, TimeNs stamp, TimeNs now);
  void on_goal(const GoalAnswer& answer, TimeNs now);
  void on_plan(const PlanAnswer& answer, TimeNs now);
  void on_action(const ActionReport& report, TimeNs now);

  // Notices what did not happen in time.
  void tick(TimeNs now);

  // Of the newest instruction, refused ones included.
  std::uint64_t last_id() const { return last_id_; }
  bool busy() const { return task_.has_value(); }
  const Report& report() const { return report_; }
  // Why the running instruction's plan was last thrown away; empty if it never was.
  const std::string& last_difference() const { return last_difference_; }

 private:
  // Inside the acting stage.
  enum class Act { kPrepare, kRunning, kCheckEffects, kCheckGoal, kReplan };

  struct Request {
    std::string instruction;
    Goal goal;  // empty: infer
    std::uint32_t max_steps = 0;
  };

  struct Failure {
    std::uint32_t times = 0;
    std::string last;  // why
  };

  struct Task {
    Task() {}  // clang 14 takes no default one inside std::optional here

    Request request;
    std::uint64_t id = 0;
    TimeNs started = 0;
    TimeNs waiting_since = 0;  // start of the current wait, for timeouts
    TimeNs last_sent = 0;      // for sending again
    TimeNs world_needed = 0;   // world states observed before this say nothing about what was just done
    FactSet first_facts;
    bool has_first_facts = false;
    FactSet visited;  // Near facts seen during the step
    std::optional<PlanAnswer> early_plan;
    Act act = Act::kPrepare;
    std::size_t next = 0;  // place in the plan
    std::size_t plan_size = 0;
    ActionOrder order;         // the one under way, or the last
    std::uint32_t orders = 0;  // given in this step
    TimeNs order_started = 0;
    bool order_heard = false;
    Expectation expectation;
    std::uint32_t replans = 0;
    Goal detour;                         // planned for first, once: see check_effects(); empty: none
    std::map<Action, Failure> failures;  // in this step
    std::vector<std::pair<FactSet, std::vector<Predicate>>> seen;  // (world, goal) at the start of each step
    Outcome stop_outcome = Outcome::kDone;
    std::string stop_message;
  };

  void refuse(const std::string& instruction, const Error& error);
  Expected<std::uint64_t> accept(Request request, TimeNs now);
  void begin(Request request, std::uint64_t id, TimeNs now);
  void enter(Stage stage, TimeNs now);
  void publish();
  void drop(std::uint64_t id, const Request& request, const std::string& reason);
  bool world_is_new_enough() const;
  void advance(TimeNs now);  // does what the newest world state allows

  void begin_step(TimeNs now);
  void take_goal(const Goal& goal, TimeNs now);
  void ask_for_plan(TimeNs now);
  const Goal& planned_goal() const;
  void take_plan(const PlanAnswer& answer, TimeNs now);
  void prepare_action(TimeNs now);
  void check_effects(TimeNs now);
  void check_goal(TimeNs now);
  void action_failed(const Action& action, Outcome outcome, const std::string& why, TimeNs now);
  void replan(const std::string& why, TimeNs now);
  std::string what_failed(const Action* but) const;
  void stop(Outcome outcome, const std::string& message, TimeNs now);
  void finish(Outcome outcome, const std::string& message, TimeNs now);
  void check_timeouts(TimeNs now);
  std::string why_stale(const std::string& what, TimeNs now) const;
  void send_again(TimeNs now);

  const CoordinatorParams params_;
  const ActionModel& model_;
  Port& port_;

  std::uint64_t last_id_;
  std::optional<Task> task_;
  std::deque<std::pair<std::uint64_t, Request>> queue_;
  Report report_;
  WorldState world_;
  TimeNs world_stamp_ = 0;
  TimeNs world_heard_ = 0;  // when one last arrived, however old
  bool has_world_ = false;
  std::string last_difference_;
};

}  // namespace goalnet::coordinator
