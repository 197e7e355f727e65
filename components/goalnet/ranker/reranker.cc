#include "components/goalnet/ranker/reranker.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "components/goalnet/evaluation.h"

namespace goalnet::inference {
namespace {

constexpr int kFolds = 5;

}  // namespace

Choice choose_run(const BoostedTrees& trees, const std::vector<CandidateRun>& pool,
                  const AgreementTable& table, const std::vector<RunFeatures>& features) {
  constexpr float kSharpness = 15;  // chosen by cross-validation among 8, 15 and 30
  std::vector<float> weight(pool.size());
  float total = 1e-9f;
  const std::span<const float> rows(features.empty() ? nullptr : features.front().data(),
                                    features.size() * kRunFeatures);
  const std::vector<float> predicted =
      trees.empty() ? std::vector<float>(pool.size(), 0.0f) : trees.predict(rows, kRunFeatures);
  for (std::size_t i = 0; i < pool.size(); ++i) {
    weight[i] = pool[i].weight * std::exp(kSharpness * predicted[i]);
    total += weight[i];
  }
  Choice best;
  float most = -1;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    float value = 0, sji = 0;
    for (std::size_t j = 0; j < pool.size(); ++j)
      value += weight[j] * table(i, j).mean(), sji += weight[j] * table(i, j).sji;
    if (value > most) most = value, best = {i, sji / total};
  }
  return best;
}

CandidateRun demonstrated_run(const Example& example) {
  CandidateRun truth;
  truth.end = example.states.back();
  truth.change = delta(example.states.front(), example.states.back());
  truth.actions = example.actions;
  return truth;
}

namespace {

// A pool for a demonstration that its ranker had not seen, and how each run of it would have scored.
struct UnseenPool {
  int fold = 0;
  std::vector<CandidateRun> pool;
  std::vector<RunFeatures> features;
  std::vector<Agreement> scores;
};

std::vector<UnseenPool> pools_of_fold(const std::vector<const Example*>& examples, const ScenarioFolds& folds,
                                      int fold, const Lexicon& lexicon, bool grounding,
                                      const RankerOptions& options) {
  std::vector<const Example*> seen, unseen;
  for (const Example* example : examples) {
    if (folds.fold_of(example->scenario) != fold)
      seen.push_back(example);
    else if (!example->perturbed)
      unseen.push_back(example);
  }
  const Ranker ranker = train_ranker(seen, lexicon, grounding, options);
  std::vector<UnseenPool> pools;
  for (const Example* example : unseen) {
    const Instruction& instruction = grounding ? example->given : example->none;
    const SymState& start = example->states.front();
    const Reading& reading = grounding ? example->read_given : example->read_none;
    auto [pool, hints] = propose(ranker, lexicon, instruction, reading, start, hash_text(example->id));
    UnseenPool unseen_pool;
    unseen_pool.fold = fold;
    unseen_pool.features = run_features(pool, AgreementTable(pool), instruction, start, hints);
    const CandidateRun truth = demonstrated_run(*example);
    for (const CandidateRun& run : pool) unseen_pool.scores.push_back(agreement(run, truth));
    unseen_pool.pool = std::move(pool);
    pools.push_back(std::move(unseen_pool));
  }
  return pools;
}

// Trees that learn from all pools but those of one fold (-1: from all).
BoostedTrees fit(const std::vector<UnseenPool>& pools, int without_fold, int bag) {
  std::vector<float> rows, targets;
  for (const UnseenPool& pool : pools) {
    if (pool.fold == without_fold) continue;
    for (std::size_t i = 0; i < pool.pool.size(); ++i) {
      rows.insert(rows.end(), pool.features[i].begin(), pool.features[i].end());
      targets.push_back(pool.scores[i].mean());
    }
  }
  return BoostedTrees::train_bag(rows, kRunFeatures, targets, BoostOptions{}, bag);
}

}  // namespace

Reranker train_reranker(const std::vector<const Example*>& examples, const Lexicon& lexicon, bool grounding,
                        const RankerOptions& options, const std::function<bool(double)>& progress) {
  constexpr int kBag = 2;
  std::set<std::string> scenarios;
  for (const Example* example : examples) scenarios.insert(example->scenario);
  const ScenarioFolds folds(scenarios, kFolds, 11);
  std::vector<UnseenPool> pools;
  for (int fold = 0; fold < kFolds; ++fold) {
    auto more = pools_of_fold(examples, folds, fold, lexicon, grounding, options);
    std::move(more.begin(), more.end(), std::back_inserter(pools));
    if (progress && !progress(0.8 * (fold + 1.0) / kFolds)) return {};
  }
  std::vector<Confidence::Point> reached;
  for (int fold = 0; fold < kFolds; ++fold) {
    const BoostedTrees trees = fit(pools, fold, 1);
    for (const UnseenPool& pool : pools) {
      if (pool.fold != fold) continue;
      const Choice choice = choose_run(trees, pool.pool, AgreementTable(pool.pool), pool.features);
      reached.emplace_back(choice.expected, pool.scores[choice.run].sji);
    }
    if (progress && !progress(0.8 + 0.15 * (fold + 1.0) / kFolds)) return {};
  }
  return {fit(pools, -1, kBag), Confidence::fit(std::move(reached))};
}

}  // namespace goalnet::inference
