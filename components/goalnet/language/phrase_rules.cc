#include "components/goalnet/language/phrase_rules.h"

#include <sstream>

namespace goalnet::inference {
namespace {

constexpr int kMostRewrites = 1000;       // in one sentence
constexpr std::size_t kMostWays = 20000;  // of one pattern
constexpr std::size_t kLooksBack = 4;     // words: what was just written may be part of a longer phrase

std::vector<std::string> parts(const std::string& text, char at) {
  std::vector<std::string> result;
  std::string part;
  std::istringstream stream(text);
  while (std::getline(stream, part, at)) result.push_back(part);
  if (text.empty() || text.back() == at) result.emplace_back();
  return result;
}

struct Way {
  PhraseRules::Phrase words;
  std::map<std::string, PhraseRules::Phrase> chosen;  // of the groups
};

}  // namespace

void PhraseRules::add(const Phrase& from, Phrase to) {
  if (from.empty()) return;
  std::size_t node = 0;
  for (const std::string& word : from) {
    words_.push_back(word);
    const auto [it, added] = nodes_[node].next.try_emplace(word, static_cast<int>(nodes_.size()));
    node = static_cast<std::size_t>(it->second);
    if (added) nodes_.emplace_back();
  }
  if (nodes_[node].rule >= 0) return;
  nodes_[node].rule = static_cast<int>(to_.size());
  to_.push_back(std::move(to));
}

Expected<void> PhraseRules::add_pattern(const Phrase& from, const Phrase& to, const Groups& groups) {
  std::vector<Way> ways(1);
  for (const std::string& token : from) {
    std::vector<Way> longer;
    for (const std::string& choice : parts(token, '|')) {
      std::vector<Phrase> phrases;
      if (choice.starts_with('$')) {
        const auto group = groups.find(choice);
        if (group == groups.end()) return fail(Outcome::kInvalidRequest, "there is no group " + choice);
        phrases = group->second;
      } else {
        phrases.push_back(choice.empty() ? Phrase{} : parts(choice, '+'));
      }
      for (const Way& way : ways)
        for (const Phrase& phrase : phrases) {
          Way next = way;
          next.words.insert(next.words.end(), phrase.begin(), phrase.end());
          if (choice.starts_with('$')) next.chosen.try_emplace(choice, phrase);
          longer.push_back(std::move(next));
        }
    }
    ways = std::move(longer);
    if (ways.size() > kMostWays)
      return fail(Outcome::kInvalidRequest, "a pattern has too many ways to be read");
  }
  for (const Way& way : ways) {
    if (way.words.empty()) return fail(Outcome::kInvalidRequest, "a pattern may match no word at all");
    Phrase said;
    for (const std::string& token : to) {
      if (const auto chosen = way.chosen.find(token); chosen != way.chosen.end())
        said.insert(said.end(), chosen->second.begin(), chosen->second.end());
      else
        said.push_back(token);
    }
    add(way.words, std::move(said));
  }
  return {};
}

std::vector<std::string> PhraseRules::apply(std::vector<std::string> words, std::size_t most) const {
  int left = kMostRewrites;
  for (std::size_t i = 0; i < words.size();) {
    int rule = -1;
    std::size_t length = 0;
    for (std::size_t node = 0, k = i; k < words.size(); ++k) {
      const auto next = nodes_[node].next.find(words[k]);
      if (next == nodes_[node].next.end()) break;
      node = static_cast<std::size_t>(next->second);
      if (nodes_[node].rule >= 0) rule = nodes_[node].rule, length = k + 1 - i;
    }
    const Phrase* to = rule < 0 ? nullptr : &to_[static_cast<std::size_t>(rule)];
    if (to == nullptr || left-- <= 0 || words.size() + to->size() > most) {
      ++i;
      continue;
    }
    const auto at =
        words.erase(words.begin() + static_cast<long>(i), words.begin() + static_cast<long>(i + length));
    words.insert(at, to->begin(), to->end());
    i = i < kLooksBack ? 0 : i - kLooksBack;
  }
  return words;
}

}  // namespace goalnet::inference
