// Folds keep apart what they promise to keep apart; the confidence curve; the scores of small folds.
#include "components/goalnet/ranker/cross_validation.h"

#include <gtest/gtest.h>

#include <set>

#include "components/goalnet/random.h"
#include "components/goalnet/ranker/confidence.h"
#include "tests/unit/goalnet/played.h"

namespace goalnet::inference {
namespace {

LanguageTexts language() { return {household_words(), "", ""}; }

// People who take things, by one of several verbs; every seventh says nothing but the thing.
std::vector<Demonstration> takers() {
  const char* verbs[] = {"take", "grab", "get", "lift", "hold", "fetch"};
  const std::vector<Thing> things = {{"Mug_1", "mug"}, {"Kettle", "kettle"}, {"Plate_1", "plate"}};
  std::vector<Demonstration> all;
  for (int i = 0; i < 42; ++i) {
    const Thing& thing = things[static_cast<std::size_t>(i % 3)];
    all.push_back(
        taken(things, thing, i / 2, i, i % 7 == 6 ? thing.word : verbs[i % 6] + (" the " + thing.word)));
    all.back().perturbed = i % 10 == 9;
  }
  return all;
}

TEST(Folds, TestEachScenarioOnceAndNeverTrainOnIt) {
  const auto all = takers();
  const auto folds = make_folds(all, FoldBy::kScenario, 4, 7, language());
  ASSERT_TRUE(folds);
  std::multiset<std::size_t> tested;
  for (const Fold& fold : *folds) {
    std::set<std::string> scenarios;
    for (const std::size_t i : fold.test) {
      scenarios.insert(all[i].scenario), tested.insert(i);
      EXPECT_FALSE(all[i].perturbed);
    }
    for (const std::size_t i : fold.train) EXPECT_FALSE(scenarios.contains(all[i].scenario));
  }
  EXPECT_EQ(tested.size(), 38u) << "all but the perturbed ones";
  EXPECT_EQ(std::set(tested.begin(), tested.end()).size(), tested.size());
  const auto other = make_folds(all, FoldBy::kScenario, 4, 8, language());
  EXPECT_NE(folds->front().test, other->front().test) << "the seed deals the scenarios";
}

TEST(Folds, ByVerbNeverTrainOnAVerbThatIsTested) {
  const auto all = takers();
  const auto folds = make_folds(all, FoldBy::kVerb, 3, 7, language());
  ASSERT_TRUE(folds);
  std::size_t tested = 0;
  for (const Fold& fold : *folds) {
    std::set<std::string> verbs;
    for (const std::size_t i : fold.test) {
      const std::string verb = all[i].sentence.substr(0, all[i].sentence.find(' '));
      EXPECT_NE(verb, all[i].sentence) << "a sentence without a verb is not tested";
      verbs.insert(verb);
    }
    EXPECT_FALSE(verbs.empty());
    for (const std::size_t i : fold.train)
      EXPECT_FALSE(verbs.contains(all[i].sentence.substr(0, all[i].sentence.find(' ')))) << all[i].sentence;
    tested += fold.test.size();
  }
  EXPECT_EQ(tested, 32u) << "38 that are not perturbed, of which 6 have no verb";
}

TEST(CrossValidation, GivesTheSameScoresWithAnyNumberOfThreads) {
  const auto all = takers();
  const auto folds = make_folds(all, FoldBy::kScenario, 2, 7, language());
  ASSERT_TRUE(folds);
  CrossValidationOptions options;
  options.grounding = false;
  options.training.language = language();
  options.training.ranker.training.epochs = 6;
  options.training.ranker.samples = 5;
  double last = 0;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  const auto one = cross_validate(all, *folds, options);
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_DOUBLE_EQ(last, 1);
  options.threads = 2, options.progress = {};
  const auto two = cross_validate(all, *folds, options);
  ASSERT_TRUE(two);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_EQ((*one)[f].trained_on, (*folds)[f].train.size());
    ASSERT_EQ((*one)[f].runs.size(), (*folds)[f].test.size());
    for (std::size_t i = 0; i < (*one)[f].runs.size(); ++i) {
      EXPECT_EQ((*one)[f].runs[i].actions, (*two)[f].runs[i].actions);
      EXPECT_EQ((*one)[f].runs[i].confidence, (*two)[f].runs[i].confidence);
    }
    EXPECT_GT((*one)[f].mean.sji, 0.9) << "taking what is named is not hard";
  }
}

TEST(Confidence, RisesWithWhatWasReached) {
  Random random(3);
  std::vector<Confidence::Point> pairs;
  for (int i = 0; i < 4000; ++i) {
    const float expected = random.uniform();
    pairs.emplace_back(expected, random.uniform() < expected * expected ? 1.0f : 0.0f);
  }
  const Confidence confidence = Confidence::fit(pairs);
  for (const float expected : {0.2f, 0.5f, 0.8f})
    EXPECT_NEAR(confidence(expected), expected * expected, 0.07f);
  for (float x = -0.5f; x < 1.5f; x += 0.01f) {
    EXPECT_LE(confidence(x), confidence(x + 0.01f));
    EXPECT_GE(confidence(x), 0.0f);
    EXPECT_LE(confidence(x), 1.0f);
  }
  EXPECT_EQ(Confidence()(0.3f), 0.3f) << "not fitted: what it is told";
}

TEST(Calibration, MeasuresTheDistanceFromTheScore) {
  FoldScores fold;
  for (int i = 0; i < 100; ++i) {
    ModelRun run;
    run.confidence = i < 50 ? 0.2 : 0.8;
    run.scores.sji = i < 50 ? 0.3 : 0.8;
    fold.runs.push_back(run);
  }
  EXPECT_NEAR(calibration_error(calibration({fold})), 0.05, 1e-9);
  EXPECT_EQ(calibration_error(calibration({})), 0);
}

}  // namespace
}  // namespace goalnet::inference
