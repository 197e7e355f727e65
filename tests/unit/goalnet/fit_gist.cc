// Learns what messages are about (components/goalnet/gist) from the instructions of tests/data/instructions:
//   goalnet_fit_gist OUT             writes the weights to OUT (config/language/gist.safetensors)
//   goalnet_fit_gist --folds         how it fares on instructions that it has not seen: five folds
//   goalnet_fit_gist --test FILE...  learns from all, says how each file fares (see instructions_report.cc)
// Sets `blind` and `held_out` are not learned from.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "components/goalnet/gist/features.h"
#include "components/goalnet/gist/wording.h"
#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet/instruction_runner.h"

namespace goalnet::inference {
namespace {

constexpr int kEpochs = 15;
constexpr double kRate = 0.05, kDecay = 1e-4;
constexpr double kPower = 0.3;  // of the summed squares: frequent features learn nearly as fast as rare ones
constexpr int kFolds = 5;
constexpr std::size_t kBlock = 60;  // neighbouring lines are by one person: they go to one fold

struct Example {
  std::string sentence;
  bool senseless = false, covered = true;  // whether every wanted fact is one of the requests'
  std::set<std::string> wanted;            // Request::what
  gist::Views views;
  std::vector<std::vector<std::vector<std::uint32_t>>> features;  // of each request of each view
};

// What of `requests` brings a fact about; empty where nothing does.
std::string request_for(const std::string& fact, bool wanted, const WorldState& world,
                        const RobotLanguage::Sight& sight, const RobotLanguage& language, Symbols& symbols) {
  std::istringstream words(fact.substr(1, fact.size() - 2));
  std::string relation, subject, object;
  words >> relation >> subject >> object;
  const auto class_of = [&](std::string name) {
    if (name.ends_with('*')) {
      name.pop_back();
      for (const std::string& here : world.objects)
        if (here.starts_with(name)) {
          name = here;
          break;
        }
    }
    return gist::class_name(symbols.intern(name), sight.here, language.lexicon(), symbols);
  };
  if (relation == "On" || relation == "In")
    return wanted ? "at " + class_of(subject) + " " + class_of(object) : "away " + class_of(subject);
  if (relation == "Grasping") return (wanted ? "take " : "release ") + class_of(object);
  if (relation == "Near") return "near " + class_of(object);
  if (relation != "state") return {};
  if (object.ends_with("DoorIsOpen")) return (wanted ? "open " : "close ") + class_of(subject);
  if (object == "StoveFire*") object = "StoveFire1";
  static const std::set<std::string> kContents = {"Water",    "Coffee",    "Coke",      "EnergyDrink",
                                                  "IceCream", "Chocolate", "CanadaDry", "Vanilla",
                                                  "Salt",     "Ramen",     "Egg"};
  if (!wanted && kContents.contains(object)) return "empty " + class_of(subject);
  return (wanted ? "is " : "not ") + class_of(subject) + " " + object;
}

class Fit {
 public:
  Fit() {
    auto language = RobotLanguage::load(symbols_, false);
    if (!language) throw std::runtime_error(language.error().message);
    language_ = std::move(*language);
  }

  Example example(const std::string& room, const std::string& sentence, const std::string& goal,
                  const std::string& changes) {
    const WorldState world = rooms_.room(room, changes);
    const auto tokens = tokenize(sentence, Endings::kKept);
    if (!tokens) throw std::runtime_error(sentence + ": " + tokens.error().message);
    auto sight = language_->see(*tokens, world.objects, to_sym_state(world.facts, symbols_));
    Example example;
    example.sentence = sentence;
    example.senseless = goal == "REFUSE";
    for (const gist::View& view : sight.views) {
      auto& features = example.features.emplace_back();
      for (const gist::Request& request : view.requests)
        features.push_back(gist::features(view.message, request));
    }
    if (!example.senseless) want(goal, world, sight, example);
    example.views = std::move(sight.views);
    return example;
  }
  const Language& words() const { return language_->language(); }

 private:
  // The alternative of which most is possible.
  void want(const std::string& goal, const WorldState& world, const RobotLanguage::Sight& sight,
            Example& example) {
    std::set<std::string> possible;
    for (const gist::View& view : sight.views)
      for (const gist::Request& request : view.requests) possible.insert(request.what);
    int least = -1;
    for (std::size_t begin = 0, end; begin <= goal.size(); begin = end + 3) {
      end = std::min(goal.find(" / ", begin), goal.size());
      std::set<std::string> wanted;
      int missing = 0;
      for (const auto& [fact, positive] : signed_facts(goal.substr(begin, end - begin))) {
        const std::string what = request_for(fact, positive, world, sight, *language_, symbols_);
        if (possible.contains(what))
          wanted.insert(what);
        else
          ++missing;
      }
      if (least < 0 || missing < least) least = missing, example.wanted = std::move(wanted);
    }
    example.covered = least == 0;
  }

  Rooms rooms_;
  Symbols symbols_;
  std::unique_ptr<RobotLanguage> language_;
};

// Logistic regression by AdaGrad; of requests that want the same the likeliest one learns.
std::vector<float> learn(const std::vector<const Example*>& examples) {
  std::vector<double> weights(gist::kFeatures), squares(gist::kFeatures, 1e-6);
  const auto score = [&](const std::vector<std::uint32_t>& features) {
    return std::accumulate(features.begin(), features.end(), 0.0,
                           [&](double sum, std::uint32_t feature) { return sum + weights[feature]; });
  };
  std::vector<const Example*> order = examples;
  std::mt19937 random(1);
  for (int epoch = 0; epoch < kEpochs; ++epoch) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    for (const Example* example : order)
      for (std::size_t view = 0; view < example->views.size(); ++view) {
        const std::vector<gist::Request>& requests = example->views[view].requests;
        std::map<std::string, std::pair<double, std::size_t>> best;
        for (std::size_t i = 0; i < requests.size(); ++i) {
          const double value = score(example->features[view][i]);
          const auto [at, fresh] = best.try_emplace(requests[i].what, value, i);
          if (!fresh && value > at->second.first) at->second = {value, i};
        }
        for (const auto& [what, scored] : best) {
          const double error = 1 / (1 + std::exp(-scored.first)) - (example->wanted.contains(what) ? 1 : 0);
          if (std::abs(error) < 0.01) continue;
          for (const std::uint32_t feature : example->features[view][scored.second]) {
            squares[feature] += error * error;
            weights[feature] -=
                kRate * (error + kDecay * weights[feature]) / std::pow(squares[feature], kPower);
          }
        }
      }
    std::fprintf(stderr, "epoch %d of %d\n", epoch + 1, kEpochs);
  }
  return {weights.begin(), weights.end()};
}

struct Result {
  double probability;
  bool right, senseless;
};

Result test(const gist::GistModel& model, const Example& example) {
  const gist::Likely likely = model.likely(example.views);
  std::set<std::string> found;
  for (const gist::Request& request : likely.requests) found.insert(request.what);
  return {likely.probability,
          !example.senseless && example.covered && found == example.wanted && !found.empty(),
          example.senseless};
}

void print(const std::string& name, const std::vector<Result>& results) {
  std::printf("%s: %zu\n", name.c_str(), results.size());
  for (const double least : {0.0, 0.3, 0.5, 0.7, 0.8, 0.9}) {
    int sure = 0, right = 0, senseless = 0;
    for (const Result& result : results) {
      if (result.probability <= least) continue;
      ++sure, right += result.right, senseless += result.senseless;
    }
    std::printf("  surer than %.1f: %4d, right %4d, senseless %d\n", least, sure, right, senseless);
  }
}

std::vector<Example> instructions(Fit& fit) {
  const std::string folder = GOALNET_SOURCE_DIR "/tests/data/instructions/";
  std::vector<Example> examples;
  for (auto row : read_rows(folder + "sensible.tsv")) {
    row.resize(6);
    if (row[1] == "tuning") examples.push_back(fit.example(row[2], row[3], row[5], row[4]));
  }
  for (const auto& row : read_rows(folder + "nonsense.tsv"))
    if (row[1] == "tuning") examples.push_back(fit.example(row[2], row[3], "REFUSE", ""));
  return examples;
}

int run(int argc, char** argv) {
  Fit fit;
  const std::vector<Example> examples = instructions(fit);
  std::vector<const Example*> all;
  for (const Example& example : examples) all.push_back(&example);
  if (std::strcmp(argv[1], "--folds") == 0) {
    std::vector<Result> results;
    for (std::size_t fold = 0; fold < kFolds; ++fold) {
      std::vector<const Example*> rest;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (i / kBlock % kFolds != fold) rest.push_back(all[i]);
      const gist::GistModel model(learn(rest));
      for (std::size_t i = 0; i < all.size(); ++i)
        if (i / kBlock % kFolds == fold) results.push_back(test(model, *all[i]));
    }
    print("instructions not learned from", results);
    return 0;
  }
  const gist::GistModel model(learn(all));
  if (std::strcmp(argv[1], "--test") != 0) {
    const auto saved = model.save(argv[1], "goalnet_fit_gist");
    if (!saved) throw std::runtime_error(saved.error().message);
    return 0;
  }
  for (int i = 2; i < argc; ++i) {
    std::vector<Result> results;
    for (auto row : read_rows(argv[i])) {
      row.resize(4);
      const Example example = fit.example(row[0], row[1], row[2], row[3]);
      results.push_back(test(model, example));
      const gist::Likely likely = model.likely(example.views);
      std::printf("%s %.2f %s\n     %s\n",
                  results.back().right ? "right"
                  : example.senseless  ? "none "
                                       : "WRONG",
                  likely.probability, row[1].c_str(),
                  gist::in_words(example.views, likely.requests, fit.words()).c_str());
    }
    print(argv[i], results);
  }
  return 0;
}

}  // namespace
}  // namespace goalnet::inference

int main(int argc, char** argv) {
  if (argc < 2 || std::strcmp(argv[1], "--help") == 0) {
    std::puts("usage: goalnet_fit_gist OUT | --folds | --test FILE...");
    return argc < 2 ? 13 : 0;
  }
  try {
    return goalnet::inference::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 13;
  }
}
