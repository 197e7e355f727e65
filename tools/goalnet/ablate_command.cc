#include "tools/goalnet/ablate_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <unistd.h>
#include <CLI/CLI.hpp>

#include "components/core/config_path.h"
#include "tools/goalnet/ablate_report.h"
#include "tools/goalnet/ablate_run.h"

namespace goalnet::tools {
namespace {

using Json = nlohmann::json;

int failed(const Error& error) {
  std::fprintf(stderr, "goalnet ablate: %s\n", error.message.c_str());
  return static_cast<int>(error.outcome);
}

// Hours of training are kept there: results of other data or settings are neither mixed with these nor lost.
Expected<Json> read_results(const std::filesystem::path& path, const Json& about) {
  std::ifstream file(path);
  if (!file) return Json{{"about", about}, {"runs", Json::array()}};
  Json results = Json::parse(file, nullptr, false);
  if (!results.is_object() || !results["about"].is_object() || !results["runs"].is_array())
    return fail(Outcome::kInvalidRequest,
                path.string() + ": is not what goalnet ablate writes; give another folder with --out");
  const Json& theirs = results["about"];
  if (theirs.value("identity", "") != about["identity"])
    return fail(Outcome::kInvalidRequest,
                path.string() + ": holds results of other data or settings (" +
                    std::to_string(theirs.value("epochs", 0)) + " epochs, seed " +
                    std::to_string(theirs.value("seed", 0)) +
                    "); use the same --epochs and --seed to add to them, or another folder with --out");
  return results;
}

bool has_run(const Json& results, std::string_view variant, int fold) {
  const auto& runs = results.at("runs");
  return std::any_of(runs.begin(), runs.end(),
                     [&](const Json& run) { return run.at("variant") == variant && run.at("fold") == fold; });
}

}  // namespace

int ablate_command(int argc, char** argv) {
  std::string data, out = "docs";
  AblateInput input{{}, {}, {}, {}};
  int folds_run = 5;
  bool report_only = false;
  std::vector<std::string> only;
  CLI::App app{
      "Trains and scores the paper's model, its baseline, ablations and explorations, and the shipped model.",
      "goalnet ablate"};
  app.add_option("DIR", data, "folder of demonstrations (*.json)")->required();
  app.add_option("--folds-run", folds_run, "folds to hold out, of 5")->check(CLI::Range(1, 5));
  app.add_option("--epochs", input.epochs, "epochs of each training")->check(CLI::Range(1, 1000));
  app.add_option("--seed", input.seed, "fixes everything that is random");
  app.add_option("--only", only, "train only this variant (repeatable)");
  app.add_option("--out", out, "folder for benchmark.md and its pictures");
  app.add_flag("--report-only", report_only, "train nothing, write the report from the results there are");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cerr, std::cerr) == 0 ? 0 : static_cast<int>(Outcome::kInvalidRequest);
  }
  auto demonstrations = inference::read_demonstrations(data);
  if (!demonstrations) return failed(demonstrations.error());
  inference::Symbols symbols;
  auto things = inference::Lexicon::load(config_path("language/household.json"), symbols);
  if (!things) return failed(things.error());
  const auto folder = std::filesystem::path(data).parent_path();
  auto vectors = inference::training::read_word_vectors({folder / "conceptnet.json", folder / "vocab.json"});
  if (!vectors) return failed(vectors.error());
  input.demonstrations = std::move(*demonstrations);
  input.things = std::move(*things);
  input.vectors = std::move(*vectors);
  input.constants = (folder / "constants.json").string();

  char fingerprint[24];
  std::snprintf(fingerprint, sizeof fingerprint, "%016llx",
                static_cast<unsigned long long>(inference::fingerprint(input.demonstrations)));
  const auto real = std::count_if(input.demonstrations.begin(), input.demonstrations.end(),
                                  [](const auto& d) { return !d.perturbed; });
  Json about = {{"demonstrations", real}, {"fingerprint", fingerprint}, {"folds", input.folds},
                {"folds_run", folds_run}, {"epochs", input.epochs},     {"seed", input.seed}};
  about["identity"] =
      std::string(fingerprint) + " " + std::to_string(input.epochs) + " " + std::to_string(input.seed);
  const std::filesystem::path kept = std::filesystem::path(out) / "benchmark" / "results.json";
  std::error_code ignored;
  std::filesystem::create_directories(kept.parent_path(), ignored);
  auto read = read_results(kept, about);
  if (!read) return failed(read.error());
  Json results = std::move(*read);
  results["about"] = about;

  const bool terminal = isatty(STDERR_FILENO) != 0;
  for (int fold = 0; fold < folds_run && !report_only; ++fold) {
    for (const Variant& variant : variants()) {
      const bool wanted = only.empty() || std::find(only.begin(), only.end(), variant.name) != only.end();
      if (!wanted || has_run(results, variant.name, fold)) continue;
      const std::string what = "fold " + std::to_string(fold + 1) + " of " + std::to_string(folds_run) +
                               ", " + std::string(variant.name);
      const auto report = [&](const std::string& measured) {
        if (terminal) std::fprintf(stderr, "\r%s: %s\x1b[K", what.c_str(), measured.c_str());
      };
      auto run = ablate_one(variant, fold, input, report);
      if (!run) return failed(run.error());
      std::fprintf(stderr, "%s%s: SJI %.3f, GRR %.3f, trained in %.0f s\n", terminal ? "\r\x1b[K" : "",
                   what.c_str(), (*run)["given"]["sji"].get<double>(), (*run)["given"]["grr"].get<double>(),
                   (*run)["seconds"].get<double>());
      results["runs"].push_back(std::move(*run));
      std::ofstream(kept) << results.dump() << "\n";
    }
  }
  if (const auto written = write_ablate_report(results, out); !written) return failed(written.error());
  std::fprintf(stderr, "wrote %s/benchmark.md\n", out.c_str());
  return 0;
}

}  // namespace goalnet::tools
