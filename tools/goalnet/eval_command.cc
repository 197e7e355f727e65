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

}  // namespace

int eval_command(int argc, char** argv) {
  // Physics lives in another program, with options of its own.
  if (std::find(argv + 1, argv + argc, std::string_view("--physics")) != argv + argc)
    return become("goalnet-robot", "eval", argc, argv);
  CLI::App app("Scores a goal model on a folder of demonstrations.", "goalnet eval");
  std::string folder, model = config_path("models/goalnet.safetensors"), grounding = "given", runs, sentences;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool json = false, perturbed = false;
  app.footer(
      "Examples:\n"
      "  goalnet eval demonstrations --grounding none --runs runs.jsonl\n"
      "  goalnet eval demonstrations --cross-validate scenario --fold-seed 7 --json\n"
      "  goalnet eval demonstrations --cross-validate scenario --sentences paraphrases.tsv\n"
      "  goalnet eval demonstrations --physics --limit 20");
  app.add_option("DIR", folder, "folder of demonstrations (*.json)")->required();
  app.add_option("--model", model, "model file")->capture_default_str();
  app.add_option("--grounding", grounding,
                 "given: pass the demonstrations' grounding; none: sentence and state only")
      ->check(CLI::IsMember({"given", "none"}))
      ->capture_default_str();
  app.add_option("--runs", runs, "write every run to this file, one JSON object a line (for score.py)");
  app.add_option(
      "--sentences", sentences,
      "test with other sentences: a table of file name of a demonstration, tab, sentence. Only what "
      "it names is tested; training hears the recorded ones");
  app.add_option("--threads", threads, "worker threads")->check(CLI::Range(1u, 256u))->capture_default_str();
  app.add_flag("--include-perturbed", perturbed, "score the randomly perturbed a_* files too");
  app.add_flag("--physics")
      ->description("carry them out in the simulated room instead (--physics --help tells more)");
  app.add_flag("--json", json, "print one JSON object");
  CrossValidateRequest validation;
  std::string by;
  app.add_option("--cross-validate", by,
                 "score no model file, but models trained anew without the tested scenarios (or verbs)")
      ->check(CLI::IsMember({"scenario", "verb"}));
  app.add_option("--folds", validation.folds, "folds of the cross-validation")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--only-folds", validation.only, "run only so many of them; 0: all")
      ->check(CLI::Range(0, 1000));
  app.add_option("--fold-seed", validation.seed, "how scenarios or verbs are dealt to the folds")
      ->capture_default_str();
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  const auto report = [&](const Error& error) { return tell(app.get_name(), error, json); };

  if (!by.empty()) {
    validation.folder = folder, validation.by = by, validation.grounding = grounding, validation.runs = runs;
    validation.sentences = sentences;
    validation.threads = threads, validation.json = json;
    return cross_validate(validation);
  }

  auto demonstrations = read_demonstrations(folder);
  if (!demonstrations) return report(demonstrations.error());
  if (!sentences.empty()) {
    const auto others = read_other_sentences(sentences);
    if (!others) return report(others.error());
    if (const auto fits = check_other_sentences(*others, *demonstrations); !fits) return report(fits.error());
    if (const std::size_t left = count_left_out(*others, *demonstrations); left > 0 && !json)
      std::printf("%zu demonstrations have no sentence in %s and are not tested\n", left, sentences.c_str());
    std::erase_if(*demonstrations, [&](const Demonstration& d) { return !others->contains(d.id); });
    for (Demonstration& demonstration : *demonstrations)
      demonstration = with_sentence(std::move(demonstration), *others);
  }
  if (!perturbed) std::erase_if(*demonstrations, [](const Demonstration& d) { return d.perturbed; });
  if (demonstrations->empty())
    return report({Outcome::kInvalidRequest, folder + ": holds only perturbed demonstrations"});
  Symbols symbols;
  const auto lexicon = Lexicon::load(config_path("language/household.json"), symbols);
  if (!lexicon) return report(lexicon.error());

  // Before the work, not after it.
  if (!runs.empty())
    if (const auto writable = write_runs({}, runs); !writable) return report(writable.error());

  EvaluationOptions options;
  options.grounding = grounding == "given";
  options.threads = threads;
  const bool show = !json && isatty(STDERR_FILENO) != 0;
  if (show)
    options.progress = [](std::size_t done, std::size_t all) {
      std::fprintf(stderr, "\r%zu of %zu", done, all);
    };
  const auto begin = std::chrono::steady_clock::now();
  const auto evaluation =
      evaluate([&] { return load_model(model, ModelUse::kBenchmark); }, *demonstrations, *lexicon, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (show) std::fprintf(stderr, "\n");
  if (!evaluation) return report(evaluation.error());
  if (!runs.empty())
    if (const auto written = write_runs(evaluation->runs, runs); !written) return report(written.error());

  std::size_t refused = 0;
  for (const ModelRun& run : evaluation->runs) refused += !run.refusal.empty();
  if (json) {
    nlohmann::json object = to_json(evaluation->mean);
    object["count"] = evaluation->runs.size();
    object["refused"] = refused;
    object["grounding"] = grounding;
    if (!sentences.empty()) object["sentences"] = sentences;
    object["model"] = model;
    object["seconds"] = seconds;
    print_json(object);
  } else {
    const Scores& s = evaluation->mean;
    std::printf("%zu demonstrations, grounding %s, %.1f s\n", evaluation->runs.size(), grounding.c_str(),
                seconds);
    std::printf(
        "SJI %.3f  IED %.3f  F1 %.3f  GRR %.3f   (grr_formula %.3f, exact %.3f, ied_canonical %.3f)\n", s.sji,
        s.ied, s.f1, s.grr, s.grr_formula, s.exact, s.ied_canonical);
    if (refused > 0) std::printf("%zu refused\n", refused);
  }
  return 0;
}

}  // namespace goalnet::tools
