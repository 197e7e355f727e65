// What takes back or changes a part of a command before it: "no wait, the fork", "no, up", "make that two".
#pragma once

#include <vector>

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Correction : Rules {
 public:
  Correction(ClauseParser& parser, std::size_t at, std::size_t end) : Rules(parser, at, end), next_(at) {}
  std::size_t read();

 private:
  using Rule = Read (Correction::*)();

  // clause_correction.cc: what is mended
  void skip_small_words();
  void denied();
  void skip_reason();
  void drop_unfinished();
  Clause* mended_command();
  Read said_anew(std::size_t anew);
  std::size_t unread() const { return std::max(next_, at_ + 1); }
  bool denies(const NounPhrase& old) const;
  bool told_which() const { return !not_this_.phrase.empty() || not_this_.number > 0; }
  // clause_correction_words.cc: by a word
  Read other_way();
  Read other_state();
  Read all_of_them();
  Read number();
  void suffices();
  // clause_correction_things.cc: by a thing or place
  std::size_t thing();
  void read_thing();
  void place_of_thing();
  Read count();
  Read goes_on();
  Read same_number();
  Read in_place_of_denied();
  Read from_elsewhere();
  Read other_source();
  void as_unknown_or_only_place();
  std::size_t in_its_place();
  std::size_t command_anew();

  std::size_t next_;     // behind "no wait", where what is meant begins
  NounPhrase not_this_;  // "the egg" of "not the egg, the syrup"
  Clause* last_ = nullptr;
  NounPhrase phrase_;     // what is meant,
  std::size_t done_ = 0;  // where it ends,
  Role role_ = Role::kDirect;
};

}  // namespace goalnet::inference
