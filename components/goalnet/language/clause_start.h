// What kind of clause begins: the rules of ClauseParser::clause(), in the order in which they are tried.
#pragma once

#include <initializer_list>

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::ClauseStart : Rules {
 public:
  ClauseStart(ClauseParser& parser, std::size_t at, std::size_t end) : Rules(parser, at, end), i_(at) {}
  std::size_t read();

 private:
  using Rule = Read (ClauseStart::*)();
  // A reader of the parser that returns where it began when it does not fit.
  using Reader = std::size_t (ClauseParser::*)(std::size_t, std::size_t);

  Read first_that_fits(std::initializer_list<Reader> readers);
  // clause_parser.cc
  Read set_aside();
  Read by_first_word();
  Read whoever();
  Read let();
  Read later();
  Read excepted();
  Read correction();
  // clause_requests.cc: requests that begin with no verb
  Read with_tool();
  Read wish();
  Read addressed();
  Read asked_not();
  Read cannot();
  Read could_it_be();
  Read subordinate();
  Read place_first();
  Read thing_into_place(std::size_t at, NounPhrase& place);
  Read place_at_last(std::size_t at, NounPhrase& place);
  Read command();
  Read called_by_name();
  Read verb_nobody_knows();

  bool opens_command(std::size_t at) const { return parser_.opens_command(at, end_); }
  const std::string& word() const { return words_[i_]; }

  std::size_t i_;  // behind what joins it to the clause before
};

}  // namespace goalnet::inference
