// A two-action world and a port that records, so that the loop can be driven event by event.
#pragma once

#include <string>
#include <vector>

#include "components/coordinator/action_model.h"
#include "components/coordinator/coordinator.h"

namespace goalnet::coordinator {

constexpr TimeNs kSecond = 1'000'000'000;

inline Predicate fact(const std::string& text) { return parse_predicate(text).value(); }

inline FactSet facts(const std::vector<std::string>& texts) {
  FactSet set;
  for (const std::string& text : texts) set.insert(fact(text));
  return set;
}

inline Goal goal(const std::vector<std::string>& positive, const std::vector<std::string>& negative = {}) {
  Goal result;
  for (const std::string& text : positive) result.positive.push_back(fact(text));
  for (const std::string& text : negative) result.negative.push_back(fact(text));
  return result;
}

// grasp X; keep-on X Y; moveto X; turn-on Tap: water runs into all that is in the sink, by the rules.
class ToyModel : public ActionModel {
 public:
  Expected<void> applicable(const WorldState& world, const Action& action) const override {
    const std::string& x = action.arguments.at(0);
    const Predicate held{"Grasping", "Robot", x};
    if (action.name == "grasp" && world.facts.contains(held))
      return fail(Outcome::kNoPlan, "already holds " + x);
    if (action.name == "keep-on" && !world.facts.contains(held))
      return fail(Outcome::kNoPlan, "does not hold " + x);
    return {};
  }

  Expected<FactSet> apply(const WorldState& world, const Action& action) const override {
    FactSet result = world.facts;
    const std::string& x = action.arguments.at(0);
    if (action.name == "turn-on") {
      result.insert({"state", x, "TapIsOn"});
      for (const Predicate& on : world.facts)
        if (on.relation == "On" && on.object == "Sink") result.insert({"state", on.subject, "Water"});
    } else if (action.name == "moveto") {
      for (const Predicate& near : world.facts) {
        if (near.relation == "Near") result.erase(near);
      }
      result.insert({"Near", "Robot", x});
    } else if (action.name == "grasp") {
      result.insert({"Grasping", "Robot", x});
      for (const Predicate& on : world.facts) {
        if (on.relation == "On" && on.subject == x) result.erase(on);
      }
    } else {
      result.erase({"Grasping", "Robot", x});
      result.insert({"On", x, action.arguments.at(1)});
    }
    return result;
  }
};

struct RecordingPort : Port {
  void request_goal(std::uint64_t id, std::uint32_t step, const std::string&, TimeNs) override {
    goal_requests.emplace_back(id, step);
  }
  void request_plan(std::uint64_t id, std::uint32_t step, const std::string&, const Goal& wanted) override {
    plan_requests.emplace_back(id, step);
    plan_goal = wanted;
  }
  void execute(const ActionOrder& order) override { orders.push_back(order); }
  void cancel(const ActionOrder& order) override { cancels.push_back(order); }
  void forget_request(std::uint64_t id) override { forgotten.push_back(id); }
  void report(const Report& report) override { reports.push_back(report); }

  std::vector<std::pair<std::uint64_t, std::uint32_t>> goal_requests, plan_requests;
  Goal plan_goal;  // of the last request
  std::vector<std::uint64_t> forgotten;
  std::vector<ActionOrder> orders, cancels;
  std::vector<Report> reports;
};

// The coordinator with the world around it played by the test.
struct Play {
  explicit Play(CoordinatorParams params = {}) : coordinator(params, model, port) {}

  void world_now(const FactSet& now_holds) {
    world = now_holds;
    seen = true;
    coordinator.on_world(WorldState{{"Counter_1", "Mug_1", "Robot", "Sink"}, world}, now, now);
  }
  // Asks, and lets the world be seen once more: what was seen before does not count.
  Expected<std::uint64_t> instruct(const std::string& text) {
    const auto id = coordinator.instruct(text, 0, now);
    if (seen) pass(0.1);
    return id;
  }
  Expected<std::uint64_t> pursue(const Goal& wanted) {
    const auto id = coordinator.pursue(wanted, now);
    if (seen) pass(0.1);
    return id;
  }
  // Time passes with the world observed at 10 Hz.
  void pass(double seconds) {
    const TimeNs end = now + static_cast<TimeNs>(seconds * 1e9);
    while (now < end) {
      now += kSecond / 10;
      coordinator.on_world(WorldState{{"Counter_1", "Mug_1", "Robot", "Sink"}, world}, now, now);
      coordinator.tick(now);
    }
  }
  // Time passes and nothing is heard.
  void silence(double seconds) {
    const TimeNs end = now + static_cast<TimeNs>(seconds * 1e9);
    while (now < end) coordinator.tick(now += kSecond / 10);
  }
  void infer(const Goal& next) { answer_goal({id(), step(), next, next.empty(), Outcome::kDone, ""}); }
  void answer_goal(const GoalAnswer& answer) { coordinator.on_goal(answer, now); }
  void plan(const std::vector<Action>& actions) {
    coordinator.on_plan({id(), step(), actions, Outcome::kDone, ""}, now);
  }
  // Manipulation ends the current order; with kDone the world changes as the rules say.
  void act(Outcome outcome = Outcome::kDone, const std::string& message = "") {
    const ActionOrder order = port.orders.back();
    if (outcome == Outcome::kDone) world = model.apply({{}, world}, order.action).value();
    finish_action(outcome, message);
    pass(0.1);
  }
  void finish_action(Outcome outcome, const std::string& message = "") {
    const ActionOrder order = port.orders.back();
    coordinator.on_action({order.id, order.step, order.index, true, 1.0, outcome, message}, now);
  }
  std::uint64_t id() const { return coordinator.report().id; }
  std::uint32_t step() const { return coordinator.report().step; }
  const Report& report() const { return coordinator.report(); }

  ToyModel model;
  RecordingPort port;
  Coordinator coordinator;
  FactSet world;
  TimeNs now = kSecond;
  bool seen = false;
};

inline const std::vector<Action> kMugToSink = {{"grasp", {"Mug_1"}}, {"keep-on", {"Mug_1", "Sink"}}};

}  // namespace goalnet::coordinator
