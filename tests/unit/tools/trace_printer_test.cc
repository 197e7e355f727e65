#include "tools/goalnet/trace_printer.h"

#include <gmock/gmock-matchers.h>

#include <sstream>

#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::tools {
namespace {

using coordinator::facts;
using coordinator::goal;
using coordinator::kMugToSink;
using coordinator::Report;
using coordinator::Stage;
using testing::HasSubstr;
using testing::Not;

// The events of a run of one step with two actions.
std::string trace(TraceStyle style) {
  std::ostringstream out;
  TracePrinter printer(out, style);
  printer.begin({"put the mug in the sink", "kitchen", 1}, "");
  Report report;
  report.id = 1;
  report.stage = Stage::kInferring;
  printer.on_status(report, 0.0, 0.0);
  report.goal = goal({"(On Mug_1 Sink)"}, {"(state SinkKnob TapIsOn)"});
  report.goal.confidence = 0.87;
  report.stage = Stage::kPlanning;
  printer.on_status(report, 0.0, 0.1);
  report.plan = kMugToSink;
  report.stage = Stage::kActing;
  report.current_action = kMugToSink[0];
  printer.on_status(report, 0.0, 0.1);
  printer.on_stage("approach", 0.5, 1.0, 0.2);
  report.actions = {kMugToSink[0]};
  report.current_action = kMugToSink[1];
  report.progress = 0.5;
  printer.on_status(report, 4.2, 0.4);
  report.current_action = {};
  report.stage = Stage::kFinished;
  report.finished = true;
  report.outcome = Outcome::kMotionFailed;
  report.message = "no path";
  printer.on_status(report, 6.0, 0.5);
  printer.end(report, facts({"(Grasping Robot Mug_1)", "(Near Robot Mug_1)"}),
              facts({"(On Mug_1 Counter_1)"}), 6.0, 0.5);
  return out.str();
}

TEST(TracePrinter, TellsTheStoryInPlainText) {
  const std::string text = trace({});
  EXPECT_THAT(text, HasSubstr("step 1  wants  (On Mug_1 Sink)  not (state SinkKnob TapIsOn)  (87 % sure)"));
  EXPECT_THAT(text, HasSubstr("plan  grasp Mug_1, keep-on Mug_1 Sink"));
  EXPECT_THAT(text, HasSubstr("✓ grasp Mug_1"));
  EXPECT_THAT(text, HasSubstr("4.2 s  (0.3 s real)"));
  EXPECT_THAT(text, HasSubstr("✗ keep-on Mug_1 Sink"));
  EXPECT_THAT(text, HasSubstr("motion failed: no path"));
  EXPECT_THAT(text, HasSubstr("now         (Grasping Robot Mug_1)\n"))
      << "where it stands is not worth telling";
  EXPECT_THAT(text,
              HasSubstr("1 action in 6.0 s of simulated time, 0.5 s of real time (12.0 times as fast)"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
  EXPECT_THAT(text, Not(HasSubstr("approach"))) << "stages are for live lines only";
}

TEST(TracePrinter, SaysWhyThereIsANewPlan) {
  std::ostringstream out;
  TracePrinter printer(out, {});
  Report report;
  report.id = 1;
  report.goal = goal({"(On Mug_1 Sink)"});
  report.plan = kMugToSink;
  report.stage = Stage::kActing;
  report.current_action = kMugToSink[0];
  printer.on_status(report, 0.0, 0.0);
  report.stage = Stage::kPlanning;
  report.message = "the mug slipped";
  printer.on_status(report, 3.0, 0.1);
  report.stage = Stage::kActing;
  report.message.clear();
  printer.on_status(report, 3.0, 0.1);
  const std::string text = out.str();
  EXPECT_THAT(text, HasSubstr("! new plan: the mug slipped\n        plan  grasp Mug_1, keep-on Mug_1 Sink"));
}

TEST(TracePrinter, KnowsOneTimeWhereNothingIsSimulated) {
  const std::string text = trace({.simulated = false});
  EXPECT_THAT(text, HasSubstr("1 action in 0.5 s\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("simulated")));
  EXPECT_THAT(text, testing::Not(HasSubstr("real")));
}

TEST(TracePrinter, RedrawsTheRunningActionOnATerminal) {
  const std::string text = trace({.colour = true, .live = true});
  EXPECT_THAT(text, HasSubstr("\r\x1b[2K"));
  EXPECT_THAT(text, HasSubstr("██████░░░░░░  approach"));
  EXPECT_THAT(text, HasSubstr("\x1b[31mmotion failed\x1b[0m"));
}

}  // namespace
}  // namespace goalnet::tools
