// Words: their vectors, how object names split into words, and which words have meant which class of object.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference::network {

// "Tv_1Remote_1" -> words {tv, remote}, class "Tv_1Remote", instance 1; "Kettle" -> instance 0.
struct SplitName {
  std::string class_name;
  std::vector<std::string> words;  // lower case
  int instance = 0;                // the last number of the name, 0 without one
};
SplitName split_name(std::string_view object);

// Lets maps keyed by std::string be searched by std::string_view, without making a string.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
};
using TextMap = std::unordered_map<std::string, int, TextHash, std::equal_to<>>;

// How likely a word means a class of objects, counted from the demonstrations' groundings.
struct WordSense {
  int class_id = 0;
  float probability = 0;
};

// The words a model knows, in the order of its word tables, and the classes of objects it has seen.
class Lexicon {
 public:
  // `words`: unique, lower case. `senses` as in to_json.
  Lexicon(std::vector<std::string> words, std::vector<std::string> classes,
          std::map<std::string, std::map<std::string, float>> senses);

  int word(std::string_view text) const;      // -1 when unknown
  int class_of(std::string_view name) const;  // -1 when unknown
  const std::vector<WordSense>& senses(int word) const { return senses_[static_cast<std::size_t>(word)]; }
  const std::vector<std::string>& words() const { return words_; }
  const std::vector<std::string>& classes() const { return classes_; }

  // The metadata "goalnet.lexicon": {"words": [...], "classes": [...], "senses": {word: {class:
  // probability}}}.
  std::string to_json() const;
  static Expected<Lexicon> parse(const std::string& json);

 private:
  std::vector<std::string> words_, classes_;
  TextMap word_ids_, class_ids_;
  std::vector<std::vector<WordSense>> senses_;  // by word
};

}  // namespace goalnet::inference::network
