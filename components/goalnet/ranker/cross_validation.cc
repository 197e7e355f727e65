#include "components/goalnet/ranker/cross_validation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "components/goalnet/random.h"
#include "components/goalnet/ranker/example.h"

namespace goalnet::inference {
namespace {

std::vector<std::string> verbs_of(const Instruction& instruction, const Language& language) {
  std::vector<bool> names(instruction.words.size(), false);
  for (const Mention& mention : instruction.mentions)
    for (int i = mention.begin; i < mention.end; ++i) names[static_cast<std::size_t>(i)] = true;
  std::vector<std::string> verbs;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i] && language.verb(instruction.words[i]) != Frame::kNone)
      verbs.push_back(instruction.words[i]);
  return verbs;
}

// Verbs to folds: in chance order, each to the fold that has the fewest demonstrations so far.
std::map<std::string, int> folds_of_verbs(const std::map<std::string, int>& count, int folds,
                                          std::uint64_t seed) {
  std::vector<std::string> verbs;
  for (const auto& [verb, of] : count) verbs.push_back(verb);
  Random random(seed);
  for (std::size_t i = verbs.size(); i > 1; --i) std::swap(verbs[i - 1], verbs[random.below(i)]);
  std::stable_sort(verbs.begin(), verbs.end(),
                   [&](const std::string& a, const std::string& b) { return count.at(a) > count.at(b); });
  std::vector<int> size(static_cast<std::size_t>(folds), 0);
  std::map<std::string, int> fold;
  for (const std::string& verb : verbs) {
    const auto smallest = std::min_element(size.begin(), size.end());
    *smallest += count.at(verb);
    fold[verb] = static_cast<int>(smallest - size.begin());
  }
  return fold;
}

std::vector<Fold> by_scenario(const std::vector<Demonstration>& demonstrations, int folds,
                              std::uint64_t seed) {
  const ScenarioFolds of(demonstrations, folds, seed);
  std::vector<Fold> result(static_cast<std::size_t>(folds));
  for (std::size_t i = 0; i < demonstrations.size(); ++i)
    for (int f = 0; f < folds; ++f) {
      Fold& fold = result[static_cast<std::size_t>(f)];
      if (of.fold_of(demonstrations[i].scenario) != f)
        fold.train.push_back(i);
      else if (!demonstrations[i].perturbed)
        fold.test.push_back(i);
    }
  return result;
}

std::vector<Fold> by_verb(const std::vector<Demonstration>& demonstrations,
                          const std::vector<std::vector<std::string>>& verbs, int folds, std::uint64_t seed) {
  std::map<std::string, int> count;
  for (std::size_t i = 0; i < verbs.size(); ++i) {
    for (const std::string& verb : verbs[i]) count.try_emplace(verb, 0);
    if (!verbs[i].empty() && !demonstrations[i].perturbed) ++count[verbs[i].front()];
  }
  const auto fold_of = folds_of_verbs(count, folds, seed);
  std::vector<Fold> result(static_cast<std::size_t>(folds));
  for (std::size_t i = 0; i < verbs.size(); ++i)
    for (int f = 0; f < folds; ++f) {
      Fold& fold = result[static_cast<std::size_t>(f)];
      if (!verbs[i].empty() && !demonstrations[i].perturbed && fold_of.at(verbs[i].front()) == f)
        fold.test.push_back(i);
      else if (std::none_of(verbs[i].begin(), verbs[i].end(),
                            [&](const std::string& verb) { return fold_of.at(verb) == f; }))
        fold.train.push_back(i);
    }
  return result;
}

Expected<FoldScores> run_fold(const std::vector<Demonstration>& demonstrations, const Fold& fold,
                              const CrossValidationOptions& options,
                              const std::function<void(double)>& progress) {
  std::vector<Demonstration> seen, unseen;
  for (const std::size_t i : fold.train) seen.push_back(demonstrations[i]);
  for (const std::size_t i : fold.test) unseen.push_back(with_sentence(demonstrations[i], options.sentences));
  TrainingOptions training = options.training;
  training.given = options.grounding, training.none = !options.grounding;
  training.progress = [&](const std::string&, double done) {
    progress(0.9 * done);
    return true;
  };
  auto parts = train(seen, training);
  if (!parts) return tl::unexpected(parts.error());
  Symbols symbols;
  const auto lexicon = Lexicon::parse(training.language.household, "language", symbols);
  if (!lexicon) return tl::unexpected(lexicon.error());
  auto model = std::make_unique<RankerModel>(std::move(*parts), ModelUse::kBenchmark);
  EvaluationOptions evaluation_options;
  evaluation_options.grounding = options.grounding;
  auto evaluation = evaluate([&]() -> Expected<std::unique_ptr<GoalModel>> { return std::move(model); },
                             unseen, *lexicon, evaluation_options);
  if (!evaluation) return tl::unexpected(evaluation.error());
  progress(1);
  return FoldScores{seen.size(), evaluation->mean, std::move(evaluation->runs)};
}

}  // namespace

Expected<std::vector<Fold>> make_folds(const std::vector<Demonstration>& demonstrations, FoldBy by, int folds,
                                       std::uint64_t seed, const LanguageTexts& language) {
  if (by == FoldBy::kScenario) return by_scenario(demonstrations, folds, seed);
  auto parts = make_parts(language, "language");
  if (!parts) return tl::unexpected(parts.error());
  std::vector<std::vector<std::string>> verbs;
  for (const Example& example :
       make_examples(demonstrations, *parts->lexicon, *parts->language, parts->symbols))
    verbs.push_back(verbs_of(example.none, *parts->language));
  return by_verb(demonstrations, verbs, folds, seed);
}

Expected<std::vector<FoldScores>> cross_validate(const std::vector<Demonstration>& demonstrations,
                                                 const std::vector<Fold>& folds,
                                                 const CrossValidationOptions& options) {
  std::vector<FoldScores> scores(folds.size());
  std::vector<double> done(folds.size(), 0);
  std::optional<Error> failure;
  std::mutex mutex;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < folds.size(); i = next++) {
      auto result = run_fold(demonstrations, folds[i], options, [&](double share) {
        const std::lock_guard lock(mutex);
        done[i] = share;
        double sum = 0;
        for (const double one : done) sum += one;
        if (options.progress) options.progress(sum / static_cast<double>(folds.size()));
      });
      const std::lock_guard lock(mutex);
      if (result)
        scores[i] = std::move(*result);
      else
        failure = result.error();
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::min<std::size_t>(options.threads, folds.size()); ++i)
    threads.emplace_back(work);
  work();
  threads.clear();  // joins
  if (failure) return tl::unexpected(*failure);
  return scores;
}

std::vector<CalibrationBin> calibration(const std::vector<FoldScores>& folds, std::size_t bins) {
  std::vector<std::pair<double, double>> runs;
  for (const FoldScores& fold : folds)
    for (const ModelRun& run : fold.runs) runs.emplace_back(run.confidence, run.scores.sji);
  std::sort(runs.begin(), runs.end());
  std::vector<CalibrationBin> result(std::min(bins, runs.size()));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CalibrationBin& bin = result[i * result.size() / runs.size()];
    bin.confidence += runs[i].first, bin.sji += runs[i].second, ++bin.runs;
  }
  for (CalibrationBin& bin : result)
    bin.confidence /= static_cast<double>(bin.runs), bin.sji /= static_cast<double>(bin.runs);
  return result;
}

double calibration_error(const std::vector<CalibrationBin>& bins) {
  double sum = 0, runs = 0;
  for (const CalibrationBin& bin : bins)
    sum += static_cast<double>(bin.runs) * std::fabs(bin.confidence - bin.sji),
        runs += static_cast<double>(bin.runs);
  return runs > 0 ? sum / runs : 0;
}

}  // namespace goalnet::inference
