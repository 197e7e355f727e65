#include "components/goalnet/ranker/boosted_trees.h"

#include <gtest/gtest.h>

#include "components/goalnet/random.h"

namespace goalnet::inference {
namespace {

TEST(BoostedTrees, LearnAStepAndAnInteraction) {
  Random random(3);
  std::vector<float> rows, targets;
  for (int i = 0; i < 2000; ++i) {
    const float a = random.uniform(), b = random.uniform(), c = random.uniform();
    rows.insert(rows.end(), {a, b, c});
    targets.push_back((a > 0.5f) == (b > 0.3f) ? 1.0f : 0.0f);
  }
  const auto trees = BoostedTrees::train(rows, 3, targets, {});
  EXPECT_GT(trees.predict(std::vector<float>{0.9f, 0.9f, 0.5f}), 0.8f);
  EXPECT_LT(trees.predict(std::vector<float>{0.9f, 0.1f, 0.5f}), 0.2f);
  const auto again = BoostedTrees::train(rows, 3, targets, {});
  EXPECT_EQ(trees.predict(std::vector<float>{0.2f, 0.6f, 0.1f}),
            again.predict(std::vector<float>{0.2f, 0.6f, 0.1f}));
}

TEST(BoostedTrees, ABagIsTheMeanOfItsMembers) {
  Random random(4);
  std::vector<float> rows, targets;
  for (int i = 0; i < 500; ++i) {
    rows.insert(rows.end(), {random.uniform(), random.uniform()});
    targets.push_back(rows[rows.size() - 2] + 0.3f * random.uniform());
  }
  BoostOptions options;
  options.trees = 20;
  const auto bag = BoostedTrees::train_bag(rows, 2, targets, options, 2);
  const auto first = BoostedTrees::train(rows, 2, targets, options);
  options.seed += 1;
  const auto second = BoostedTrees::train(rows, 2, targets, options);
  const std::vector<float> row = {0.7f, 0.2f};
  EXPECT_NE(first.predict(row), second.predict(row));
  EXPECT_NEAR(bag.predict(row), (first.predict(row) + second.predict(row)) / 2, 1e-5f);
}

TEST(BoostedTrees, RefuseTreesThatWouldNotEnd) {
  BoostedTrees trees;
  EXPECT_TRUE(trees.assign({{-1, 0.5f, 0, 0}}, {0}, 3));
  EXPECT_FALSE(trees.assign({{0, 0.5f, 0, 0}}, {0}, 3)) << "a node that is its own child";
  EXPECT_FALSE(trees.assign({{0, 0.5f, 1, 9}, {-1, 0, 0, 0}}, {0}, 3)) << "a child outside";
  EXPECT_FALSE(trees.assign({{7, 0.5f, 1, 2}, {-1, 0, 0, 0}, {-1, 0, 0, 0}}, {0}, 3)) << "a feature outside";
  EXPECT_FALSE(trees.assign({}, {0}, 3)) << "a root outside";
  EXPECT_EQ(trees.predict(std::vector<float>{1, 1, 1}), 0.5f) << "the good trees stay";
}

}  // namespace
}  // namespace goalnet::inference
