#include "components/goalnet/ranker/reranker.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "components/goalnet/evaluation.h"
#include "components/goalnet/ranker/improve_run.h"
#include "components/goalnet/ranker/unseen_pools.h"

namespace goalnet::inference {
namespace {

constexpr int kFolds = 5;

}  // namespace

Choice choose_run(const BoostedTrees& trees, const std::vector<CandidateRun>& pool,
                  const AgreementTable& table, const std::vector<RunFeatures>& features,
                  const SymState& start) {
  constexpr float kPower = 0.7f, kSharpness = 6;  // docs/design/050
  std::vector<float> belief(pool.size());
  float total = 1e-9f;
  const std::span<const float> rows(features.empty() ? nullptr : features.front().data(),
                                    features.size() * kRunFeatures);
  const std::vector<float> predicted =
      trees.empty() ? std::vector<float>(pool.size(), 0.0f) : trees.predict(rows, kRunFeatures);
  for (std::size_t i = 0; i < pool.size(); ++i)
    total += belief[i] = std::pow(pool[i].weight, kPower) * std::exp(kSharpness * predicted[i]);
  for (float& share : belief) share /= total;
  std::size_t best = 0;
  float most = -1;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    float value = 0;
    for (std::size_t j = 0; j < pool.size(); ++j) value += belief[j] * worth(table(i, j));
    if (value > most) most = value, best = i;
  }
  Choice choice{improve(pool[best], pool, belief, start), 0};
  choice.expected = expected_sji(choice.run, pool, belief);
  return choice;
}

namespace {

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

Expected<Reranker> train_reranker(const std::vector<const Example*>& examples, const Lexicon& lexicon,
                                  bool grounding, const RankerOptions& options, Checkpoint& checkpoint,
                                  const std::function<bool(double)>& progress) {
  constexpr int kBag = 3;
  constexpr double kPools = 0.8, kTrees = 0.15;  // shares of the time; the rest is the last trees'
  const Error cancelled{Outcome::kCancelled, "training was stopped"};
  std::set<std::string> scenarios;
  for (const Example* example : examples) scenarios.insert(example->scenario);
  const ScenarioFolds folds(scenarios, kFolds, 11);
  std::vector<UnseenPool> pools;
  for (int fold = 0; fold < kFolds; ++fold) {
    std::vector<const Example*> seen, unseen;
    for (const Example* example : examples) {
      if (folds.fold_of(example->scenario) != fold)
        seen.push_back(example);
      else if (!example->perturbed)
        unseen.push_back(example);
    }
    const std::string stage =
        std::string(grounding ? "given" : "none") + ".pools." + std::to_string(fold + 1);
    auto more =
        unseen_pools(seen, unseen, fold, lexicon, grounding, options, checkpoint, stage,
                     [&](double part) { return !progress || progress(kPools * (fold + part) / kFolds); });
    if (!more) return tl::unexpected(more.error());
    std::move(more->begin(), more->end(), std::back_inserter(pools));
  }
  std::vector<Confidence::Point> reached;
  for (int fold = 0; fold < kFolds; ++fold) {
    const BoostedTrees trees = fit(pools, fold, 1);
    for (const UnseenPool& pool : pools) {
      if (pool.fold != fold) continue;
      const Choice choice =
          choose_run(trees, pool.pool, AgreementTable(pool.pool), pool.features, pool.start);
      reached.emplace_back(choice.expected, agreement(choice.run, pool.truth).sji);
    }
    if (progress && !progress(kPools + kTrees * (fold + 1.0) / kFolds)) return tl::unexpected(cancelled);
  }
  return Reranker{fit(pools, -1, kBag), Confidence::fit(std::move(reached))};
}

}  // namespace goalnet::inference
