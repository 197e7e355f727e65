#include "components/goalnet/ranker/reranker.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "components/goalnet/evaluation.h"

namespace goalnet::inference {
namespace {

constexpr int kFolds = 5;

Agreement weighted(const std::vector<CandidateRun>& pool, std::size_t run, float CandidateRun::*weight) {
  Agreement sum;
  float total = 1e-9f;
  for (const CandidateRun& truth : pool) {
    const float w = truth.*weight;
    if (w <= 0) continue;
    const Agreement one = agreement(pool[run], truth);
    total += w;
    sum.sji += w * one.sji, sum.f1 += w * one.f1, sum.ied += w * one.ied, sum.grr += w * one.grr;
  }
  sum.sji /= total, sum.f1 /= total, sum.ied /= total, sum.grr /= total;
  return sum;
}

}  // namespace

std::vector<RunFeatures> run_features(const std::vector<CandidateRun>& pool, const Instruction& instruction,
                                      const SymState& start, const CandidateRun& reading, bool complete) {
  std::vector<RunFeatures> rows(pool.size());
  float best = 0, held_at_start = 0;
  std::vector<Agreement> all(pool.size());
  for (std::size_t i = 0; i < pool.size(); ++i) {
    all[i] = weighted(pool, i, &CandidateRun::weight);
    best = std::max(best, all[i].mean());
  }
  for (const SymFact fact : start.facts()) held_at_start += relation_of(fact) == Relation::kGrasping;
  std::set<int> named_mentions;
  for (const SeenObject& object : instruction.objects)
    if (object.mention >= 0 && object.level >= NameLevel::kName) named_mentions.insert(object.mention);

  for (std::size_t i = 0; i < pool.size(); ++i) {
    const CandidateRun& run = pool[i];
    RunFeatures& row = rows[i];
    row.fill(0);
    std::size_t column = 0;
    const auto put = [&](double value) { row[column++] = static_cast<float>(value); };
    const Agreement sampled = weighted(pool, i, &CandidateRun::sampled);
    const Agreement replayed = weighted(pool, i, &CandidateRun::replayed);
    for (const Agreement& a : {all[i], sampled, replayed})
      put(a.sji), put(a.f1), put(a.ied), put(a.grr), put(a.mean());
    put(all[i].mean() - best);
    put(best);
    put(run.weight), put(run.sampled), put(run.replayed), put(i == 0);
    put(run.log_probability);
    put(run.log_probability / static_cast<float>(run.macros.size() + 1));
    put(static_cast<double>(run.macros.size()));
    put(static_cast<double>(run.actions.size()));
    put(static_cast<double>(run.change.added.size() + run.change.removed.size()));

    std::set<int> handled;
    std::set<Symbol> touched;
    float unnamed = 0, named = 0;
    std::array<float, kVerbs> verbs{};
    for (const SymAction& action : run.macros) {
      ++verbs[static_cast<std::size_t>(action.verb)];
      for (const Symbol symbol : {action.x, action.y}) {
        const int found = instruction.find(symbol);
        if (found < 0 || !touched.insert(symbol).second) continue;
        const SeenObject& object = instruction.objects[static_cast<std::size_t>(found)];
        if (object.mention >= 0) handled.insert(object.mention);
        (object.mention >= 0 ? named : unnamed) += 1;
      }
    }
    float left_out = 0;
    for (const int mention : named_mentions) left_out += !handled.contains(mention);
    put(unnamed), put(named), put(left_out), put(static_cast<double>(named_mentions.size()));
    const Agreement read = agreement(run, reading);
    put(read.sji), put(read.ied), put(read.grr), put(agreement(reading, run).grr), put(complete),
        put(!reading.actions.empty());
    float held_at_end = 0;
    for (const SymFact fact : run.end.facts()) held_at_end += relation_of(fact) == Relation::kGrasping;
    put(held_at_start), put(held_at_end);
    put(static_cast<double>(instruction.words.size()));
    for (const Verb verb : {Verb::kMoveTo, Verb::kGrasp, Verb::kRelease, Verb::kKeepOn, Verb::kTurn,
                            Verb::kOpen, Verb::kClose, Verb::kPress})
      put(verbs[static_cast<std::size_t>(verb)]);
    put(run.macros.empty() ? 0 : static_cast<double>(run.macros.back().verb));
  }
  return rows;
}

std::size_t choose_run(const BoostedTrees& trees, const std::vector<CandidateRun>& pool,
                       const std::vector<RunFeatures>& features) {
  constexpr float kSharpness = 15;  // chosen by cross-validation among 8, 15 and 30
  std::vector<float> weight(pool.size());
  for (std::size_t i = 0; i < pool.size(); ++i)
    weight[i] = pool[i].weight * (trees.empty() ? 1.0f : std::exp(kSharpness * trees.predict(features[i])));
  std::size_t best = 0;
  float most = -1;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    float value = 0;
    for (std::size_t j = 0; j < pool.size(); ++j) value += weight[j] * agreement(pool[i], pool[j]).mean();
    if (value > most) most = value, best = i;
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

BoostedTrees train_reranker(const std::vector<const Example*>& examples, const Lexicon& lexicon,
                            bool grounding, const RankerOptions& options, const Reader& reader,
                            const std::function<bool(double)>& progress) {
  std::set<std::string> scenarios;
  for (const Example* example : examples) scenarios.insert(example->scenario);
  const ScenarioFolds folds(scenarios, kFolds, 11);
  std::vector<float> rows, targets;
  for (int fold = 0; fold < kFolds; ++fold) {
    std::vector<const Example*> seen, unseen;
    for (const Example* example : examples) {
      if (folds.fold_of(example->scenario) != fold)
        seen.push_back(example);
      else if (!example->perturbed)
        unseen.push_back(example);
    }
    const Ranker ranker = train_ranker(seen, lexicon, grounding, options);
    for (const Example* example : unseen) {
      const Instruction& instruction = grounding ? example->given : example->none;
      const SymState& start = example->states.front();
      const auto pool = propose(ranker, lexicon, instruction, start, hash_text(example->id));
      const auto [reading, complete] = reader(instruction, start);
      const auto features = run_features(pool, instruction, start, reading, complete);
      const CandidateRun truth = demonstrated_run(*example);
      std::vector<float> scores;
      float mean = 0;
      for (const CandidateRun& run : pool) scores.push_back(agreement(run, truth).mean());
      for (const float score : scores) mean += score / static_cast<float>(scores.size());
      // What counts is which run of a pool is better, not which pool is easier.
      for (std::size_t i = 0; i < pool.size(); ++i) {
        rows.insert(rows.end(), features[i].begin(), features[i].end());
        targets.push_back(scores[i] - mean);
      }
    }
    if (progress && !progress((fold + 1.0) / (kFolds + 1))) return {};
  }
  return BoostedTrees::train(rows, kRunFeatures, targets, BoostOptions{});
}

}  // namespace goalnet::inference
