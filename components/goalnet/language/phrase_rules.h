// "Instead of X say Y": ways of saying the same, made equal before any grammar.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

// Rules are kept as a tree by their words, so that thousands cost no more than one.
class PhraseRules {
 public:
  using Phrase = std::vector<std::string>;
  using Groups = std::map<std::string, std::vector<Phrase>>;  // "$n" -> "one", "two", ...

  // Of two rules for the same words the first added counts.
  void add(const Phrase& from, Phrase to);
  // Adds one rule for each way to read `from`: "a|b" is either, "a|" may be left out, "a+b" are two words,
  // "$n" is any phrase of that group and stands for the same one in `to`. Fails with kInvalidRequest: an
  // unknown group, too many ways, nothing left to match.
  Expected<void> add_pattern(const Phrase& from, const Phrase& to, const Groups& groups);
  // Replaces the longest phrase that fits at each word; the result is never longer than `most` words.
  std::vector<std::string> apply(std::vector<std::string> words, std::size_t most) const;
  bool empty() const { return to_.empty(); }
  // All words that rules look for.
  const std::vector<std::string>& words() const { return words_; }

 private:
  struct Node {
    std::unordered_map<std::string, int> next;
    int rule = -1;
  };
  std::vector<Node> nodes_ = std::vector<Node>(1);
  std::vector<Phrase> to_;
  std::vector<std::string> words_;
};

}  // namespace goalnet::inference
