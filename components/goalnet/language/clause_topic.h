// A thing named before what is to be done with it: "the fork, bring it to me".
#pragma once

#include <vector>

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Topic : Rules {
 public:
  Topic(ClauseParser& parser, std::size_t at, std::size_t end) : Rules(parser, at, end) {}
  std::size_t read();  // where it stands at the beginning: there is none

 private:
  // what is named
  void more_things();
  void places();
  void more_in_places();
  void state();
  // what is said of it
  bool told_of_later() const;
  bool is_what_it_was();
  bool verb_and_place() const;
  bool fetched_from_there() const;
  bool verb_alone() const;
  bool refers(std::size_t next) const;
  bool subject_again(std::size_t next) const;
  std::size_t command_about_them();
  std::size_t then_it();

  bool another(const NounPhrase& thing) const { return !thing.pronoun && !thing.unknown && !thing.person; }

  NounPhrase phrase_;
  std::vector<NounPhrase> more_;
  std::size_t done_ = 0;
  bool named_only_ = false;  // no place behind it
  bool definite_ = false;    // "the fork"
  bool already_ = false;     // "kettle's already full"
};

}  // namespace goalnet::inference
