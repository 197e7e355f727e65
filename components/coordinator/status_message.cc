#include "components/coordinator/status_message.h"

#include "components/messages/conversions.h"

namespace goalnet::coordinator {

goalnet_msgs::msg::InstructionStatus to_message(const Report& report, TimeNs now) {
  goalnet_msgs::msg::InstructionStatus message;
  message.header().stamp(messages::to_stamp(now));
  message.instruction_id(report.id);
  message.instruction(report.instruction);
  message.stage(to_string(report.stage));
  message.step(report.step);
  message.positive(messages::to_message(report.goal.positive));
  message.negative(messages::to_message(report.goal.negative));
  message.plan(messages::to_message(report.plan));
  message.current_action(messages::to_message(report.current_action));
  message.progress(report.progress);
  message.finished(report.finished);
  message.outcome(static_cast<std::int32_t>(report.outcome));
  message.message(report.message);
  message.facts_added(messages::to_message(report.facts_added));
  message.facts_removed(messages::to_message(report.facts_removed));
  message.actions(messages::to_message(report.actions));
  return message;
}

Report from_message(const goalnet_msgs::msg::InstructionStatus& message) {
  Report report;
  report.id = message.instruction_id();
  report.instruction = message.instruction();
  for (const Stage stage :
       {Stage::kInferring, Stage::kPlanning, Stage::kActing, Stage::kStopping, Stage::kFinished}) {
    if (message.stage() == to_string(stage)) report.stage = stage;
  }
  report.step = message.step();
  report.goal.positive = messages::from_message(message.positive());
  report.goal.negative = messages::from_message(message.negative());
  report.plan = messages::from_message(message.plan());
  report.current_action = messages::from_message(message.current_action());
  report.progress = message.progress();
  report.finished = message.finished();
  report.outcome = outcome_from_int(message.outcome());
  report.message = message.message();
  report.facts_added = FactSet(messages::from_message(message.facts_added()));
  report.facts_removed = FactSet(messages::from_message(message.facts_removed()));
  report.actions = messages::from_message(message.actions());
  return report;
}

}  // namespace goalnet::coordinator
