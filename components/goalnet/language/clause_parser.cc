#include "components/goalnet/language/clause_parser.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/ellipsis.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

void ClauseParser::add(Clause clause) {
  if (clause.mood == Mood::kCommand && clause.condition.empty()) {
    clause.condition = conditional_.condition;
    clause.condition_number = conditional_.condition_number, clause.otherwise = conditional_.otherwise;
  }
  if (insert_before_ < result_.clauses.size()) {
    // "before putting the mug away, wash it": "it" was named by the clause that is done later
    name_pronouns(clause, result_.clauses[insert_before_]);
    result_.clauses.insert(result_.clauses.begin() + static_cast<long>(insert_before_), std::move(clause));
    insert_before_ = SIZE_MAX;
  } else {
    result_.clauses.push_back(std::move(clause));
  }
}

void ClauseParser::name_pronouns(Clause& clause, const Clause& by) const {
  const NounPhrase* named = by.first(Role::kDirect);
  if (named == nullptr || named->pronoun) return;
  for (NounPhrase& phrase : clause.phrases) {
    if (!phrase.pronoun || phrase.word == "there") continue;
    const Role role = phrase.role;
    const Where where = phrase.where;
    phrase = *named;
    phrase.role = role, phrase.where = where;
  }
}

ParsedSentence ClauseParser::parse() {
  for (std::size_t begin = 0; begin < words_.size();) {
    std::size_t end = begin;
    while (end < words_.size() && words_[end] != ".") ++end;
    for (std::size_t at = begin; at < end;) {
      const std::size_t next = clause(at, end);
      at = std::max(next, at + 1);
    }
    fronted_.clear();
    conditional_ = {};
    begin = end + 1;
  }
  return std::move(result_);
}

std::size_t ClauseParser::clause(std::size_t at, std::size_t end) {
  if (words_[at] == "told_of") {  // what a part named that was set aside
    add_told(at + 1, skip_part(at, end));
    return skip_part(at, end);
  }
  if (const std::size_t stop = third_person(at, end); stop != at) return stop;
  if (language_.hears_people() && words_[at] == "whoever") {  // "whoever left the tap on should be ashamed"
    add_told(at, part_end(at, end));
    return part_end(at, end);
  }
  if (const std::size_t stop = none_there(at, end); stop != at) return stop;
  if (const std::size_t stop = idle(at, end); stop != at) return stop;
  if (const std::size_t stop = of_the_same(at, end); stop != at) return stop;
  const std::size_t joined = at;
  at = skip_joins(at, end);
  if (at >= end) return at;
  if (at > joined) first_of_all(joined, at, end);
  if (at > joined)
    if (const std::size_t done = no_thing(at, end); done != at) return done;
  if (const std::size_t stop = third_person(at, end); stop != at) return stop;
  if (const std::size_t stop = idle(at, end); stop != at) return stop;
  if (const std::size_t stop = none_there(at, end); stop != at) return stop;
  if (const std::size_t stop = has_to_be(at, end); stop != at) return stop;
  const std::string& word = words_[at];
  if (word == "not" || word == "never" || word == "without") return forbidden(at, end);
  if (word == "ensure") return ensured(at, end);
  if (word == "let") {  // "let the water run"
    NounPhrase phrase;
    const std::size_t done = reader_.read(at + 1, end, phrase);
    if (done != at + 1 && !phrase.person && opens_command(done, end)) {
      fronted_ = {phrase};
      return command(done, end, Mood::kCommand);
    }
    return at + 1;
  }
  if (word == "use" || word == "using" || word == "with") {  // "use the spoon to scoop ice cream"
    NounPhrase phrase;
    std::size_t next = reader_.read(at + 1, end, phrase);
    const bool read = next != at + 1;
    while (read && next < end && (words_[next] == "to" || language_.joins(words_[next]))) ++next;
    if (read && opens_command(next, end)) {
      phrase.role = Role::kWith;
      fronted_ = {phrase};
      return command(next, end, Mood::kCommand);
    }
    if (read && word == "use" && ends_here(next, end)) {  // "use the water dispenser"
      Clause clause;
      clause.frame = Frame::kStart, clause.verb = "use";
      clause.phrases.push_back(std::move(phrase));
      add(std::move(clause));
      return next;
    }
  }
  if (word == "at_later") {  // "in an hour, turn the tv off": nobody here keeps time
    const std::size_t next = skip_joins(at + 1, end);
    const bool behind = at > 0 && words_[at - 1] != "." && words_[at - 1] != "," &&
                        !result_.clauses.empty() && result_.clauses.back().mood == Mood::kCommand;
    if (behind || opens_command(next, end)) for_later();
    return at + 1;
  }
  // "all of the books should be on the table, except for the one on the shelf"
  if (!result_.clauses.empty())
    if (const std::size_t done = except(at, end, result_.clauses.back()); done != at) return done;
  if (const std::size_t done = says_which(at, end); done != at) return done;
  if (word == "do_that") return done_that(at, end);
  if (word == "hint") return hint(at, end);
  // "bring the beer, no, I still have to drive, so the coke"
  const bool taken_back = language_.hears_people() && word == "no" && at > 0 && words_[at - 1] == "," &&
                          at + 1 < end && words_[at + 1] == "," && !result_.clauses.empty() &&
                          result_.clauses.back().mood == Mood::kCommand;
  if (word == "correction" || taken_back) return correction(at, end);
  if (word == "wish_to") return wish_to(at, end);
  NounPhrase person;
  const bool have_you = word == "have" && reader_.read(at + 1, end, person) != at + 1 && person.person;
  if (word == "wish" || (word == "have" && !have_you && reader_.starts(at + 1, end)))
    return command(at, end, Mood::kCommand);
  // "somebody get me a spoon", "you put the bowl there"; "somebody put the coke there" tells what happened
  const bool addressed = word == "you" || word == "somebody" || word == "someone" || word == "anybody";
  if (addressed && opens_command(at + 1, end) && !language_.participle(words_[at + 1]) &&
      (word == "you" || (words_[at + 1] != "put" && words_[at + 1] != "set" && words_[at + 1] != "shut")))
    return at + 1;
  if (language_.asks(word) && at + 1 < end && words_[at + 1] == "not") {
    if (opens_command(at + 2, end)) return at + 1;  // "do not turn off the tap"
    add_told(at, part_end(at, end));                // "does not matter which"
    return part_end(at, end);
  }
  // "I can never get this open": what somebody cannot do may be wanted
  if (word == "i" && at + 3 < end && words_[at + 1] == "can" && words_[at + 2] == "not" &&
      opens_command(at + 3, end)) {
    const std::size_t done = command(at + 3, end, Mood::kStatement);
    Clause& clause = result_.clauses.back();
    clause.wish = true;
    if (const Frame wanted = language_.wanted_by_state(clause.state); wanted != Frame::kNone)
      clause.frame = wanted, clause.verb = clause.state;
    return done;
  }
  if (NounPhrase subject;
      word == "can" || word == "could" || word == "may" || word == "should" || word == "would") {
    std::size_t done = reader_.read(at + 1, end, subject);
    for (NounPhrase more;
         language_.hears_people() && done != at + 1 && done + 1 < end && words_[done] == "and"; more = {}) {
      const std::size_t after =
          reader_.read(done + 1, end, more);  // "could the plate and the bowl be set on the table?"
      if (after == done + 1 || more.person) break;
      done = after;
    }
    if (done != at + 1 && !subject.person && done < end &&
        (words_[done] == "go" || words_[done] == "be" || words_[done] == "get" || words_[done] == "have" ||
         (language_.hears_people() && (words_[done] == "come" || words_[done] == "move")))) {
      ensured_ = true;  // "could the coffee go in the microwave?"
      const std::size_t stop = statement(at + 1, end);
      ensured_ = false;
      return stop;
    }
  }
  if (language_.asks(word) && at + 1 < end && language_.copula(words_[at + 1])) return question(at, end);
  // "so that I can sit", "so I can sit" say why; "so the coke please" goes on
  static constexpr std::array kOught = {"can"sv,  "should"sv, "must"sv,   "may"sv,  "could"sv,
                                        "goes"sv, "has"sv,    "belong"sv, "needs"sv};
  const bool that_ought =
      at + 2 < end && words_[at + 1] == "that" &&
      (one_of(words_[at + 2], kOught) || words_[at + 2] == "one" || that_thing_ought(at + 1, end));
  const bool purpose = at + 1 < end && !that_ought &&
                       (words_[at + 1] == "that" || words_[at + 1] == "i" || words_[at + 1] == "we" ||
                        words_[at + 1] == "nobody");
  if (one_of(word, kSubordinate) &&
      (word != "so" || (purpose && !opens_command(skip_joins(at + 1, end), end))))
    return subordinate(at, end);
  if (word == "so") return at + 1;
  if (told_on(at, end)) return command(at, end, Mood::kStatement);
  if (opens_command(at, end)) return command(at, end, Mood::kCommand);
  if (language_.asks(word)) return question(at, end);
  // "in the sink, put the mug"
  NounPhrase place;
  if (const std::size_t done = reader_.read_place(at, end, place); done != at) {
    std::size_t next = skip_joins(done, end);
    if (language_.hears_people() && next < end && words_[next] == "you" && opens_command(next + 1, end))
      ++next;  // "in the microwave you put the bowl"
    place.role = Role::kDestination;
    if (opens_command(next, end)) {
      fronted_ = {place};
      return next;
    }
    if (NounPhrase thing; done < end && words_[done] == "with") {  // "into the bin with the chips"
      const std::size_t after = reader_.read(done + 1, end, thing);
      if (after != done + 1 && !thing.unknown && !thing.person) {
        Clause clause;
        clause.frame = Frame::kPlace, clause.verb = "put";
        clause.phrases = {std::move(thing), std::move(place)};
        add(std::move(clause));
        return after;
      }
    }
    // "take out the bag ... to the bin I mean"
    if (!result_.clauses.empty() && result_.clauses.back().mood == Mood::kCommand && ends_here(done, end) &&
        result_.clauses.back().first(Role::kDirect) != nullptr) {
      Clause& last = result_.clauses.back();
      std::erase_if(last.phrases, [](const NounPhrase& old) { return old.role == Role::kDestination; });
      if (last.frame == Frame::kTake) last.frame = Frame::kPlace, last.to_person = false;
      last.phrases.push_back(std::move(place));
      return part_end(done, end);
    }
  }
  if ((at == 0 || words_[at - 1] == ".") && !language_.known(word) && opens_command(at + 1, end))
    return at + 1;  // "alexa turn the tap on"
  // "share the coffee, pour it into the glass": nobody knows how to share, but what comes next says it
  if (const std::size_t stop = part_end(at, end);
      language_.hears_people() && (at == 0 || words_[at - 1] == "." || words_[at - 1] == ",") &&
      stop + 1 < end && words_[stop] == "," && language_.english_verb(word) &&
      language_.verb(word) == Frame::kNone && reader_.starts(at + 1, stop) && !language_.copula(word) &&
      opens_command(skip_joins(stop, end), end) &&
      std::any_of(words_.begin() + static_cast<long>(stop), words_.begin() + static_cast<long>(end),
                  is_pronoun)) {
    add_told(at, stop);
    return stop;
  }
  if (const std::size_t stop = narrows(at, end); stop != at) return stop;
  if (const std::size_t stop = topic(at, end); stop != at) return stop;
  if (const std::size_t stop = verb_last(at, end); stop != at) return stop;
  if (const std::size_t stop = exclamation(at, end); stop != at) return stop;
  if (const std::size_t stop = told(at, end); stop != at) return stop;
  if (const std::size_t stop = aside(at, end); stop != at) return stop;
  return statement(at, end);
}

ParsedSentence parse_clauses(const Words& words, const Language& language, const Lexicon& lexicon) {
  if (!language.hears_people()) return ClauseParser(words, language, lexicon).parse();
  const Words whole = fill_ellipses(words, language, lexicon);
  return ClauseParser(whole, language, lexicon).parse();
}

}  // namespace goalnet::inference
