// What happened during one `goalnet run`: collected from what the components publish, told as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "components/coordinator/port.h"
#include "components/core/predicate.h"

namespace goalnet::tools {

struct RunStep {
  Goal goal;
  std::vector<Action> actions;  // carried out, in order
};

// Pure bookkeeping; feed it every status and world state in order of arrival.
class RunRecord {
 public:
  void on_status(const coordinator::Report& report);
  void on_world(const WorldState& world);

  const std::vector<RunStep>& steps() const { return steps_; }
  const coordinator::Report& last() const { return last_; }
  const std::vector<std::string>& objects() const { return objects_; }
  const FactSet& facts_before() const { return facts_before_; }
  const FactSet& facts() const { return facts_; }

 private:
  std::vector<RunStep> steps_;
  coordinator::Report last_;
  std::vector<std::string> objects_;
  FactSet facts_before_;
  FactSet facts_;
  bool begun_ = false;
};

// "(On Mug_1 Sink)" for predicates, "moveTo Mug_1" for actions.
template <class Range>
nlohmann::ordered_json texts(const Range& range) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& item : range) list.push_back(goalnet::to_string(item));
  return list;
}

// [{"positive", "negative", "actions"}]
nlohmann::ordered_json to_json(const std::vector<RunStep>& steps);

// What identifies a run.
struct RunLabel {
  std::string instruction;  // the sentence, or the goal's predicates
  std::string scene;
  std::uint64_t seed = 0;
};

// The object that `goalnet run --json` prints. Everything but wall_time_s [s] is the same for the same seed.
nlohmann::ordered_json to_json(const RunLabel& label, const RunRecord& record, double sim_time_s,
                               double wall_time_s);

// The same shape for a run that never began.
nlohmann::ordered_json to_json(const RunLabel& label, const Error& error);

}  // namespace goalnet::tools
