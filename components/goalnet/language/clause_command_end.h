// What a command means once all of it is read.
#pragma once

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::CommandEnd : Rules {
 public:
  // `at`: behind the command.
  CommandEnd(ClauseParser& parser, Clause clause, std::size_t at, std::size_t end)
      : Rules(parser, at, end), clause_(std::move(clause)) {}
  void add();

 private:
  // clause_command_end.cc: what it asks for
  void wanted_state();
  void not_left_lying();
  void make_on_or_off();
  void under_tap();
  void only_perhaps();
  // clause_command_before.cc: what was said before it
  void there_too();
  void instead_of_before();
  bool left_after_all();
  void behind_what_was_taken();
  bool on_what_channel();
  bool back_where_it_belongs();
  bool channel_wondered_about();

  bool taken_back(NounPhrase& asked) const;
  bool ends_part() const { return at_ >= end_ || words_[at_] == ","; }

  Clause clause_;
};

}  // namespace goalnet::inference
