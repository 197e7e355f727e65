#include "tools/goalnet/run_record.h"

#include <gmock/gmock-matchers.h>

#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::tools {
namespace {

using coordinator::facts;
using coordinator::goal;
using coordinator::kMugToSink;
using coordinator::Report;
using coordinator::Stage;

TEST(RunRecord, CollectsStepsAndDifferences) {
  RunRecord record;
  Report report;
  report.id = 1;
  record.on_status(report);  // waiting: the world is not known yet
  record.on_world({{}, facts({"(On Mug_1 Counter_1)"})});
  report.stage = Stage::kInferring;
  record.on_status(report);
  report.goal = goal({"(Grasping Robot Mug_1)"});
  report.stage = Stage::kActing;
  record.on_status(report);
  report.actions = {kMugToSink[0]};
  report.stage = Stage::kInferring;
  report.step = 1;
  report.goal = goal({});
  record.on_status(report);
  EXPECT_EQ(record.steps().size(), 1u) << "the second step is not known yet";
}

TEST(RunRecord, AStepThatCannotBeIsLeftOut) {
  RunRecord record;
  Report report;
  report.id = 1;
  report.stage = Stage::kActing;
  report.goal = goal({"(Grasping Robot Mug_1)"});
  for (const std::uint32_t step : {1000u, 4'000'000'000u, 4'294'967'295u}) {
    report.step = step;
    record.on_status(report);
  }
  EXPECT_TRUE(record.steps().empty());
}

TEST(RunRecord, AnActionBelongsToTheStepThatGaveIt) {
  RunRecord record;
  Report report;
  report.id = 1;
  report.stage = Stage::kActing;
  report.goal = goal({"(Grasping Robot Mug_1)"});
  record.on_status(report);
  report.actions = {kMugToSink[0]};
  report.goal = goal({});  // told only when the step after it has begun
  report.step = 1;
  record.on_status(report);
  report.goal = goal({"(On Mug_1 Sink)"}, {"(Grasping Robot Mug_1)"});
  report.goal.confidence = 0.75;
  record.on_status(report);
  report.actions = kMugToSink;
  report.finished = true;
  report.message = "nothing is left to do";
  record.on_world({{"Mug_1", "Sink"}, facts({"(On Mug_1 Sink)"})});
  record.on_status(report);
  const auto json = to_json({"put the mug in the sink", "kitchen", 7}, record, 12.3456, 1.5);
  EXPECT_EQ(json["steps"][0]["actions"], nlohmann::json({"grasp Mug_1"}));
  EXPECT_EQ(json["steps"][1]["actions"], nlohmann::json({"keep-on Mug_1 Sink"}));
  EXPECT_EQ(json["steps"][1]["confidence"], 0.75);
  EXPECT_EQ(json["steps"][1]["negative"], nlohmann::json({"(Grasping Robot Mug_1)"}));
  EXPECT_EQ(json["facts_added"], nlohmann::json({"(On Mug_1 Sink)"}));
  EXPECT_EQ(json["objects"], nlohmann::json({"Mug_1", "Sink"}));
  EXPECT_EQ(json["outcome"], "done");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["sim_time_s"], 12.346);
}

TEST(RunRecord, AnotherInstructionsRefusalIsNotOurs) {
  RunRecord record;
  Report ours;
  ours.id = 1;
  ours.stage = Stage::kActing;
  record.on_status(ours);
  Report refused;
  refused.id = 2;
  refused.finished = true;
  refused.outcome = Outcome::kBusy;
  record.on_status(refused);
  EXPECT_EQ(record.last().id, 1u);
  EXPECT_FALSE(record.last().finished);
}

TEST(RunRecord, ARefusalHasTheSameShape) {
  const auto refused =
      to_json({"", "kitchen", 1}, Error{Outcome::kInvalidRequest, "the instruction is empty"});
  const auto normal = to_json({"", "kitchen", 1}, RunRecord{}, 0, 0);
  EXPECT_EQ(refused["outcome"], "invalid_request");
  for (const auto& [key, value] : normal.items()) EXPECT_TRUE(refused.contains(key)) << key;
}

}  // namespace
}  // namespace goalnet::tools
