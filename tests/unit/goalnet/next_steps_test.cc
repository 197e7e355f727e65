#include "components/goalnet/ranker/next_steps.h"

#include <gtest/gtest.h>

#include "components/goalnet/ranker/hints.h"

namespace goalnet::inference {
namespace {

constexpr StepKey kTakeCup = step_key(Verb::kGrasp, 1, kNoClass),
                  kTakePlate = step_key(Verb::kGrasp, 2, kNoClass),
                  kCupOnTable = step_key(Verb::kKeepOn, 1, 3);

TEST(NextSteps, NothingDoneTheFirstStepsOfThePlansShare) {
  const Plans plans({{0.5f, {kTakeCup, kCupOnTable}}, {0.25f, {kTakeCup}}, {0.25f, {kTakePlate}}});
  const NextSteps next(plans, {});
  EXPECT_NEAR(next.share(plans.number(kTakeCup)), 0.75f, 1e-4f);
  EXPECT_NEAR(next.share(plans.number(kTakePlate)), 0.25f, 1e-4f);
  EXPECT_EQ(next.share(plans.number(kCupOnTable)), 0);
  EXPECT_EQ(next.stop(), 0);
}

TEST(NextSteps, APlanThatIsDoneStopsAndOneThatWentElsewhereCountsLess) {
  // The first two plans hold the step that was done (fit 1), the last does not (1 of 2, squared).
  const Plans plans({{0.4f, {kTakeCup, kCupOnTable}}, {0.4f, {kTakeCup}}, {0.2f, {kTakePlate}}});
  const NextSteps next(plans, {kTakeCup});
  EXPECT_NEAR(next.share(plans.number(kCupOnTable)), 0.4f / 0.85f, 1e-4f);
  EXPECT_NEAR(next.stop(), 0.4f / 0.85f, 1e-4f);
  EXPECT_NEAR(next.share(plans.number(kTakePlate)), 0.05f / 0.85f, 1e-4f);
}

TEST(NextSteps, AStepDoneTwiceIsNotDoneOnceMore) {
  const Plans plans(std::vector<Plan>{{1.0f, {kTakeCup, kTakeCup}}});
  const NextSteps next(plans, {kTakeCup});
  EXPECT_NEAR(next.share(plans.number(kTakeCup)), 1.0f, 1e-4f);
  EXPECT_EQ(next.stop(), 0);
}

TEST(NextSteps, WithoutPlansNothingIsSaid) {
  const Plans plans;
  const NextSteps next(plans, {kTakeCup});
  EXPECT_EQ(next.share(plans.number(kTakeCup)), 0);
  EXPECT_EQ(next.stop(), 0);
}

}  // namespace
}  // namespace goalnet::inference
