// Statements, wishes: what they are about, the words before what is told of it, then predicate().
#pragma once

#include <vector>

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Statement : Rules {
 public:
  Statement(ClauseParser& parser, std::size_t at, std::size_t end) : Rules(parser, at, end), i_(at) {}
  std::size_t read();

 private:
  // clause_statements.cc
  Read there_should_be();
  void skip_there();
  Read about_somebody();
  bool somebody_left();
  Read thirsty(std::size_t stop);
  Read what_somebody_did(std::size_t k, std::size_t stop);
  Read louder();
  Read names_nothing(bool person);
  std::size_t about_subjects();
  // clause_statement_subjects.cc
  void places_of_subject();
  void subjects();
  std::size_t more_subjects(std::vector<NounPhrase>& subjects);
  bool only_small_word(std::size_t k) const;
  void verbs();
  void may(std::size_t k);

  std::size_t i_;
  bool there_ = false;     // "there is ...", "here is ..."
  bool desired_ = false;   // "should", "has to"
  bool negative_ = false;  // "not"
  bool supposed_ = false;  // "should": may only tell where it is thought to be
  bool verb_seen_ = false;
  NounPhrase subject_;
  std::size_t named_ = 0;             // where the name of the subject ends
  std::vector<NounPhrase> subjects_;  // "xbox and controller (belong on the table)"
};

}  // namespace goalnet::inference
