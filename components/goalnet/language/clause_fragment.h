// Requests without a verb: their things, then one of these rules.
#pragma once

#include "components/goalnet/language/clause_rules.h"

namespace goalnet::inference {

class ClauseParser::Fragment : Rules {
 public:
  Fragment(ClauseParser& parser, std::size_t at, std::size_t end) : Rules(parser, at, end) {}
  std::size_t read();

 private:
  using Rule = Read (Fragment::*)();

  // clause_fragment_things.cc
  void things();
  void more_things();
  void left_out();
  void served_with();
  void sources();
  void out_of();
  // clause_fragment.cc
  Read one_of_nothing();
  Read other_than();
  Read place_told_again();
  Read unknown_thing();
  Read switched();
  Read too_much();
  Read in_state();
  Read channel();
  Read too();
  Read and_that();
  Read asked_for();
  Read as_before();
  Read says_nothing();
  // clause_fragment_places.cc
  Read place_behind_pause();
  Read in();
  Read in_there();
  Read off_place();
  Read for_place();
  Read to_somebody();
  Read to_place();
  Read listed_then_place();
  Read content_then_place();
  Read things_then_place();
  Read thing_then_place();
  Read place_alone();
  void split_modifiers(Clause& clause) const;
  std::size_t more_places(std::size_t at, Where where);
  std::size_t topping(std::size_t at, const NounPhrase& place, NounPhrase& with) const;

  // What stands behind the things, up to the end of the part.
  struct Behind {
    bool harmless = false;  // small words only
    bool polite = false;    // "please", "for me"
  };
  Behind behind() const;
  bool polite() const;
  // Takes the clause as one that asks for this and returns `next`.
  std::size_t ask(Frame frame, const char* verb, std::size_t next);
  std::size_t ask_to_bring(std::size_t next);

  Clause clause_;
  NounPhrase subject_;  // the first of its things
  std::size_t i_ = 0;   // behind its things
};

}  // namespace goalnet::inference
