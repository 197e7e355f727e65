#include "components/goalnet/ranker/train.h"

#include <map>
#include <set>

#include "components/goalnet/ranker/reranker.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

// Words that at least two people used: known, though perhaps no verb and no name.
std::vector<std::string> vocabulary(const std::vector<Demonstration>& demonstrations) {
  std::map<std::string, std::set<std::string>> users;
  for (const Demonstration& demonstration : demonstrations)
    for (const std::string& word : tokenize(demonstration.sentence).value_or(std::vector<std::string>{}))
      users[word].insert(demonstration.scenario);
  std::vector<std::string> words;
  for (const auto& [word, scenarios] : users)
    if (scenarios.size() > 1 && word != "." && word != ",") words.push_back(word);
  return words;
}

std::string hexadecimal(std::uint64_t value) {
  std::string text(16, '0');
  for (int i = 15; i >= 0; --i, value >>= 4)
    text[static_cast<std::size_t>(i)] = "0123456789abcdef"[value & 15];
  return text;
}

// All that decides the weights, as text: the checkpoint of anything else is not resumed.
std::string identity_of(const std::string& data, const TrainingOptions& options) {
  std::string text = "2 " + data + " " + to_json(options.ranker) + " " + std::to_string(kFeatureBuckets) +
                     " " + std::to_string(kRunFeatures);
  for (const std::string* language :
       {&options.language.household, &options.language.english, &options.language.words})
    text += " " + std::to_string(hash_text(*language));
  return text;
}

}  // namespace

Expected<RankerParts> train(const std::vector<Demonstration>& demonstrations,
                            const TrainingOptions& options) {
  auto parts = make_parts(options.language, "language");
  if (!parts) return parts;
  parts->known_words = vocabulary(demonstrations);
  parts->fingerprint = hexadecimal(fingerprint(demonstrations));
  parts->command = options.command;
  auto checkpoint = Checkpoint::open(options.checkpoint, identity_of(parts->fingerprint, options));
  if (!checkpoint) return tl::unexpected(checkpoint.error());
  const std::vector<Example> examples =
      make_examples(demonstrations, *parts->lexicon, *parts->language, parts->symbols);
  std::vector<const Example*> all;
  for (const Example& example : examples) all.push_back(&example);
  // For each setting one ranker on everything and five on four fifths (the re-ranker's): six equal parts.
  double base = 0;
  const double settings = options.given && options.none ? 2 : 1;
  bool stopped = false;
  for (const bool grounding : {true, false}) {
    if (!(grounding ? options.given : options.none)) continue;
    const std::string setting = grounding ? "grounding given" : "grounding none";
    const auto tell = [&](const std::string& what, double part) {
      if (options.progress && !options.progress(setting + ", " + what, base + part / settings))
        stopped = true;
      return !stopped;
    };
    Ranker& ranker = grounding ? parts->given : parts->none;
    const std::string stage = std::string(grounding ? "given" : "none") + ".policy";
    const auto* known = checkpoint->find(stage);
    if (known != nullptr && known->size() == kFeatureBuckets) {
      ranker = untrained_ranker(all, grounding, options.ranker);
      ranker.policy.weights() = *known;
    } else {
      ranker = train_ranker(all, *parts->lexicon, grounding, options.ranker, [&](int epoch, double loss) {
        return tell(
            "ranker: epoch " + std::to_string(epoch + 1) + ", loss " + std::to_string(loss).substr(0, 6),
            (epoch + 1.0) / options.ranker.training.epochs / 6);
      });
      if (stopped) return fail(Outcome::kCancelled, "training was stopped");
      if (auto kept = checkpoint->keep(stage, ranker.policy.weights()); !kept)
        return tl::unexpected(kept.error());
    }
    if (options.rerank) {
      auto reranker =
          train_reranker(all, *parts->lexicon, grounding, options.ranker, *checkpoint, [&](double part) {
            return tell("re-ranker: candidate runs for unseen scenarios", 1.0 / 6 + part * 5 / 6);
          });
      if (!reranker) return tl::unexpected(reranker.error());
      ranker.reranker = std::move(reranker->trees);
      ranker.confidence = std::move(reranker->confidence);
    }
    base += 1 / settings;
  }
  if (options.progress) options.progress("done", 1);
  return parts;
}

}  // namespace goalnet::inference
