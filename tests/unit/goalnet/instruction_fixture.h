// What tests of single sentences share: one runner for all of them, as loading the model takes longer than
// they do.
#pragma once

#include <gtest/gtest.h>

#include "tests/unit/goalnet/instruction_runner.h"

namespace goalnet::inference {

class InstructionFixture : public testing::Test {
 protected:
  static void SetUpTestSuite() { runner = std::make_unique<InstructionRunner>(); }
  static void TearDownTestSuite() { runner.reset(); }
  static InstructionRunner::Run follow(const std::string& room, const std::string& sentence) {
    return runner->follow(runner->room(room, ""), sentence);
  }
  static void expect_reached(const std::string& room, const std::string& sentence, const std::string& goal) {
    const auto run = follow(room, sentence);
    EXPECT_FALSE(run.refused) << sentence << ": " << run.message;
    EXPECT_TRUE(reached(goal, run.facts)) << sentence;
  }
  inline static std::unique_ptr<InstructionRunner> runner;
};

}  // namespace goalnet::inference
