// Clauses that a small word opens: what is forbidden, made sure, wished, hinted at.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::none_there(std::size_t at, std::size_t end) {
  std::size_t no = at;
  while (no < end && words_[no] != "no" &&
         (words_[no] == "so" || language_.joins(words_[no]) ||
          (language_.filler(words_[no]) && !reader_.starts(no, end))))
    ++no;
  const std::size_t from = no + 1 < end && words_[no + 1] == "more" ? no + 2 : no + 1;
  if (!language_.hears_people() || from >= end || words_[no] != "no" || reader_.name_length(from) == 0)
    return at;
  NounPhrase things, place;
  const std::size_t done = reader_.read(from, end, things);
  const std::size_t after = reader_.read_place(done, end, place);
  if (done == from || after == done || things.unknown || place.unknown || place.person || place.hand ||
      !(ends_here(after, end) || one_of(words_[after], kSubordinate)))
    return at;
  Clause clause;
  clause.frame = Frame::kClear, clause.verb = "clear";
  things.role = Role::kDirect, things.all = true;
  place.role = Role::kSource, place.all = place.number == 0 && place.ordinal == 0;
  clause.phrases = {std::move(things), std::move(place)};
  add(std::move(clause));
  return after;
}

std::size_t ClauseParser::has_to_be(std::size_t at, std::size_t end) {
  const bool asks = words_[at] == "does" || words_[at] == "do" || words_[at] == "must";
  if (!language_.hears_people() || !asks || at + 1 >= end) return at;
  NounPhrase subject;
  std::size_t i = reader_.read(at + 1, end, subject);
  if (i == at + 1 || subject.person) return at;
  bool must = words_[at] == "must";
  while (i < end && words_[i] != "be" && words_[i] != "stay" && words_[i] != "stand" &&
         (harmless(i) || words_[i] == "have" || words_[i] == "need" || words_[i] == "to")) {
    must = must || words_[i] == "have" || words_[i] == "need";
    ++i;
  }
  if (!must || i + 1 >= end || !(words_[i] == "be" || words_[i] == "stay" || words_[i] == "stand")) return at;
  ++i;
  while (i < end && (words_[i] == "so" || words_[i] == "that" || words_[i] == "always")) ++i;
  Clause clause;
  clause.mood = Mood::kStatement;
  clause.phrases = {std::move(subject)};
  add(std::move(clause));
  return predicate(i, end, result_.clauses.back(), true, true);
}

// "do not open the fridge", "without the spoon", "never mind the mess".
std::size_t ClauseParser::forbidden(std::size_t at, std::size_t end) {
  const std::string& word = words_[at];
  if (const std::size_t done = not_that_one(at, end); done != at) return done;
  std::size_t verb = at + 1;
  while (verb < end && !opens_command(verb, end) && harmless(verb)) ++verb;
  if (opens_command(verb, end)) {
    const std::size_t before = result_.clauses.size();
    const std::size_t done = command(verb, end, Mood::kForbidden);
    but_this(before);
    return done;
  }
  const std::size_t gerund = at + 1;
  if (gerund < end && words_[gerund].size() > 5 && words_[gerund].ends_with("ing") &&
      !language_.known(words_[gerund])) {
    Clause clause;  // "without touching the coke", "without spilling anything"
    clause.mood = Mood::kForbidden, clause.frame = Frame::kTry, clause.verb = words_[gerund];
    NounPhrase phrase;
    const std::size_t done = reader_.read(gerund + 1, end, phrase);
    if (done != gerund + 1) clause.phrases.push_back(phrase);
    add(std::move(clause));
    return std::max(done, gerund + 1);
  }
  if (word == "without") {  // "without the spoon"
    NounPhrase phrase;
    const std::size_t done = reader_.read(verb, end, phrase);
    if (done != verb) return done;
  }
  if (NounPhrase left_out;
      words_[at + 1 < end ? at + 1 : at] != "wish") {  // "forget the fork", "not in the mug"
    std::size_t from = at + 1;                         // "not up there on the shelf"
    while (language_.hears_people() && from + 1 < end &&
           (words_[from] == "up" || words_[from] == "down" || words_[from] == "there"))
      ++from;
    std::size_t done = reader_.read_place(from, end, left_out);
    if (done == from) done = at + 1;
    if (language_.hears_people() && done != at + 1 && ends_here(done, end)) return done;  // "not in the mug"
    if (done == at + 1) done = reader_.read(at + 1, end, left_out);
    if (done != at + 1 && ends_here(done, end)) {
      add_told(at + 1, done);
      return done;
    }
  }
  // "no, not the one on the counter": which is not said, but nothing is asked of it
  if (NounPhrase where; at + 3 < end && words_[at + 1] == "the" && words_[at + 2] == "one") {
    const std::size_t done = reader_.read_place(at + 3, end, where);
    if (done != at + 3 && ends_here(done, end)) return done;
  }
  if (verb < end && words_[verb] == "wish") {  // "I do not want this coffee any more"
    const std::size_t done = command(verb, end, Mood::kForbidden);
    if (result_.clauses.back().mood == Mood::kForbidden) {
      Clause& unwanted = result_.clauses.back();
      unwanted.mood = Mood::kStatement;
      unwanted.negative = true;
      // "I do not want the coke on the stove"
      if (NounPhrase* thing = unwanted.phrases.size() == 1 ? &unwanted.phrases.front() : nullptr;
          language_.hears_people() && thing != nullptr && thing->at.size() == 1 && unwanted.unknown.empty()) {
        NounPhrase place = thing->at.front();
        place.role = Role::kSource;
        thing->at.clear();
        unwanted.negative = false, unwanted.wish = true, unwanted.frame = Frame::kTake,
        unwanted.verb = "take";
        unwanted.phrases.push_back(std::move(place));
      }
    }
    return done;
  }
  // "do not worry", "never mind the mess": what cannot be done is not done
  if (verb < end && language_.english_verb(words_[verb])) {
    add_told(at, part_end(at, end));
    return part_end(at, end);
  }
  if (result_.problem.empty()) result_.problem = "it is not clear what \"" + word + "\" rules out";
  return at + 1;
}

// "make sure that the fridge is closed and the tap is off".
std::size_t ClauseParser::ensured(std::size_t at, std::size_t end) {
  std::size_t next = at + 1;
  while (next < end && (words_[next] == "that" || words_[next] == "you" || words_[next] == "to")) ++next;
  if (opens_command(next, end)) return command(next, end, Mood::kCommand);
  ensured_ = true;
  std::size_t done = next < end ? statement(next, end) : next;
  // "... that the fridge is closed and the tap is off"
  while (done + 1 < end && words_[done] == "and" && !opens_command(done + 1, end) && tells(done + 1, end))
    done = std::max(statement(done + 1, end), done + 2);
  ensured_ = false;
  return done;
}

// "the tap is running, do something about it".
std::size_t ClauseParser::done_that(std::size_t at, std::size_t) {
  const auto says = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(), [](const Clause& clause) {
    return clause.mood != Mood::kStatement || !clause.state.empty();
  });
  if (language_.hears_people() && says != result_.clauses.rend() && says->mood == Mood::kStatement)
    says->asked = true;  // "the tv is on, though nobody watches, see to it"
  else if (!result_.clauses.empty() && result_.clauses.back().mood == Mood::kStatement)
    result_.clauses.back().asked = true;
  else if (language_.hears_people() && !result_.clauses.empty() &&
           result_.clauses.back().mood == Mood::kCommand)
    return at + 1;  // it is asked for already
  else if (result_.problem.empty() && result_.clauses.empty())
    result_.problem = "it is not clear what should be done";
  return at + 1;
}

// "I cannot find the remote".
std::size_t ClauseParser::hint(std::size_t at, std::size_t end) {
  // "I cannot find the remote"
  Clause clause;
  clause.mood = Mood::kStatement, clause.frame = Frame::kTake, clause.verb = "bring", clause.wish = true;
  NounPhrase phrase;
  const std::size_t done = reader_.read(at + 1, end, phrase);
  if (done == at + 1) return at + 1;
  clause.phrases.push_back(std::move(phrase));
  add(std::move(clause));
  return done;
}

// "I want to lie down, take everything off the couch".
std::size_t ClauseParser::wish_to(std::size_t at, std::size_t end) {
  // "I want to lie down, take everything off the couch"
  const std::size_t next = skip_joins(at + 1, end);
  const std::size_t count = result_.clauses.size();
  if (opens_command(next, end)) {
    const std::size_t done = command(next, end, Mood::kCommand);
    for (std::size_t i = count; i < result_.clauses.size(); ++i) {
      Clause& wanted = result_.clauses[i];
      wanted.weak = true;
      wanted.reason = one_of(wanted.verb, kPeopleDo) || wanted.frame == Frame::kGo;
    }
    return done;
  }
  add_told(at, part_end(at, end));
  return part_end(at, end);
}

// "why is the salt on the stove": nothing to do, but "it" means the salt from here on.
std::size_t ClauseParser::question(std::size_t at, std::size_t end) {
  Clause clause;
  clause.mood = Mood::kQuestion;
  std::size_t i = at + 1;
  while (i < end && !language_.joins(words_[i])) {
    NounPhrase phrase;
    std::size_t done = reader_.read_place(i, end, phrase);
    const bool place = done != i;
    if (!place) done = reader_.read(i, end, phrase);
    const bool first_thing = clause.first(Role::kDirect) == nullptr;
    if (language_.hears_people() && done != i && phrase.phrase == "channel" && phrase.number > 0) {
      clause.frame = Frame::kChange, clause.verb = "change";  // "is channel four any good? put it on"
      phrase.role = Role::kDirect;
      clause.phrases = {std::move(phrase)};
      i = done;
      continue;
    }
    if (done != i && !phrase.person && !phrase.unknown && !phrase.phrase.empty() && (place || first_thing)) {
      // "is that my book on the table?": which book
      if (place && language_.hears_people() && !clause.phrases.empty() &&
          (language_.copula(words_[at]) || words_[at] == "which") &&
          clause.phrases.back().role == Role::kDirect)
        clause.phrases.back().at.push_back(phrase);
      phrase.role = place ? Role::kDestination : Role::kDirect;
      clause.phrases.push_back(phrase);
    }
    i = std::max(done, i + 1);
  }
  add(std::move(clause));
  return i;
}

}  // namespace goalnet::inference
