#include "tools/goalnet/run_record.h"

#include <cmath>

namespace goalnet::tools {
namespace {

using nlohmann::ordered_json;

constexpr std::uint32_t kMostSteps = 1000;  // the largest max_steps; statuses come from the network

// Simulated time is a whole number of milliseconds; wall-clock time is not known better.
double rounded(double seconds) { return std::round(seconds * 1000.0) / 1000.0; }

}  // namespace

ordered_json to_json(const std::vector<RunStep>& steps) {
  ordered_json list = ordered_json::array();
  for (const RunStep& step : steps) {
    list.push_back({{"positive", texts(step.goal.positive)},
                    {"negative", texts(step.goal.negative)},
                    {"confidence", step.goal.confidence},
                    {"actions", texts(step.actions)}});
  }
  return list;
}

void RunRecord::on_status(const coordinator::Report& report) {
  if (last_.id != 0 && report.id != last_.id) return;  // another instruction, refused meanwhile
  if (!begun_ && report.stage != coordinator::Stage::kWaiting) {
    facts_before_ = facts_;
    begun_ = true;
  }
  const std::size_t carried_out = last_.actions.size();
  last_ = report;
  // While the next step is being inferred its goal is unknown; what was carried out belongs to the one
  // before.
  if (!report.goal.empty()) {
    if (report.step >= kMostSteps) return;  // nobody of ours says so
    if (steps_.size() <= report.step) steps_.resize(report.step + 1);
    steps_[report.step].goal = report.goal;
  }
  if (steps_.empty()) return;
  RunStep& step = report.goal.empty() ? steps_.back() : steps_[report.step];
  for (std::size_t i = carried_out; i < report.actions.size(); ++i) step.actions.push_back(report.actions[i]);
}

void RunRecord::on_world(const WorldState& world) {
  objects_ = world.objects;
  facts_ = world.facts;
}

ordered_json to_json(const RunLabel& label, const RunRecord& record, double sim_time_s, double wall_time_s) {
  ordered_json object;
  object["instruction"] = label.instruction;
  object["scene"] = label.scene;
  object["seed"] = label.seed;
  object["outcome"] = to_string(record.last().outcome);
  object["message"] = record.last().message;
  object["objects"] = record.objects();
  object["facts_before"] = texts(record.facts_before());
  object["facts"] = texts(record.facts());
  object["facts_added"] = texts(difference(record.facts(), record.facts_before()));
  object["facts_removed"] = texts(difference(record.facts_before(), record.facts()));
  object["steps"] = to_json(record.steps());
  object["sim_time_s"] = rounded(sim_time_s);
  object["wall_time_s"] = rounded(wall_time_s);
  return object;
}

ordered_json to_json(const RunLabel& label, const Error& error) {
  RunRecord record;
  coordinator::Report report;
  report.outcome = error.outcome;
  report.message = error.message;
  record.on_status(report);
  return to_json(label, record, 0.0, 0.0);
}

}  // namespace goalnet::tools
