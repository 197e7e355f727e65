#include "components/goalnet/ranker/train.h"

#include <map>
#include <set>

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
  for (int i = 15; i >= 0; --i, value >>= 4) text[static_cast<std::size_t>(i)] = "0123456789abcdef"[value & 15];
  return text;
}

}  // namespace

Expected<RankerParts> train(const std::vector<Demonstration>& demonstrations, const TrainingOptions& options) {
  auto parts = make_parts(options.language_json, "language");
  if (!parts) return parts;
  parts->known_words = vocabulary(demonstrations);
  parts->fingerprint = hexadecimal(fingerprint(demonstrations));
  parts->command = options.command;
  const std::vector<Example> examples = make_examples(demonstrations, *parts->lexicon, parts->symbols);
  std::vector<const Example*> all;
  for (const Example& example : examples) all.push_back(&example);
  int part = 0;
  bool stopped = false;
  for (const bool grounding : {true, false}) {
    const auto progress = [&](int epoch, double loss) {
      const double done = (part + (epoch + 1.0) / options.ranker.training.epochs) / 2;
      const std::string what = std::string(grounding ? "grounding given" : "grounding none") + ", epoch " +
                               std::to_string(epoch + 1) + ", loss " + std::to_string(loss).substr(0, 6);
      if (options.progress && !options.progress(what, done)) stopped = true;
      return !stopped;
    };
    (grounding ? parts->given : parts->none) = train_ranker(all, *parts->lexicon, grounding, options.ranker, progress);
    if (stopped) return fail(Outcome::kCancelled, "training was stopped");
    ++part;
  }
  return parts;
}

}  // namespace goalnet::inference
