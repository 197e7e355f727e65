// What may stand behind a verb, a word or phrase at a time.
#pragma once

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Argument : Rules {
 public:
  // `role` and `where` are those that a thing without a preposition has here; what is read changes them.
  Argument(ClauseParser& parser, std::size_t at, std::size_t end, Clause& clause, Role& role, Where& where)
      : Rules(parser, at, end), word_(words_[at]), clause_(clause), role_(role), where_(where) {}
  std::size_t read();

 private:
  using Rule = Read (Argument::*)();

  // clause_arguments.cc
  Read caused();
  Read state();
  Read participle();
  Read particle();
  Read on_alone();
  Read noun_for_verb();
  Read first_of_all();
  Read here();
  Read moment();
  Read for_whom();
  Read second_verb();
  Read thing();
  Read speaker();
  Read unknown_place();
  std::size_t other_word();
  // clause_argument_places.cc
  Read place_before_thing();
  Read in_there();
  Read told_in_there() { return people() ? in_there() : Read{}; }
  Read there();
  Read inside();
  Read from();
  Read with();
  Read place();

  void make_there_a_goal();

  const std::string& word_;
  Clause& clause_;
  Role& role_;
  Where& where_;
};

}  // namespace goalnet::inference
