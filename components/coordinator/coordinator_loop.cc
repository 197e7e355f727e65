// The loop itself: infer, plan, act, observe.
#include <algorithm>
#include <utility>

#include "components/coordinator/coordinator.h"

namespace goalnet::coordinator {
namespace {

std::string quoted(const Action& action) { return "\"" + goalnet::to_string(action) + "\""; }

// What makes two moments the same for the question "are we going in circles". Where the robot stands does not
// count.
FactSet lasting_facts(const FactSet& facts) {
  std::vector<Predicate> lasting;
  for (const Predicate& fact : facts) {
    if (!is_robot_near(fact)) lasting.push_back(fact);
  }
  return FactSet(std::move(lasting));
}

// The goal as one ordered list; negative predicates are marked by a relation that no fact has.
std::vector<Predicate> ordered(const Goal& goal) {
  std::vector<Predicate> list = goal.positive;
  for (Predicate predicate : goal.negative) {
    predicate.relation.insert(0, "not ");
    list.push_back(std::move(predicate));
  }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

void Coordinator::begin(Request request, std::uint64_t id, TimeNs now) {
  task_.emplace();
  task_->id = id;
  task_->request = std::move(request);
  task_->started = now;
  task_->last_sent = now;
  // Only what is seen from now on counts: the last world may be all that a dead simulator left behind.
  if (has_world_) task_->world_needed = world_stamp_ + 1;
  report_ = Report{};
  report_.id = id;
  report_.instruction = task_->request.instruction;
  last_difference_.clear();
  enter(Stage::kWaiting, now);
  advance(now);
}

void Coordinator::enter(Stage stage, TimeNs now) {
  report_.stage = stage;
  if (task_) task_->waiting_since = now;
  publish();
}

void Coordinator::publish() { port_.report(report_); }

bool Coordinator::world_is_new_enough() const { return has_world_ && world_stamp_ >= task_->world_needed; }

void Coordinator::advance(TimeNs now) {
  Task& task = *task_;
  if (report_.stage == Stage::kWaiting) {
    if (!world_is_new_enough() || now - world_stamp_ > nanoseconds(params_.world_timeout)) return;
    task.first_facts = world_.facts;
    task.has_first_facts = true;
    return begin_step(now);
  }
  if (report_.stage != Stage::kActing || !world_is_new_enough()) return;
  switch (task.act) {
    case Act::kRunning:
      return;
    case Act::kPrepare:
      return prepare_action(now);
    case Act::kCheckEffects:
      return check_effects(now);
    case Act::kCheckGoal:
      return check_goal(now);
    case Act::kReplan:
      return ask_for_plan(now);
  }
}

void Coordinator::begin_step(TimeNs now) {
  Task& task = *task_;
  if (report_.step >= task.request.max_steps) {
    return stop(Outcome::kStepLimit, "not finished after " + std::to_string(report_.step) + " steps", now);
  }
  task.visited = FactSet{};
  task.early_plan.reset();
  task.orders = 0;
  task.replans = 0;
  task.failures.clear();
  task.detour = Goal();
  report_.goal = Goal{};
  report_.plan.clear();
  report_.current_action = Action{};
  report_.progress = 0.0;
  if (!task.request.goal.empty()) {
    report_.goal = task.request.goal;
    return ask_for_plan(now);
  }
  enter(Stage::kInferring, now);
  task.last_sent = now;
  port_.request_goal(task.id, report_.step, report_.instruction, world_stamp_);
}

void Coordinator::take_goal(const Goal& goal, TimeNs now) {
  Task& task = *task_;
  std::pair moment{lasting_facts(world_.facts), ordered(goal)};
  const auto same = std::find(task.seen.begin(), task.seen.end(), moment);
  if (same != task.seen.end()) {
    if (goal_shortfall(goal, world_.facts, world_.facts).empty()) {
      return finish(Outcome::kDone, "nothing is left to do", now);
    }
    return stop(Outcome::kStepLimit,
                "no progress: step " + std::to_string(report_.step) +
                    " asks for the same in the same world as step " +
                    std::to_string(same - task.seen.begin()),
                now);
  }
  task.seen.push_back(std::move(moment));
  report_.goal = goal;
  enter(Stage::kPlanning, now);
  task.last_sent = now;
  if (task.early_plan) take_plan(*std::exchange(task.early_plan, {}), now);
}

void Coordinator::ask_for_plan(TimeNs now) {
  enter(Stage::kPlanning, now);
  task_->last_sent = now;
  port_.request_plan(task_->id, report_.step, report_.instruction, planned_goal());
}

const Goal& Coordinator::planned_goal() const { return task_->detour.empty() ? report_.goal : task_->detour; }

void Coordinator::take_plan(const PlanAnswer& answer, TimeNs now) {
  Task& task = *task_;
  const bool no_detour = answer.outcome != Outcome::kDone || answer.actions.empty();
  if (no_detour && !std::exchange(task.detour, Goal()).empty()) return ask_for_plan(now);
  if (answer.outcome != Outcome::kDone) return stop(answer.outcome, answer.message, now);
  report_.plan = answer.actions;
  report_.message.clear();
  report_.current_action = Action{};
  report_.progress = 0.0;
  task.plan_size = answer.actions.size();
  task.next = 0;
  task.act = Act::kPrepare;
  enter(Stage::kActing, now);
  advance(now);
}

void Coordinator::prepare_action(TimeNs now) {
  Task& task = *task_;
  task.waiting_since = now;
  if (task.next == report_.plan.size()) {
    if (!std::exchange(task.detour, Goal()).empty()) return ask_for_plan(now);
    task.act = Act::kCheckGoal;
    report_.current_action = Action{};
    report_.progress = 1.0;
    return check_goal(now);
  }
  const Action& action = report_.plan[task.next];
  if (const auto possible = model_.applicable(world_, action); !possible) {
    return replan("before " + quoted(action) + ": " + possible.error().message, now);
  }
  const auto predicted = model_.apply(world_, action);
  if (!predicted) return replan("before " + quoted(action) + ": " + predicted.error().message, now);
  task.expectation = expected_change(world_.facts, *predicted);
  task.order = ActionOrder{task.id, report_.step, task.orders++, action};
  task.order_started = now;
  task.order_heard = false;
  task.last_sent = now;
  task.act = Act::kRunning;
  report_.current_action = action;
  report_.progress = static_cast<double>(task.next) / static_cast<double>(task.plan_size);
  publish();
  port_.execute(task.order);
}

void Coordinator::check_effects(TimeNs now) {
  Task& task = *task_;
  const Shortfall lacking = shortfall(task.expectation, world_.facts);
  if (lacking.empty()) {
    ++task.next;
    task.act = Act::kPrepare;
    return prepare_action(now);
  }
  // The world may take its time: water runs, a door swings, the world model waits for things to settle.
  if (now - task.waiting_since <= nanoseconds(params_.effect_timeout)) return;
  if (only_besides(lacking, task.expectation, task.order.action, report_.goal)) {
    ++task.next;
    task.act = Act::kPrepare;
    return prepare_action(now);
  }
  task.detour = taking_in_hand(lacking, task.order.action, world_.facts, report_.goal);
  action_failed(task.order.action, Outcome::kMotionFailed, "afterwards the world " + to_string(lacking), now);
}

void Coordinator::check_goal(TimeNs now) {
  Task& task = *task_;
  const Shortfall lacking = goal_shortfall(report_.goal, world_.facts, task.visited);
  if (lacking.empty()) {
    if (!task.request.goal.empty())
      return finish(Outcome::kDone, "the goal holds" + what_failed(nullptr), now);
    ++report_.step;
    return begin_step(now);
  }
  if (now - task.waiting_since <= nanoseconds(params_.effect_timeout)) return;
  replan("after the plan the world " + to_string(lacking), now);
}

void Coordinator::action_failed(const Action& action, Outcome outcome, const std::string& why, TimeNs now) {
  const std::string message = quoted(action) + " failed: " + why;
  Failure& failure = task_->failures[action];
  failure.last = why;
  if (++failure.times >= params_.max_action_failures) {
    return stop(outcome, message + " (" + std::to_string(failure.times) + " times)" + what_failed(&action),
                now);
  }
  replan(message, now);
}

// For the outcome: the actions of this step that failed, all but one that the message names already.
std::string Coordinator::what_failed(const Action* but) const {
  constexpr std::size_t kShown = 3, kLongest = 200;
  std::string text;
  std::size_t shown = 0, others = 0;
  for (const auto& [action, failure] : task_->failures) {
    if (but != nullptr && action == *but) continue;
    if (++shown > kShown) {
      ++others;
      continue;
    }
    text += "; before that " + quoted(action) + " failed" +
            (failure.times > 1 ? " " + std::to_string(failure.times) + " times: " : ": ") +
            (failure.last.size() > kLongest ? failure.last.substr(0, kLongest) + "..." : failure.last);
  }
  if (others > 0) text += "; and " + std::to_string(others) + " other actions";
  return text;
}

void Coordinator::replan(const std::string& why, TimeNs now) {
  Task& task = *task_;
  last_difference_ = why;
  report_.message = why;  // until a new plan is there, for people who watch
  if (++task.replans > params_.max_replans) {
    return stop(Outcome::kMotionFailed,
                "gave up after " + std::to_string(params_.max_replans) + " new plans; the last because " +
                    why + what_failed(nullptr),
                now);
  }
  task.act = Act::kReplan;
  report_.current_action = Action{};
  task.waiting_since = now;
  advance(now);
}

void Coordinator::stop(Outcome outcome, const std::string& message, TimeNs now) {
  Task& task = *task_;
  if (report_.stage != Stage::kActing || task.act != Act::kRunning) return finish(outcome, message, now);
  task.stop_outcome = outcome;
  task.stop_message = message;
  enter(Stage::kStopping, now);
  task.last_sent = now;
  port_.cancel(task.order);
}

void Coordinator::finish(Outcome outcome, const std::string& message, TimeNs now) {
  if (task_->has_first_facts) {
    report_.facts_added = difference(world_.facts, task_->first_facts);
    report_.facts_removed = difference(task_->first_facts, world_.facts);
  }
  if (report_.stage == Stage::kInferring || report_.stage == Stage::kPlanning)
    port_.forget_request(task_->id);
  report_.stage = Stage::kFinished;
  report_.current_action = Action{};
  report_.finished = true;
  report_.outcome = outcome;
  report_.message = message;
  task_.reset();
  publish();
  if (queue_.empty()) return;
  auto [id, request] = std::move(queue_.front());
  queue_.pop_front();
  begin(std::move(request), id, now);
}

}  // namespace goalnet::coordinator
