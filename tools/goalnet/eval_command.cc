#include "tools/goalnet/eval_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "components/core/config_path.h"
#include "components/goalnet/evaluation.h"
#include "components/goalnet/other_sentences.h"
#include "tools/goalnet/command.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/cross_validate.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

nlohmann::json to_json(const Scores& scores) {
  return {{"sji", scores.sji},
          {"ied", scores.ied},
          {"f1", scores.f1},
          {"grr", scores.grr},
          {"grr_formula", scores.grr_formula},
          {"exact", scores.exact},
          {"ied_canonical", scores.ied_canonical}};
}

struct EvalRequest {
  std::string folder, model = config_path("models/goalnet.safetensors"), grounding = "given", runs, sentences;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool json = false, perturbed = false;
  std::string cross_validate_by;  // empty: scores the model file
  CrossValidateRequest validation;
};

void add_options(CLI::App& app, EvalRequest& request) {
  app.footer(
      "Examples:\n"
      "  goalnet eval demonstrations --grounding none --runs runs.jsonl\n"
      "  goalnet eval demonstrations --cross-validate scenario --fold-seed 7 --json\n"
      "  goalnet eval demonstrations --cross-validate scenario --sentences paraphrases.tsv\n"
      "  goalnet eval demonstrations --physics --limit 20");
  app.add_option("DIR", request.folder, "folder of demonstrations (*.json)")->required();
  app.add_option("--model", request.model, "model file")->capture_default_str();
  app.add_option("--grounding", request.grounding,
                 "given: pass the demonstrations' grounding; none: sentence and state only")
      ->check(CLI::IsMember({"given", "none"}))
      ->capture_default_str();
  app.add_option("--runs", request.runs,
                 "write every run to this file, one JSON object a line (for score.py)");
  app.add_option(
      "--sentences", request.sentences,
      "test with other sentences: a table of file name of a demonstration, tab, sentence. Only what "
      "it names is tested; training hears the recorded ones");
  app.add_option("--threads", request.threads, "worker threads")
      ->check(CLI::Range(1u, 256u))
      ->capture_default_str();
  app.add_flag("--include-perturbed", request.perturbed, "score the randomly perturbed a_* files too");
  app.add_flag("--physics")
      ->description("carry them out in the simulated room instead (--physics --help tells more)");
  app.add_flag("--json", request.json, "print one JSON object");
  app.add_option("--cross-validate", request.cross_validate_by,
                 "score no model file, but models trained anew without the tested scenarios (or verbs)")
      ->check(CLI::IsMember({"scenario", "verb"}));
  app.add_option("--folds", request.validation.folds, "folds of the cross-validation")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--only-folds", request.validation.only, "run only so many of them; 0: all")
      ->check(CLI::Range(0, 1000));
  app.add_option("--fold-seed", request.validation.seed, "how scenarios or verbs are dealt to the folds")
      ->capture_default_str();
}

CrossValidateRequest validation_of(const EvalRequest& request) {
  CrossValidateRequest validation = request.validation;
  validation.folder = request.folder, validation.by = request.cross_validate_by;
  validation.grounding = request.grounding, validation.runs = request.runs;
  validation.sentences = request.sentences;
  validation.threads = request.threads, validation.json = request.json;
  return validation;
}

// Those of the folder that are asked for, with the sentences that are asked for.
Expected<std::vector<Demonstration>> demonstrations_of(const EvalRequest& request) {
  auto demonstrations = read_demonstrations(request.folder);
  if (!demonstrations) return demonstrations;
  if (!request.sentences.empty()) {
    const auto others = read_other_sentences(request.sentences);
    if (!others) return tl::unexpected(others.error());
    if (const auto fits = check_other_sentences(*others, *demonstrations); !fits)
      return tl::unexpected(fits.error());
    if (const std::size_t left = count_left_out(*others, *demonstrations); left > 0 && !request.json)
      std::printf("%zu demonstrations have no sentence in %s and are not tested\n", left,
                  request.sentences.c_str());
    std::erase_if(*demonstrations, [&](const Demonstration& d) { return !others->contains(d.id); });
    for (Demonstration& demonstration : *demonstrations)
      demonstration = with_sentence(std::move(demonstration), *others);
  }
  if (!request.perturbed) std::erase_if(*demonstrations, [](const Demonstration& d) { return d.perturbed; });
  if (demonstrations->empty())
    return fail(Outcome::kInvalidRequest, request.folder + ": holds only perturbed demonstrations");
  return demonstrations;
}

void print(const Evaluation& evaluation, const EvalRequest& request, double seconds) {
  std::size_t refused = 0;
  for (const ModelRun& run : evaluation.runs) refused += !run.refusal.empty();
  if (request.json) {
    nlohmann::json object = to_json(evaluation.mean);
    object["count"] = evaluation.runs.size();
    object["refused"] = refused;
    object["grounding"] = request.grounding;
    if (!request.sentences.empty()) object["sentences"] = request.sentences;
    object["model"] = request.model;
    object["seconds"] = seconds;
    print_json(object);
    return;
  }
  const Scores& s = evaluation.mean;
  std::printf("%zu demonstrations, grounding %s, %.1f s\n", evaluation.runs.size(), request.grounding.c_str(),
              seconds);
  std::printf("SJI %.3f  IED %.3f  F1 %.3f  GRR %.3f   (grr_formula %.3f, exact %.3f, ied_canonical %.3f)\n",
              s.sji, s.ied, s.f1, s.grr, s.grr_formula, s.exact, s.ied_canonical);
  if (refused > 0) std::printf("%zu refused\n", refused);
}

}  // namespace

int eval_command(int argc, char** argv) {
  // Physics lives in another program, with options of its own.
  if (std::find(argv + 1, argv + argc, std::string_view("--physics")) != argv + argc)
    return become("goalnet-robot", "eval", argc, argv);
  CLI::App app("Scores a goal model on a folder of demonstrations.", "goalnet eval");
  EvalRequest request;
  add_options(app, request);
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  if (!request.cross_validate_by.empty()) return cross_validate(validation_of(request));
  const auto report = [&](const Error& error) { return tell(app.get_name(), error, request.json); };
  const auto demonstrations = demonstrations_of(request);
  if (!demonstrations) return report(demonstrations.error());
  Symbols symbols;
  const auto lexicon = Lexicon::load(config_path("language/household.json"), symbols);
  if (!lexicon) return report(lexicon.error());
  // Before the work, not after it.
  if (!request.runs.empty())
    if (const auto writable = write_runs({}, request.runs); !writable) return report(writable.error());

  EvaluationOptions options;
  options.grounding = request.grounding == "given";
  options.threads = request.threads;
  const bool show = !request.json && isatty(STDERR_FILENO) != 0;
  if (show)
    options.progress = [](std::size_t done, std::size_t all) {
      std::fprintf(stderr, "\r%zu of %zu", done, all);
    };
  const auto begin = std::chrono::steady_clock::now();
  const auto evaluation = evaluate([&] { return load_model(request.model, ModelUse::kBenchmark); },
                                   *demonstrations, *lexicon, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (show) std::fprintf(stderr, "\n");
  if (!evaluation) return report(evaluation.error());
  if (!request.runs.empty())
    if (const auto written = write_runs(evaluation->runs, request.runs); !written)
      return report(written.error());
  print(*evaluation, request, seconds);
  return 0;
}

}  // namespace goalnet::tools
