// "Instead of X say Y": ways of saying the same, made equal before any grammar.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

// Rules are kept as a tree by their words, so that thousands cost no more than one; words are numbers there,
// since the patterns of config/language make hundreds of thousands of rules.
class PhraseRules {
 public:
  using Phrase = std::vector<std::string>;
  using Groups = std::map<std::string, std::vector<Phrase>>;  // "$n" -> "one", "two", ...

  // Of two rules for the same words the first added counts.
  void add(const Phrase& from, const Phrase& to);
  // Adds one rule for each way to read `from`: "a|b" is either, "a|" may be left out, "a+b" are two words,
  // "$n" is any phrase of that group and stands for the same one in `to`. Fails with kInvalidRequest: an
  // unknown group, too many ways or groups, nothing left to match.
  Expected<void> add_pattern(const Phrase& from, const Phrase& to, const Groups& groups);
  // Replaces the longest phrase that fits at each word; the result is never longer than `most` words.
  std::vector<std::string> apply(std::vector<std::string> words, std::size_t most) const;
  bool empty() const { return rules_.empty(); }
  // All words that rules look for, each once.
  const std::vector<std::string>& words() const { return words_; }

 private:
  using Id = std::int32_t;  // of a word, a node, a rule; kNone where there is none
  static constexpr Id kNone = -1, kRoot = 0;
  struct Node {
    Id word, parent, rule;
  };
  struct Rule {
    std::uint32_t begin, end;  // of what it says, in said_
  };

  Id id_of(const std::string& word);
  Id known_id(const std::string& word) const;
  Id child(Id node, Id word) const;
  Id add_child(Id node, Id word);
  std::size_t slot_of(Id node, Id word) const;
  void grow();
  void add_rule(Id node, const std::vector<Id>& said);
  std::vector<Id> ids_of(const Phrase& phrase);
  Id longest(const std::vector<Id>& words, std::size_t at, std::size_t* length) const;

  std::unordered_map<std::string, Id> ids_;
  std::vector<std::string> names_;  // of ids
  std::vector<std::string> words_;
  std::vector<bool> looked_for_;  // ids that are in words_
  std::vector<Node> nodes_ = std::vector<Node>(1, {kNone, kNone, kNone});
  std::vector<Id> slots_ = std::vector<Id>(64, kNone);  // nodes, hashed by parent and word; a power of two
  std::vector<Rule> rules_;
  std::vector<Id> said_;
};

}  // namespace goalnet::inference
