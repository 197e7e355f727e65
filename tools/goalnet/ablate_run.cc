#include "tools/goalnet/ablate_run.h"

#include <chrono>
#include <cstdio>
#include <ctime>

#include "components/goalnet/baseline/she_model.h"
#include "components/goalnet/evaluation.h"
#include "components/goalnet/network/network_model.h"
#include "components/goalnet/ranker/cross_validation.h"

namespace goalnet::tools {
namespace {

using namespace inference;

nlohmann::json scores_json(const Scores& s) {
  return {{"sji", s.sji},    {"ied", s.ied}, {"f1", s.f1}, {"grr", s.grr}, {"grr_formula", s.grr_formula},
          {"exact", s.exact}};
}

std::size_t changed_facts(const Demonstration& d) {
  const FactSet &first = d.states.front().facts, &last = d.states.back().facts;
  return difference(last, first).size() + difference(first, last).size();
}

// Reads the classes and senses that the baseline needs, from the training demonstrations.
Expected<network::Lexicon> lexicon_of(const std::vector<Demonstration>& demonstrations,
                                      const AblateInput& input) {
  std::vector<training::Episode> episodes;
  for (const Demonstration& d : demonstrations) {
    if (!d.perturbed) episodes.push_back(training::make_episode(d, input.things, true));
  }
  auto vocabulary = training::make_vocabulary(episodes, input.vectors, 8, input.constants);
  if (!vocabulary) return tl::unexpected(vocabulary.error());
  return std::move(vocabulary->lexicon);
}

Expected<ModelFactory> train_baseline(const std::vector<Demonstration>& learn, const AblateInput& input) {
  auto lexicon = lexicon_of(learn, input);
  if (!lexicon) return tl::unexpected(lexicon.error());
  std::vector<Demonstration> complete;
  for (const Demonstration& d : learn) {
    if (d.perturbed) continue;
    complete.push_back(d);
    for (WorldState& state : complete.back().states) input.things.complete_objects(state);
  }
  const auto parts = baseline::train_she(complete, std::move(*lexicon));
  return ModelFactory(
      [parts]() -> Expected<std::unique_ptr<GoalModel>> { return baseline::make_she_model(parts); });
}

// The scores of one grounding setting, and for "given" how they depend on the number of changed facts.
void add_scores(nlohmann::json& result, bool given, const Scores& mean, const std::vector<ModelRun>& runs,
                const std::vector<Demonstration>& test) {
  result[given ? "given" : "none"] = scores_json(mean);
  if (!given) return;
  for (std::size_t i = 0; i < test.size(); ++i) {
    const Scores& s = runs[i].scores;
    result["sizes"].push_back({changed_facts(test[i]), s.sji, s.f1, s.grr});
  }
}

// Trains and tests the shipped kind of model, once for each grounding setting, as `goalnet eval` does.
Expected<void> score_shipped(nlohmann::json& result, const Fold& fold, const std::vector<Demonstration>& test,
                             const AblateInput& input) {
  CrossValidationOptions options;
  auto language = read_language_texts();
  if (!language) return tl::unexpected(language.error());
  options.training.language = std::move(*language);
  options.training.ranker.training.seed = input.seed;
  for (const bool given : {true, false}) {
    options.grounding = given;
    const auto scored = cross_validate(input.demonstrations, {fold}, options);
    if (!scored) return tl::unexpected(scored.error());
    add_scores(result, given, scored->front().mean, scored->front().runs, test);
  }
  return {};
}

}  // namespace

Expected<nlohmann::json> ablate_one(const Variant& variant, int fold, const AblateInput& input,
                                    const std::function<void(const std::string&)>& report) {
  const ScenarioFolds folds(input.demonstrations, input.folds);
  std::vector<Demonstration> learn, test;
  Fold indices;
  for (std::size_t i = 0; i < input.demonstrations.size(); ++i) {
    const Demonstration& d = input.demonstrations[i];
    const bool held_out = folds.fold_of(d.scenario) == fold;
    if (held_out && d.perturbed) continue;
    (held_out ? test : learn).push_back(d);
    (held_out ? indices.test : indices.train).push_back(i);
  }
  nlohmann::json result = {{"variant", variant.name}, {"fold", fold}, {"curve", nlohmann::json::array()}};
  const auto begin = std::chrono::steady_clock::now();
  ModelFactory factory;
  const std::clock_t cpu_begin = std::clock();
  double seconds = -1;
  if (variant.kind == Variant::Kind::kShipped) {
    report("training and testing");
    if (auto scored = score_shipped(result, indices, test, input); !scored)
      return tl::unexpected(scored.error());
  } else if (variant.kind == Variant::Kind::kBaseline) {
    auto trained = train_baseline(learn, input);
    if (!trained) return tl::unexpected(trained.error());
    factory = std::move(*trained);
  } else {
    training::TrainOptions options;
    options.epochs = input.epochs;
    options.seed = input.seed;
    options.constants = input.constants;
    variant.change(options);
    seconds = 0;
    const auto progress = [&](const training::EpochReport& e) {
      result["curve"].push_back({e.loss, e.accuracy, e.held_out_loss, e.held_out_accuracy});
      seconds += e.seconds;
      char text[100];
      std::snprintf(text, sizeof text, "epoch %d of %d, held-out loss %.3f", e.epoch + 1, e.epochs,
                    e.held_out_loss);
      report(text);
    };
    auto trained = training::train_network(learn, test, input.things, input.vectors, options, progress);
    if (!trained) return tl::unexpected(trained.error());
    auto file = SafeTensors::parse(trained->file.bytes(), std::string(variant.name));
    if (!file) return tl::unexpected(file.error());
    factory = [file = std::make_shared<SafeTensors>(std::move(*file))] { return make_network_model(*file); };
  }
  if (seconds < 0) seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result["seconds"] = seconds;
  // Other programs on the machine do not count here: what comparisons of cost are made with.
  result["cpu_seconds"] = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  if (!factory) return result;  // scored above
  for (const bool grounding : {true, false}) {
    EvaluationOptions options;
    options.grounding = grounding;
    const auto scored = evaluate(factory, test, input.things, options);
    if (!scored) return tl::unexpected(scored.error());
    add_scores(result, grounding, scored->mean, scored->runs, test);
  }
  return result;
}

}  // namespace goalnet::tools
