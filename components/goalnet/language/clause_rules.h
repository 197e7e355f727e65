// What readers that try a row of small rules have at hand: the parser they work for, its words, where they
// are.
#pragma once

#include <optional>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

class ClauseParser::Rules {
 protected:
  using Read =
      std::optional<std::size_t>;  // the first word that was not used; nothing where a rule does not fit

  Rules(ClauseParser& parser, std::size_t at, std::size_t end)
      : parser_(parser),
        words_(parser.words_),
        language_(parser.language_),
        lexicon_(*parser.lexicon_),
        reader_(parser.reader_),
        result_(parser.result_),
        at_(at),
        end_(end) {}

  bool people() const { return language_.hears_people(); }
  bool is(std::size_t i, const char* word) const { return i < end_ && words_[i] == word; }
  // Whether the clause read last is a command.
  bool after_command() const {
    return !result_.clauses.empty() && result_.clauses.back().mood == Mood::kCommand;
  }
  // Whether any word from `from` up to `to` is such a one.
  template <typename Fits>
  bool any_word(std::size_t from, std::size_t to, Fits fits) const {
    for (std::size_t k = from; k < to; ++k)
      if (fits(words_[k])) return true;
    return false;
  }

  ClauseParser& parser_;
  const std::vector<std::string>& words_;
  const Language& language_;
  const Lexicon& lexicon_;
  const NounPhraseReader& reader_;
  ParsedSentence& result_;
  const std::size_t at_, end_;  // what is read: words from `at_` on, up to `end_`
};

}  // namespace goalnet::inference
