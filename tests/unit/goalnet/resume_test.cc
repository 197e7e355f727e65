// A training that was stopped goes on from its checkpoint and ends with the same model, byte by byte.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "components/goalnet/ranker/train.h"
#include "tests/unit/goalnet/played.h"

namespace goalnet::inference {
namespace {

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// People who take one of two things.
std::vector<Demonstration> mug_or_kettle() {
  const std::vector<Thing> things = {{"Mug_1", "mug"}, {"Kettle", "kettle"}};
  std::vector<Demonstration> all;
  for (int i = 0; i < 24; ++i) {
    const Thing& thing = things[i % 3 != 0 ? 0 : 1];
    all.push_back(taken(things, thing, i / 2, i, (i % 2 == 0 ? "take the " : "grab the ") + thing.word));
  }
  return all;
}

class Resume : public testing::Test {
 protected:
  void SetUp() override {
    // A folder of this process's own: tests run at the same time.
    std::string name = testing::TempDir() + "goalnet_resume_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    options_.language.household = household_words();
    options_.ranker.training.epochs = 3;
    options_.ranker.samples = 5;
    options_.checkpoint = path("checkpoint");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::string bytes_of(const RankerParts& parts) const {
    EXPECT_TRUE(write_ranker(parts, path("model")));
    return content(path("model"));
  }

  std::filesystem::path folder_;
  TrainingOptions options_;
};

TEST_F(Resume, GivesTheSameModelWhereverItWasStopped) {
  TrainingOptions once = options_;
  once.checkpoint.clear();
  const auto whole = train(mug_or_kettle(), once);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_FALSE(whole->given.reranker.empty()) << "a training without trees would test little";
  // Each attempt is stopped a little later than the one before: in a policy, in pools, in the trees.
  std::vector<double> begins;
  for (double until = 0.02; until < 1; until += 0.07) {
    double first = -1;
    options_.progress = [&](const std::string&, double done) {
      if (first < 0) first = done;
      return done < until;
    };
    const auto stopped = train(mug_or_kettle(), options_);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().outcome, Outcome::kCancelled);
    begins.push_back(first);
  }
  EXPECT_LT(begins.front(), 0.1);
  EXPECT_GT(begins.back(), 0.4)
      << "what was computed is not computed again (but for the trees, which are quick)";
  options_.progress = {};
  const auto resumed = train(mug_or_kettle(), options_);
  ASSERT_TRUE(resumed) << resumed.error().message;
  EXPECT_TRUE(bytes_of(*resumed) == bytes_of(*whole));
}

TEST_F(Resume, RefusesTheCheckpointOfAnotherTraining) {
  options_.progress = [](const std::string&, double done) { return done < 0.3; };
  ASSERT_FALSE(train(mug_or_kettle(), options_));
  ASSERT_TRUE(std::filesystem::exists(options_.checkpoint));
  auto others = mug_or_kettle();
  others.pop_back();
  auto other = options_;
  other.ranker.training.seed = 2;
  for (const auto& result : {train(others, options_), train(mug_or_kettle(), other)}) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().outcome, Outcome::kInvalidRequest);
    EXPECT_NE(result.error().message.find("another training"), std::string::npos) << result.error().message;
  }
}

TEST_F(Resume, SaysThatACheckpointIsDamaged) {
  options_.progress = [](const std::string&, double done) { return done < 0.3; };
  ASSERT_FALSE(train(mug_or_kettle(), options_));
  const std::string good = content(options_.checkpoint);
  ASSERT_GT(good.size(), 100u);
  std::ofstream(options_.checkpoint, std::ios::binary | std::ios::trunc) << good.substr(0, good.size() - 40);
  const auto result = train(mug_or_kettle(), options_);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().outcome, Outcome::kInvalidRequest);
  EXPECT_NE(result.error().message.find("--fresh"), std::string::npos) << result.error().message;
}

}  // namespace
}  // namespace goalnet::inference
