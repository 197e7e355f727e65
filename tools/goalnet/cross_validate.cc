#include "tools/goalnet/cross_validate.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "components/goalnet/other_sentences.h"
#include "components/goalnet/ranker/cross_validation.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/progress_line.h"
#include "tools/goalnet/scenario_halves.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

constexpr std::pair<const char*, double Scores::*> kColumns[] = {{"sji", &Scores::sji},
                                                                 {"ied", &Scores::ied},
                                                                 {"f1", &Scores::f1},
                                                                 {"grr", &Scores::grr},
                                                                 {"grr_formula", &Scores::grr_formula},
                                                                 {"exact", &Scores::exact},
                                                                 {"ied_canonical", &Scores::ied_canonical}};

// Over all demonstrations, and how far the folds lie from one another.
struct Summary {
  double mean = 0, deviation = 0;  // standard deviation of the folds' means
};

Summary summarize(const std::vector<FoldScores>& folds, double Scores::*score) {
  Summary summary;
  double runs = 0, sum = 0, squares = 0;
  for (const FoldScores& fold : folds) {
    for (const ModelRun& run : fold.runs) summary.mean += run.scores.*score;
    runs += static_cast<double>(fold.runs.size());
    sum += fold.mean.*score;
    squares += fold.mean.*score * fold.mean.*score;
  }
  const auto n = static_cast<double>(folds.size());
  summary.mean /= std::max(1.0, runs);
  if (n > 1) summary.deviation = std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1)));
  return summary;
}

std::vector<ModelRun> all_runs(const std::vector<FoldScores>& folds) {
  std::vector<ModelRun> runs;
  for (const FoldScores& fold : folds) runs.insert(runs.end(), fold.runs.begin(), fold.runs.end());
  return runs;
}

void print(const CrossValidateRequest& request, const std::vector<FoldScores>& folds, double seconds) {
  std::size_t count = 0;
  for (const FoldScores& fold : folds) count += fold.runs.size();
  const auto bins = calibration(folds);
  if (request.json) {
    nlohmann::json object = {{"by", request.by},      {"grounding", request.grounding},
                             {"folds", folds.size()}, {"seed", request.seed},
                             {"count", count},        {"seconds", seconds}};
    for (const auto& [name, score] : kColumns) {
      const Summary summary = summarize(folds, score);
      object[name] = {{"mean", summary.mean}, {"deviation", summary.deviation}};
    }
    if (!request.sentences.empty()) object["sentences"] = request.sentences;
    add_halves(object, all_runs(folds));
    object["calibration_error"] = calibration_error(bins);
    for (const CalibrationBin& bin : bins)
      object["calibration"].push_back({{"confidence", bin.confidence}, {"sji", bin.sji}, {"runs", bin.runs}});
    print_json(object);
    return;
  }
  std::printf("%zu folds by %s (seed %llu), %zu demonstrations, grounding %s%s%s, %.0f s\n", folds.size(),
              request.by.c_str(), static_cast<unsigned long long>(request.seed), count,
              request.grounding.c_str(), request.sentences.empty() ? "" : ", sentences of ",
              request.sentences.c_str(), seconds);
  for (const FoldScores& fold : folds)
    std::printf("  trained on %zu, tested on %zu: SJI %.3f  IED %.3f  F1 %.3f  GRR %.3f\n", fold.trained_on,
                fold.runs.size(), fold.mean.sji, fold.mean.ied, fold.mean.f1, fold.mean.grr);
  for (const auto& [name, score] : kColumns) {
    const Summary summary = summarize(folds, score);
    std::printf("%-13s %.3f +- %.3f\n", name, summary.mean, summary.deviation);
  }
  print_halves(all_runs(folds));
  std::printf("confidence against SJI, tenths of the runs:");
  for (const CalibrationBin& bin : bins) std::printf("  %.2f/%.2f", bin.confidence, bin.sji);
  std::printf("\ncalibration error %.3f\n", calibration_error(bins));
}

}  // namespace

int cross_validate(const CrossValidateRequest& request) {
  const auto report = [&](const Error& error) { return tell("goalnet eval", error, request.json); };
  if (!request.runs.empty())
    if (const auto writable = write_runs({}, request.runs); !writable) return report(writable.error());
  const auto demonstrations = read_demonstrations(request.folder);
  if (!demonstrations) return report(demonstrations.error());
  const auto language = read_language_texts();
  if (!language) return report(language.error());
  auto folds = make_folds(*demonstrations, request.by == "verb" ? FoldBy::kVerb : FoldBy::kScenario,
                          request.folds, request.seed, *language);
  if (!folds) return report(folds.error());
  if (request.only > 0 && request.only < request.folds) folds->resize(static_cast<std::size_t>(request.only));
  OtherSentences sentences;
  if (!request.sentences.empty()) {
    auto read = read_other_sentences(request.sentences);
    if (!read) return report(read.error());
    if (const auto fits = check_other_sentences(*read, *demonstrations); !fits) return report(fits.error());
    if (const std::size_t left = count_left_out(*read, *demonstrations); left > 0 && !request.json)
      std::printf("%zu demonstrations have no sentence in %s and are not tested\n", left,
                  request.sentences.c_str());
    sentences = std::move(*read);
    for (Fold& fold : *folds)
      std::erase_if(fold.test, [&](std::size_t i) { return !sentences.contains((*demonstrations)[i].id); });
    std::erase_if(*folds, [](const Fold& fold) { return fold.test.empty(); });  // nothing to train for
    if (folds->empty())
      return report({Outcome::kInvalidRequest,
                     request.sentences + ": has no sentence for what the folds by " + request.by + " test"});
  }
  for (const Fold& fold : *folds)
    if (fold.train.empty() || fold.test.empty())
      return report({Outcome::kInvalidRequest, request.folder + ": too few demonstrations for " +
                                                   std::to_string(request.folds) + " folds by " +
                                                   request.by});
  CrossValidationOptions options;
  options.grounding = request.grounding == "given";
  options.threads = request.threads;
  options.training.language = *language;
  options.sentences = sentences;
  ProgressLine progress(std::chrono::seconds(30));
  if (!request.json) options.progress = [&](double done) { progress.show(done); };
  const auto scores = inference::cross_validate(*demonstrations, *folds, options);
  if (!scores) return report(scores.error());
  if (!request.json) progress.finish();
  if (!request.runs.empty())
    if (const auto written = write_runs(all_runs(*scores), request.runs); !written)
      return report(written.error());
  print(request, *scores, progress.seconds());
  return 0;
}

}  // namespace goalnet::tools
