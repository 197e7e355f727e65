#include "components/goalnet/language/phrase_rules.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace goalnet::inference {
namespace {

constexpr int kMostRewrites = 1000;       // in one sentence
constexpr std::size_t kMostWays = 20000;  // of one pattern
constexpr std::size_t kMostGroups = 6;    // in one pattern
constexpr std::size_t kLooksBack = 4;     // words: what was just written may be part of a longer phrase

std::vector<std::string> parts(const std::string& text, char at) {
  std::vector<std::string> result;
  std::string part;
  std::istringstream stream(text);
  while (std::getline(stream, part, at)) result.push_back(part);
  if (text.empty() || text.back() == at) result.emplace_back();
  return result;
}

// A way to read the beginning of a pattern.
struct Way {
  std::int32_t node;                             // where its words end in the tree
  std::array<std::int32_t, kMostGroups> chosen;  // which phrase of each of the pattern's groups
};

}  // namespace

PhraseRules::Id PhraseRules::id_of(const std::string& word) {
  const auto [it, added] = ids_.try_emplace(word, static_cast<Id>(names_.size()));
  if (added) names_.push_back(word), looked_for_.push_back(false);
  return it->second;
}

PhraseRules::Id PhraseRules::known_id(const std::string& word) const {
  const auto it = ids_.find(word);
  return it == ids_.end() ? kNone : it->second;
}

std::vector<PhraseRules::Id> PhraseRules::ids_of(const Phrase& phrase) {
  std::vector<Id> ids;
  for (const std::string& word : phrase) ids.push_back(id_of(word));
  return ids;
}

// Where the node for `word` behind `node` is, or would be.
std::size_t PhraseRules::slot_of(Id node, Id word) const {
  const std::uint64_t key = (static_cast<std::uint64_t>(node) << 32) | static_cast<std::uint32_t>(word);
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 32) & mask;
  while (slots_[slot] != kNone) {
    const Node& there = nodes_[static_cast<std::size_t>(slots_[slot])];
    if (there.parent == node && there.word == word) break;
    slot = (slot + 1) & mask;
  }
  return slot;
}

PhraseRules::Id PhraseRules::child(Id node, Id word) const { return slots_[slot_of(node, word)]; }

PhraseRules::Id PhraseRules::add_child(Id node, Id word) {
  if (const Id there = child(node, word); there != kNone) return there;
  if (nodes_.size() * 2 > slots_.size()) grow();
  const Id added = static_cast<Id>(nodes_.size());
  slots_[slot_of(node, word)] = added;
  nodes_.push_back({word, node, kNone});
  if (!looked_for_[static_cast<std::size_t>(word)]) {
    looked_for_[static_cast<std::size_t>(word)] = true;
    words_.push_back(names_[static_cast<std::size_t>(word)]);
  }
  return added;
}

void PhraseRules::grow() {
  slots_.assign(slots_.size() * 2, kNone);
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    slots_[slot_of(nodes_[i].parent, nodes_[i].word)] = static_cast<Id>(i);
}

void PhraseRules::add_rule(Id node, const std::vector<Id>& said) {
  Id& rule = nodes_[static_cast<std::size_t>(node)].rule;
  if (rule != kNone) return;
  rule = static_cast<Id>(rules_.size());
  const auto begin = static_cast<std::uint32_t>(said_.size());
  said_.insert(said_.end(), said.begin(), said.end());
  rules_.push_back({begin, static_cast<std::uint32_t>(said_.size())});
}

void PhraseRules::add(const Phrase& from, const Phrase& to) {
  if (from.empty()) return;
  Id node = kRoot;
  for (const Id word : ids_of(from)) node = add_child(node, word);
  add_rule(node, ids_of(to));
}

Expected<void> PhraseRules::add_pattern(const Phrase& from, const Phrase& to, const Groups& groups) {
  std::vector<std::string> named;                     // the groups of the pattern, as they come
  std::vector<std::vector<std::vector<Id>>> phrases;  // theirs
  std::vector<Way> ways(1);
  ways.front().node = kRoot;
  ways.front().chosen.fill(kNone);
  for (const std::string& token : from) {
    std::vector<Way> longer;
    for (const std::string& choice : parts(token, '|')) {
      const bool of_group = choice.starts_with('$');
      std::size_t group = 0;
      std::vector<std::vector<Id>> said;
      if (of_group) {
        const auto it = groups.find(choice);
        if (it == groups.end()) return fail(Outcome::kInvalidRequest, "there is no group " + choice);
        group = static_cast<std::size_t>(std::find(named.begin(), named.end(), choice) - named.begin());
        if (group == kMostGroups) return fail(Outcome::kInvalidRequest, "a pattern has too many groups");
        for (const Phrase& phrase : it->second) said.push_back(ids_of(phrase));
        if (group == named.size()) named.push_back(choice), phrases.push_back(said);
      } else {
        said.push_back(choice.empty() ? std::vector<Id>{} : ids_of(parts(choice, '+')));
      }
      for (const Way& way : ways)
        for (std::size_t i = 0; i < said.size(); ++i) {
          Way next = way;
          for (const Id word : said[i]) next.node = add_child(next.node, word);
          if (of_group && next.chosen[group] == kNone) next.chosen[group] = static_cast<Id>(i);
          longer.push_back(next);
          if (longer.size() > kMostWays)
            return fail(Outcome::kInvalidRequest, "a pattern has too many ways to be read");
        }
    }
    ways = std::move(longer);
  }
  std::vector<Id> said;
  for (const Way& way : ways) {
    if (way.node == kRoot) return fail(Outcome::kInvalidRequest, "a pattern may match no word at all");
    said.clear();
    for (const std::string& token : to) {
      const auto group =
          static_cast<std::size_t>(std::find(named.begin(), named.end(), token) - named.begin());
      if (group < named.size() && way.chosen[group] != kNone) {
        const std::vector<Id>& phrase = phrases[group][static_cast<std::size_t>(way.chosen[group])];
        said.insert(said.end(), phrase.begin(), phrase.end());
      } else {
        said.push_back(id_of(token));
      }
    }
    add_rule(way.node, said);
  }
  return {};
}

// The rule for most of the words from `at` on.
PhraseRules::Id PhraseRules::longest(const std::vector<Id>& words, std::size_t at,
                                     std::size_t* length) const {
  Id rule = kNone, node = kRoot;
  for (std::size_t k = at; k < words.size() && words[k] != kNone; ++k) {
    node = child(node, words[k]);
    if (node == kNone) break;
    if (const Id here = nodes_[static_cast<std::size_t>(node)].rule; here != kNone)
      rule = here, *length = k + 1 - at;
  }
  return rule;
}

std::vector<std::string> PhraseRules::apply(std::vector<std::string> words, std::size_t most) const {
  std::vector<Id> ids;
  for (const std::string& word : words) ids.push_back(known_id(word));
  int left = kMostRewrites;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t length = 0;
    const Id found = longest(ids, i, &length);
    const Rule rule = found == kNone ? Rule{} : rules_[static_cast<std::size_t>(found)];
    if (found == kNone || left-- <= 0 || words.size() + (rule.end - rule.begin) > most) {
      ++i;
      continue;
    }
    const auto first = static_cast<long>(i), last = static_cast<long>(i + length);
    const auto said = ids.erase(ids.begin() + first, ids.begin() + last);
    ids.insert(said, said_.begin() + rule.begin, said_.begin() + rule.end);
    auto word = words.erase(words.begin() + first, words.begin() + last);
    for (std::uint32_t k = rule.begin; k < rule.end; ++k)
      word = words.insert(word, names_[static_cast<std::size_t>(said_[k])]) + 1;
    i = i < kLooksBack ? 0 : i - kLooksBack;
  }
  return words;
}

}  // namespace goalnet::inference
