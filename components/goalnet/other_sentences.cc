#include "components/goalnet/other_sentences.h"

#include <algorithm>
#include <fstream>

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

constexpr std::string_view kEnding = ".json";

}  // namespace

Expected<OtherSentences> read_other_sentences(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    return fail(Outcome::kInvalidRequest, path.string() + ": cannot be read");
  OtherSentences sentences;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const auto bad = [&](const std::string& what) {
      return fail(Outcome::kInvalidRequest, path.string() + ":" + std::to_string(number) + ": " + what);
    };
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos)
      return bad("should be the file name of a demonstration, a tab and a sentence");
    const std::string name = line.substr(0, tab), sentence = line.substr(tab + 1);
    if (name.size() <= kEnding.size() || !name.ends_with(kEnding))
      return bad("\"" + name + "\" should be the file name of a demonstration, like 263_450.json");
    if (sentence.find('\t') != std::string::npos) return bad("has more than one tab");
    const auto words = tokenize(sentence);
    if (!words) return bad(words.error().message);
    if (words->empty()) return bad("the sentence is missing");
    if (!sentences.emplace(name.substr(0, name.size() - kEnding.size()), sentence).second)
      return bad(name + " has a sentence already");
  }
  if (file.bad()) return fail(Outcome::kInvalidRequest, path.string() + ": cannot be read");
  if (sentences.empty()) return fail(Outcome::kInvalidRequest, path.string() + ": holds no sentences");
  return sentences;
}

Expected<void> check_other_sentences(const OtherSentences& sentences,
                                     const std::vector<Demonstration>& demonstrations) {
  OtherSentences left = sentences;
  for (const Demonstration& demonstration : demonstrations) {
    if (demonstration.perturbed && left.contains(demonstration.id))
      return fail(Outcome::kInvalidRequest,
                  demonstration.id +
                      ".json: is perturbed at random and never tested, so that it needs no "
                      "other sentence");
    left.erase(demonstration.id);
  }
  if (left.empty()) return {};
  return fail(Outcome::kInvalidRequest,
              left.begin()->first + ".json: has a sentence, but is no demonstration of the folder" +
                  (left.size() > 1 ? " (and " + std::to_string(left.size() - 1) + " more)" : ""));
}

std::size_t count_left_out(const OtherSentences& sentences,
                           const std::vector<Demonstration>& demonstrations) {
  return static_cast<std::size_t>(
      std::count_if(demonstrations.begin(), demonstrations.end(), [&](const Demonstration& demonstration) {
        return !demonstration.perturbed && !sentences.contains(demonstration.id);
      }));
}

Demonstration with_sentence(Demonstration demonstration, const OtherSentences& sentences) {
  if (const auto other = sentences.find(demonstration.id); other != sentences.end())
    demonstration.sentence = other->second;
  return demonstration;
}

}  // namespace goalnet::inference
