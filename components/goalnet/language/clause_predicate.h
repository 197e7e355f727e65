// What a statement says of its subject, word by word: a row of small rules, tried in order at each word.
#pragma once

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Predicate : Rules {
 public:
  Predicate(ClauseParser& parser, std::size_t at, std::size_t end, Clause& clause, bool desired,
            bool negative)
      : Rules(parser, at, end), clause_(clause), desired_(desired), negative_(negative), i_(at) {}
  std::size_t read();

 private:
  // Each says whether it fits; it goes on behind what it used, or tells in `done_` where the predicate ends.
  using Rule = bool (Predicate::*)();

  bool goes_on() const;
  bool hangs_on(std::size_t at) const;
  bool states(std::size_t at) const;
  bool went_on(std::size_t next);
  bool ended(std::size_t next);
  void command(Frame frame, const char* verb);
  // clause_predicate.cc
  bool ends();
  bool wished();
  bool told();
  bool instead();
  bool not_there();
  bool verb();
  void arguments();
  bool state();
  void full_of();
  // clause_predicate_things.cc: places and things
  bool off_place();
  bool at_place();
  bool only_told_of_tv(const NounPhrase& place) const;
  bool under_if() const;
  bool should_hold();
  bool holds();
  bool on_each();
  bool needs();
  bool with_thing_going();

  bool wants() const { return desired_ && !negative_ && clause_.mood == Mood::kStatement; }
  const std::string& word() const { return words_[i_]; }

  Clause& clause_;
  const bool desired_, negative_;
  std::size_t i_;
  std::optional<std::size_t> done_;
};

}  // namespace goalnet::inference
