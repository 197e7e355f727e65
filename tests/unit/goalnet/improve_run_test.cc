#include "components/goalnet/ranker/improve_run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr SymAction kFirst{Verb::kTurn, kStoveKnob_1}, kSecond{Verb::kTurn, kStoveKnob_2},
    kThird{Verb::kTurn, kStoveKnob_3};

class ImproveRun : public testing::Test {
 protected:
  CandidateRun run(const std::vector<SymAction>& macros) const { return play(start, macros); }
  std::vector<CandidateRun> pool(const std::vector<std::vector<SymAction>>& runs) const {
    std::vector<CandidateRun> all;
    for (const auto& macros : runs) all.push_back(run(macros));
    return all;
  }
  static float expected_worth(const CandidateRun& run, const std::vector<CandidateRun>& pool,
                              const std::vector<float>& belief) {
    float sum = 0;
    for (std::size_t i = 0; i < pool.size(); ++i) sum += belief[i] * worth(agreement(run, pool[i]));
    return sum;
  }

  const SymState start;
};

TEST_F(ImproveRun, StepsThatMostRunsShareComeTogether) {
  const auto runs = pool({{kFirst, kSecond}, {kFirst, kThird}, {kSecond, kThird}});
  const std::vector<float> belief = {0.34f, 0.33f, 0.33f};
  const CandidateRun better = improve(runs[0], runs, belief, start);
  EXPECT_EQ(better.macros.size(), 3u);
  for (const SymAction& step : {kFirst, kSecond, kThird})
    EXPECT_TRUE(std::find(better.macros.begin(), better.macros.end(), step) != better.macros.end());
  EXPECT_GT(expected_worth(better, runs, belief), expected_worth(runs[0], runs, belief));
}

TEST_F(ImproveRun, WhatNobodyElseDoesIsLeftOut) {
  const auto runs = pool({{kFirst, kSecond}, {kFirst}, {kFirst, kThird}});
  const CandidateRun better = improve(runs[0], runs, std::vector{0.1f, 0.8f, 0.1f}, start);
  EXPECT_EQ(better.macros, std::vector{kFirst});
}

TEST_F(ImproveRun, AStepIsExchanged) {
  const auto runs = pool({{kFirst, kSecond}, {kFirst, kThird}});
  const CandidateRun better = improve(runs[0], runs, std::vector{0.2f, 0.8f}, start);
  EXPECT_EQ(better.macros, (std::vector{kFirst, kThird}));
}

TEST_F(ImproveRun, WhatAllAgreeOnStaysAsItIs) {
  const auto runs = pool({{kFirst, kThird}});
  EXPECT_EQ(improve(runs[0], runs, std::vector{1.0f}, start).actions, runs[0].actions);
  const auto none = pool({{}});
  EXPECT_TRUE(improve(none[0], none, std::vector{1.0f}, start).actions.empty());
}

TEST_F(ImproveRun, TheWorthOfAgreementIsFromZeroToOne) {
  EXPECT_EQ(worth({}), 0);
  EXPECT_NEAR(worth({.sji = 1, .f1 = 1, .ied = 1, .grr = 1}), 1, 1e-6f);
  EXPECT_GT(worth({.ied = 1}), worth({.grr = 1}));
}

TEST_F(ImproveRun, TheExpectedSjiWeighsByBelief) {
  const auto runs = pool({{kFirst}, {}});
  EXPECT_NEAR(expected_sji(runs[0], runs, std::vector{0.75f, 0.25f}), 0.75f, 1e-6f);
}

}  // namespace
}  // namespace goalnet::inference
