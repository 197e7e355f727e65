// A command: its verb, then a rule for each word or phrase behind it.
#pragma once

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Command : Rules {
 public:
  Command(ClauseParser& parser, std::size_t at, std::size_t end, Mood mood);
  std::size_t read();

 private:
  // Where what it read ends; nothing where it does not fit. Where it is the same place, the command ends
  // there.
  using Rule = Read (Command::*)();

  Read verb_that_counts();
  void other_channel();
  Read next();
  Read list();
  Read instead();
  Read denied_thing();
  Read wished_state();
  Read wished_to_have();
  Read no_thing();
  Read wished_place();
  Read where_that_is();
  Read later();
  Read turn();
  Read except();
  Read caused();
  Read purpose();
  Read argument();
  void same_as_before();

  const Mood mood_;
  Clause clause_;
  Role role_ = Role::kDirect;
  Where where_ = Where::kTo;
  std::size_t i_;
  bool ended_ = false;
};

}  // namespace goalnet::inference
