#include "components/goalnet/language/sentence_parts.h"

#include <algorithm>
#include <array>
#include <set>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace word_group;

constexpr std::array kOpeners = {
    "so"sv,     "because"sv,  "cause"sv,  "cuz"sv,       "coz"sv,    "cos"sv,    "since"sv,
    "but"sv,    "as"sv,       "while"sv,  "before"sv,    "after"sv,  "when"sv,   "whenever"sv,
    "though"sv, "although"sv, "until"sv,  "till"sv,      "who"sv,    "which"sv,  "for"sv,
    "like"sv,   "if"sv,       "unless"sv, "otherwise"sv, "except"sv, "instead"sv};
constexpr std::array kAskingModals = {"can"sv, "could"sv, "would"sv, "will"sv, "might"sv};
constexpr std::array kShortened = {"im"sv,  "ive"sv,  "id"sv,     "ill"sv,   "were"sv, "weve"sv,
                                   "hes"sv, "shes"sv, "theyre"sv, "youre"sv, "youve"sv};
// Before these a verb is no command of its own.
constexpr std::array kBeforeVerbs = {
    "to"sv,     "i"sv,     "we"sv,   "you"sv,    "they"sv,    "he"sv,     "she"sv,    "it"sv,   "can"sv,
    "could"sv,  "would"sv, "will"sv, "should"sv, "must"sv,    "may"sv,    "might"sv,  "and"sv,  "then"sv,
    "please"sv, "or"sv,    "not"sv,  "dont"sv,   "the"sv,     "a"sv,      "an"sv,     "my"sv,   "your"sv,
    "just"sv,   "lets"sv,  "us"sv,   "go"sv,     "and"sv,     "some"sv,   "this"sv,   "that"sv, "of"sv,
    "in"sv,     "on"sv,    "at"sv,   "for"sv,    "never"sv,   "always"sv, "kindly"sv, "also"sv, "two"sv,
    "his"sv,    "her"sv,   "our"sv,  "their"sv,  "no"sv,      "is"sv,     "are"sv,    "was"sv,  "do"sv,
    "need"sv,   "let"sv,   "help"sv, "cant"sv,   "couldnt"sv, "didnt"sv,  "wont"sv,   "didn"sv, "who"sv};

bool pauses(const std::string& token) { return token == "." || token == "," || token == ":"; }

class PartReader {
 public:
  PartReader(const std::vector<std::string>& tokens, const Language& language) : language_(language) {
    for (const std::string& token : tokens) {
      words_.push_back(language.known(token) || language.real_word(token) ? token : language.correct(token));
      kinds_.push_back(kind(words_.back()));
    }
  }

  std::vector<SentencePart> parts() const;

 private:
  std::string kind(const std::string& word) const;
  bool begins(std::size_t i) const;
  bool tells(std::size_t i) const;
  void add_signs(std::size_t index, std::vector<SentencePart>& parts) const;

  const Language& language_;
  std::vector<std::string> words_, kinds_;  // spelled right; THING, DO, DID, NUM, PERSON or the word itself
};

std::string PartReader::kind(const std::string& word) const {
  const std::string stem = singular(word);
  if (number_word(word) > 0 || (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos))
    return "NUM";
  if (language_.person(word) || language_.person(stem)) return "PERSON";
  const bool verb = language_.verb(word) != Frame::kNone;
  if (language_.names_thing(word) || language_.names_thing(stem) || language_.content(stem) != symbol::kNone)
    return verb ? "DOTHING" : "THING";
  if (verb) return language_.verb_base(word) == word ? "DO" : "DID";
  return word;
}

// "the kids are ...", "my mug broke": a subject and a verb follow.
bool PartReader::tells(std::size_t i) const {
  constexpr std::size_t kLongestTeller = 4;
  if (!one_of(words_[i], kDeterminers) && !one_of(words_[i], kPossessives))
    return one_of(words_[i], kSubjects);
  for (std::size_t k = i + 2; k < words_.size() && k <= i + kLongestTeller && !pauses(words_[k]); ++k)
    if (language_.copula(words_[k]) || words_[k] == "'s") return true;
  return false;
}

// Whether a part begins at word `i`, behind another word.
bool PartReader::begins(std::size_t i) const {
  const std::string& word = words_[i];
  const std::string& before = words_[i - 1];
  const std::string next = i + 1 < words_.size() ? words_[i + 1] : ".";
  if (pauses(next)) return false;
  if (one_of(word, kOpeners))
    return word != "like" || (before != "would" && before != "id" && before != "i" && before != "you");
  if (word == "and" || word == "then" || word == "or" || word == "please") {
    std::size_t k = i + 1;
    while (k + 1 < words_.size() && (words_[k] == "then" || words_[k] == "also" || words_[k] == "please"))
      ++k;
    return kinds_[k] == "DO" || kinds_[k] == "DOTHING" || one_of(words_[k], kAskingModals) || tells(k) ||
           language_.english_verb(words_[k]) || one_of(words_[k], kShortened);
  }
  if (one_of(before, kOpeners) || before == "and" || before == "then" || before == "please" ||
      before == "that")
    return false;
  if (word == "that") return one_of(next, kSubjects) || one_of(next, kPossessives);
  if (one_of(word, kAskingModals))
    return next == "you" || next == "someone" || next == "somebody" || next == "we";
  if (one_of(word, kShortened)) return true;
  if (word == "i" || word == "we")
    return !one_of(before, kAskingModals) && before != "do" && before != "than" && before != "what" &&
           before != "where";
  const bool thing_behind = one_of(next, kDeterminers) || one_of(next, kPossessives) ||
                            one_of(next, kPointers) || is_pronoun(next) || next == "me" || next == "us";
  return kinds_[i] == "DO" && thing_behind && !one_of(before, kBeforeVerbs) && kinds_[i - 1] != "PERSON";
}

std::vector<SentencePart> PartReader::parts() const {
  std::vector<SentencePart> parts;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (pauses(words_[i])) continue;
    const bool first = i == 0 || pauses(words_[i - 1]);
    if (first || begins(i))
      parts.push_back({.begin = i, .end = i + 1, .within = !first, .signs = {}});
    else
      parts.back().end = i + 1;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) add_signs(i, parts);
  return parts;
}

void PartReader::add_signs(std::size_t index, std::vector<SentencePart>& parts) const {
  const std::size_t begin = parts[index].begin, end = parts[index].end;
  std::set<std::string> signs;
  const auto at = [&](std::size_t i) { return i < end ? kinds_[i] : std::string("END"); };
  std::size_t head = begin;  // behind "so", "and", "please"
  while (head + 1 < end && (one_of(words_[head], kOpeners) || words_[head] == "and" ||
                            words_[head] == "please" || words_[head] == "then"))
    ++head;
  signs.insert("opens " + words_[begin]);
  signs.insert("opens " + at(begin) + " " + at(begin + 1));
  signs.insert("head " + at(head));
  signs.insert("head " + at(head) + " " + at(head + 1));
  signs.insert("head " + at(head) + " " + at(head + 1) + " " + at(head + 2));
  signs.insert("last " + at(end - 1));
  for (std::size_t i = begin; i < end; ++i) {
    const std::string& word = words_[i];
    signs.insert(kinds_[i]);
    if (kinds_[i] == "DO" || kinds_[i] == "DID" || kinds_[i] == "DOTHING")
      signs.insert("verb " + language_.verb_base(word));
    if (i + 1 < end) signs.insert(kinds_[i] + " " + kinds_[i + 1]);
    if (word.size() > 4 && word.ends_with("ed")) signs.insert("-ed");
    if (word.size() > 5 && word.ends_with("ing")) signs.insert("-ing");
    const bool verb = kinds_[i] != "DO" && language_.english_verb(word);
    if (verb && i > begin) signs.insert("told by " + kinds_[i - 1]);
    if (one_of(word, kSubjects)) signs.insert("SUBJECT");
    if (!language_.known(word)) signs.insert("unknown");
  }
  const std::size_t length = end - begin;
  signs.insert(length == 1   ? "one word"
               : length == 2 ? "two words"
               : length < 5  ? "short"
               : length < 9  ? "long"
                             : "longest");
  signs.insert(parts[index].within ? "begins within"
               : begin == 0        ? "begins all"
                                   : "begins behind " + words_[begin - 1]);
  const std::string behind = end < words_.size() ? (pauses(words_[end]) ? words_[end] : "part") : ".";
  signs.insert("ends at " + behind);
  signs.insert(parts.size() == 1           ? "only"
               : index == 0                ? "first"
               : index + 1 == parts.size() ? "last part"
                                           : "between");
  parts[index].signs.assign(signs.begin(), signs.end());
}

}  // namespace

std::vector<SentencePart> sentence_parts(const std::vector<std::string>& tokens, const Language& language) {
  return PartReader(tokens, language).parts();
}

std::vector<std::string> without_parts(const std::vector<std::string>& tokens,
                                       const std::vector<SentencePart>& parts, const std::vector<bool>& aside,
                                       const Language& language, const Lexicon& lexicon) {
  std::vector<std::string> kept;
  std::size_t done = 0;
  const auto keep_to = [&](std::size_t end) {
    for (; done < end; ++done)
      if (!pauses(tokens[done]) || (!kept.empty() && !pauses(kept.back()))) kept.push_back(tokens[done]);
  };
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!aside[p]) continue;
    keep_to(parts[p].begin);
    if (tokens[parts[p].begin] == "not") {  // "..., not from a can": what is denied is not "it"
      done = parts[p].end;
      continue;
    }
    // What it names: names with the words that belong to them.
    std::vector<std::string> things;
    for (std::size_t i = parts[p].begin; i < parts[p].end; ++i) {
      const std::string stem = singular(tokens[i]);
      const bool modal = tokens[i] == "can" && (i == parts[p].begin || one_of(tokens[i - 1], kSubjects));
      if (modal || stem.size() < 3 || one_of(stem, kOpeners)) continue;
      if (!lexicon.is_word_of_name(stem) && language.content(stem) == symbol::kNone) continue;
      const bool goes_on = !things.empty() && i > parts[p].begin && things.back() == tokens[i - 1];
      if (!goes_on) things.insert(things.end(), {",", "told_of", "the"});
      things.push_back(tokens[i]);
    }
    if (!things.empty()) {
      if (kept.empty() || pauses(kept.back())) things.erase(things.begin());
      kept.insert(kept.end(), things.begin(), things.end());
      kept.emplace_back(",");
    }
    done = parts[p].end;
  }
  keep_to(tokens.size());
  return kept;
}

}  // namespace goalnet::inference
