// What the coordinator sends, without saying how: the node turns it into messages, tests record it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::coordinator {

// Nanoseconds of the coordinator's clock. Never wall-clock time in simulation.
using TimeNs = std::int64_t;
inline TimeNs nanoseconds(double seconds) { return static_cast<TimeNs>(seconds * 1e9); }

enum class Stage { kWaiting, kInferring, kPlanning, kActing, kStopping, kFinished };

// "waiting", "inferring", "planning", "acting", "stopping", "finished".
const char* to_string(Stage stage);

// Where an instruction stands; the content of /instruction_status.
struct Report {
  std::uint64_t id = 0;
  std::string instruction;  // empty where a person gave the predicates
  Stage stage = Stage::kWaiting;
  std::uint32_t step = 0;
  Goal goal;                 // of the current step
  std::vector<Action> plan;  // of the current step
  Action current_action;     // empty name: none
  double progress = 0.0;     // 0..1 of the current plan
  bool finished = false;     // outcome, message, facts_* are valid
  Outcome outcome = Outcome::kDone;
  std::string message;
  FactSet facts_added;
  FactSet facts_removed;
  std::vector<Action> actions;  // everything carried out
};

// One action to be carried out; (id, step, index, attempt order) identify it for manipulation.
struct ActionOrder {
  std::uint64_t id = 0;
  std::uint32_t step = 0;
  std::uint32_t index = 0;  // counts every order of the step, so that a repeated action is a new one
  Action action;
};

class Port {
 public:
  virtual ~Port() = default;

  // Asks goalnet for the goal of `step`; the world state used must not be older than `world_stamp`.
  virtual void request_goal(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                            TimeNs world_stamp) = 0;
  // Asks the planner for a plan. Not called after request_goal: goalnet's answer reaches the planner by
  // itself.
  virtual void request_plan(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                            const Goal& goal) = 0;
  virtual void execute(const ActionOrder& order) = 0;
  virtual void cancel(const ActionOrder& order) = 0;
  // Nobody wants the answer to request_goal() or request_plan() any more: a search may end.
  virtual void forget_request(std::uint64_t id) = 0;
  virtual void report(const Report& report) = 0;
};

}  // namespace goalnet::coordinator
