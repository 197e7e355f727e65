// What is not there, should not be there or is not wanted: "nothing should be on the stove", "no syrup".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "there is no water in the kettle": what somebody who says that would like; in a condition also "there is no
// disc in the xbox". `at` where it is none.
std::size_t ClauseParser::there_is_no(std::size_t at, std::size_t end) {
  if (at + 2 >= end || (words_[at + 2] != "no" && words_[at + 2] != "not")) return at;
  NounPhrase content, vessel;
  const std::size_t done = reader_.read(at + 3, end, content), after = reader_.read_place(done, end, vessel);
  if (done != at + 3 && after != done && language_.content(content.phrase) != symbol::kNone) {
    Clause clause;
    clause.mood = Mood::kStatement, clause.wish = true, clause.frame = Frame::kFill, clause.verb = "fill";
    content.role = Role::kWith, vessel.role = Role::kDirect;
    clause.phrases = {vessel, content};
    add(std::move(clause));
    return after;
  }
  if (judging_ && done != at + 3 && after != done && !content.unknown && !vessel.unknown) {
    Clause clause;  // "(if) there is no disc in the xbox"
    clause.mood = Mood::kStatement, clause.negative = true;
    content.at = {std::move(vessel)};
    clause.phrases = {std::move(content)};
    add(std::move(clause));
    return after;
  }
  return at;
}

// "nothing should be standing on the stove", "nothing but pillows belongs on the couch", "no book should be
// there"; `at` where it is none.
std::size_t ClauseParser::nothing_should(std::size_t at, std::size_t end) {
  if (words_[at] != "nothing" && words_[at] != "no") return at;
  std::size_t k = at + 1;
  NounPhrase only;  // "nothing but pillows belongs on the couch"
  if (language_.hears_people() && k + 1 < end && (words_[k] == "but" || words_[k] == "except"))
    k = std::max(reader_.read(k + 1, end, only), k + 1);
  NounPhrase none;
  if (language_.hears_people() && words_[at] == "no") k = reader_.read(k, end, none);
  bool wanted = ensured_ && language_.hears_people();  // "make sure nothing is left on the stove"
  for (; k < end && !language_.joins(words_[k]); ++k) {
    wanted = wanted || one_of(words_[k], kDesire);
    NounPhrase place;
    const std::size_t done = wanted ? reader_.read_place(k, end, place) : k;
    if (done == k) continue;
    Clause clause;
    clause.frame = Frame::kClear, clause.verb = "clear";
    clause.phrases.push_back(std::move(place));
    clause.phrases.back().role = Role::kSource;
    only.role = Role::kExcept;
    if (!only.bare()) clause.phrases.push_back(std::move(only));
    if (none.all = true; !none.bare() && !none.unknown) clause.phrases.push_back(std::move(none));
    add(std::move(clause));
    return done;
  }
  if (at + 1 < end && reader_.name_length(at + 1) > 0) {  // "no tv tonight"
    add_told(at + 1, part_end(at, end));
    return part_end(at, end);
  }
  return at;
}

// Behind "no": "(a scoop in the bowl,) no syrup", "(something to drink, but) no beer", "no book should be
// left on the couch"; `at` where it is none of these.
std::size_t ClauseParser::no_thing(std::size_t at, std::size_t end) {
  if (!language_.hears_people() || words_[at - 1] != "no") return at;
  NounPhrase none;
  const std::size_t done = reader_.read(at, end, none);
  if (done == at) return at;
  if (done < end && one_of(words_[done], kDesire)) return statement(at - 1, end);
  if (result_.clauses.empty() || reader_.name_length(at) == 0 || !ends_here(done, end)) return at;
  Clause& asked = result_.clauses.back();
  if (asked.mood == Mood::kCommand && (asked.frame == Frame::kTake || asked.frame == Frame::kBring) &&
      language_.content(none.phrase) == symbol::kNone) {
    none.role = Role::kExcept;
    asked.phrases.push_back(std::move(none));
  }
  return done;
}

}  // namespace goalnet::inference
