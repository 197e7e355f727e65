// The parser behind parse_clauses(): one pass over the words, a clause at a time.
#pragma once

#include "components/goalnet/language/clause.h"

namespace goalnet::inference {

class ClauseParser {
 public:
  ClauseParser(const Words& words, const Language& language, const Lexicon& lexicon)
      : all_words_(&words),
        words_(words.text),
        language_(language),
        lexicon_(&lexicon),
        reader_(words, language, lexicon) {}

  ParsedSentence parse();

 private:
  // The longer readers: rows of small rules, tried in order. See the files named like them.
  class Rules;
  class Argument;
  class ClauseStart;
  class Command;
  class CommandEnd;
  class Correction;
  class Fragment;
  class Predicate;
  class Statement;
  class Topic;

  // Each reads from word `at` and returns the first word it did not use; `end` is the end of the sentence.
  std::size_t clause(std::size_t at, std::size_t end);
  std::size_t command(std::size_t at, std::size_t end, Mood mood);
  std::size_t end_command(Clause clause, std::size_t at, std::size_t end);
  std::size_t argument(std::size_t at, std::size_t end, Clause& clause, Role& role, Where& where);
  std::size_t listed(std::size_t at, std::size_t end, Clause& clause, Role& role, Where& where);
  std::size_t short_again(std::size_t at, std::size_t end, Clause& clause);
  bool leaves_command(std::size_t at, std::size_t next, std::size_t end, const Clause& clause) const;
  bool begins_anew(std::size_t at, std::size_t next, std::size_t done, std::size_t end, const Clause& clause,
                   const NounPhrase& phrase, bool direct) const;
  std::size_t for_whom(std::size_t at, std::size_t end, Clause& clause);
  std::size_t particle(std::size_t at, std::size_t end, Clause& clause, Role& role);
  std::size_t statement(std::size_t at, std::size_t end);
  std::size_t from_several(std::size_t at, std::size_t end, NounPhrase& subject) const;
  std::size_t of_the_same(std::size_t at, std::size_t end);
  std::size_t predicate(std::size_t at, std::size_t end, Clause& clause, bool desired, bool negative);
  // "(on the table) rather than on the couch", "(the mug) instead of the glass", ", not on the xbox": passed
  // over, but for what should stay out of it; `at` where it is none.
  std::size_t instead_of(std::size_t at, std::size_t end, Clause& clause);
  // "(all of them should be on the table,) except for the one on the shelf"; `at` where it is none.
  std::size_t except(std::size_t at, std::size_t end, Clause& clause);
  // "(clear the couch,) only the snacks may stay on it"; "(drinks on the table,) both"; "(dirty dishes in the
  // sink,) so the plates and the bowl"; `at` where it is none.
  std::size_t says_which(std::size_t at, std::size_t end);  // the first of these that fits
  std::size_t only_stays(std::size_t at, std::size_t end);
  std::size_t all_of_them(std::size_t at, std::size_t end, const NounPhrase& said, std::size_t done);
  std::size_t namely(std::size_t at, std::size_t end);
  // "(make the tap) stop", "(get the microwave) humming"; `at` where it is none.
  std::size_t caused(std::size_t at, std::size_t end, Clause& clause) const;
  // "(could the plate) come down from the shelf and onto the table"; `at` where it is none.
  std::size_t comes(std::size_t at, std::size_t end, Clause& clause) const;
  // "(every armchair has) a pillow", of what holds or bears something; `at` where it is none.
  std::size_t has_thing(std::size_t at, std::size_t end, Clause& clause) const;
  std::size_t where_that_is(std::size_t at, std::size_t end, Clause& clause) const;
  std::size_t goes_in(std::size_t at, std::size_t end, Clause& clause) const;
  std::size_t state_of_place(std::size_t at, Clause& clause) const;
  std::size_t bears_thing(std::size_t at, std::size_t end, Clause& clause) const;
  std::size_t there_is_no(std::size_t at, std::size_t end);
  std::size_t nothing_should(std::size_t at, std::size_t end);
  std::size_t no_thing(std::size_t at, std::size_t end);
  std::size_t is_anything(std::size_t at, std::size_t end);
  std::size_t trade_places(std::size_t at, std::size_t end);
  std::size_t only_on(std::size_t at, std::size_t end);
  void but_this(std::size_t before);
  std::size_t holds_no(std::size_t at, std::size_t end, Clause& clause) const;
  // "(clear the stove) before you do": to be done before what was asked before it.
  std::size_t before_that(std::size_t at, std::size_t end);
  std::size_t denied(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::size_t not_that_one(std::size_t at, std::size_t end);
  std::size_t subject_but(std::size_t at, std::size_t end, NounPhrase& subject, NounPhrase& left_out) const;
  bool again(const Clause& fragment);
  bool says_nothing_here(std::size_t at, std::size_t end) const;
  std::size_t fragment(std::size_t at, std::size_t end);
  std::size_t question(std::size_t at, std::size_t end);
  std::size_t subordinate(std::size_t at, std::size_t end);
  std::size_t condition(std::size_t at, std::size_t end);
  std::size_t done_first(std::size_t at, std::size_t end);
  void as_state(Clause& clause) const;
  std::size_t otherwise(std::size_t at, std::size_t end);
  std::size_t forbidden(std::size_t at, std::size_t end);
  std::size_t ensured(std::size_t at, std::size_t end);
  std::size_t done_that(std::size_t at, std::size_t end);
  // "no pillows on the armchairs"; "does the tv have to be on?": what should not be so. `at` where it is
  // none.
  std::size_t none_there(std::size_t at, std::size_t end);
  std::size_t has_to_be(std::size_t at, std::size_t end);
  std::size_t hint(std::size_t at, std::size_t end);
  std::size_t wish_to(std::size_t at, std::size_t end);
  // Parts that ask for nothing: "my back is killing me", "bedtime, kids". They return `at` where it is none.
  std::size_t told(std::size_t at, std::size_t end);
  std::size_t does_not_know(std::size_t at, std::size_t end);
  std::size_t idle(std::size_t at, std::size_t end);
  // "no wait, the fork": mends the command before it.
  std::size_t correction(std::size_t at, std::size_t end);
  // "the fork, bring it to me": what "it" will mean.
  std::size_t topic(std::size_t at, std::size_t end);
  std::size_t verb_last(std::size_t at, std::size_t end);
  std::size_t narrows(std::size_t at, std::size_t end);
  bool ends_here(std::size_t at, std::size_t end) const;  // only small words up to the end of the part
  bool likes_doing(std::size_t at, std::size_t end) const;
  bool does_often(std::size_t at, std::size_t verb) const;
  void add_told(std::size_t at, std::size_t stop);
  std::size_t aside(std::size_t at, std::size_t end);
  bool tells_time(std::size_t at, std::size_t stop) const;
  std::size_t exclamation(std::size_t at, std::size_t end) const;
  std::size_t third_person(std::size_t at, std::size_t end);
  std::size_t part_end(std::size_t at, std::size_t end) const;
  bool tells(std::size_t at, std::size_t stop) const;
  std::size_t skip_part(std::size_t at, std::size_t end) const;  // to the next comma or the end

  void first_of_all(std::size_t joined, std::size_t at, std::size_t end);
  bool that_thing_ought(std::size_t at, std::size_t end) const;
  bool opens_command(std::size_t at, std::size_t end) const;
  bool told_on(std::size_t at, std::size_t end) const;
  bool starts_clause(std::size_t at, std::size_t end) const;
  std::size_t skip_joins(std::size_t at, std::size_t end) const;
  bool harmless(std::size_t at) const;
  void for_later();
  void add(Clause clause);
  void name_pronouns(Clause& clause, const Clause& by) const;

  const Words* all_words_;
  const std::vector<std::string>& words_;
  const Language& language_;
  const Lexicon* lexicon_;
  NounPhraseReader reader_;
  ParsedSentence result_;
  std::size_t insert_before_ = SIZE_MAX;  // where the next clause belongs ("before doing A, do B")
  Clause conditional_;                    // whose condition the commands of this sentence are under
  int conditions_ = 0;                    // so far
  bool judging_ = false;                  // reads what a condition says
  bool ensured_ = false;                  // "make sure that ..."
  std::vector<NounPhrase> fronted_;       // "in the sink, put ..."
};

}  // namespace goalnet::inference
