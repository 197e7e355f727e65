// Requests that begin with something else than their verb: "somebody get me ...", "could the coffee go in
// ...", "in the sink, put ...", "alexa turn ...".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_start.h"

namespace goalnet::inference {

using namespace word_group;

// "use the spoon to scoop ice cream", "use the water dispenser"
auto ClauseParser::ClauseStart::with_tool() -> Read {
  if (word() != "use" && word() != "using" && word() != "with") return {};
  NounPhrase phrase;
  std::size_t next = reader_.read(i_ + 1, end_, phrase);
  if (next == i_ + 1) return {};
  while (next < end_ && (words_[next] == "to" || language_.joins(words_[next]))) ++next;
  if (opens_command(next)) {
    phrase.role = Role::kWith;
    parser_.fronted_ = {phrase};
    return parser_.command(next, end_, Mood::kCommand);
  }
  if (word() != "use" || !parser_.ends_here(next, end_)) return {};
  Clause clause;
  clause.frame = Frame::kStart, clause.verb = "use";
  clause.phrases.push_back(std::move(phrase));
  parser_.add(std::move(clause));
  return next;
}

// "I would like the salt" (rewritten to "wish"), "have a coke"; "have somebody ..." asks that somebody does
// it
auto ClauseParser::ClauseStart::wish() -> Read {
  if (word() == "wish") return parser_.command(i_, end_, Mood::kCommand);
  NounPhrase person;
  if (word() != "have" || (reader_.read(i_ + 1, end_, person) != i_ + 1 && person.person) ||
      !reader_.starts(i_ + 1, end_))
    return {};
  return parser_.command(i_, end_, Mood::kCommand);
}

// "somebody get me a spoon", "you put the bowl there"; "somebody put the coke there" tells what happened
auto ClauseParser::ClauseStart::addressed() -> Read {
  static constexpr std::array kWho = {"you"sv, "somebody"sv, "someone"sv, "anybody"sv};
  static constexpr std::array kAlsoPast = {"put"sv, "set"sv, "shut"sv};
  if (!one_of(word(), kWho) || !opens_command(i_ + 1) || language_.participle(words_[i_ + 1]) ||
      (word() != "you" && one_of(words_[i_ + 1], kAlsoPast)))
    return {};
  return i_ + 1;
}

// "do not turn off the tap"; "does not matter which"
auto ClauseParser::ClauseStart::asked_not() -> Read {
  if (!language_.asks(word()) || !is(i_ + 1, "not")) return {};
  if (opens_command(i_ + 2)) return i_ + 1;
  const std::size_t stop = parser_.part_end(i_, end_);
  parser_.add_told(i_, stop);
  return stop;
}

// "I can never get this open": what somebody cannot do may be wanted
auto ClauseParser::ClauseStart::cannot() -> Read {
  if (word() != "i" || !is(i_ + 1, "can") || !is(i_ + 2, "not") || !opens_command(i_ + 3)) return {};
  const std::size_t done = parser_.command(i_ + 3, end_, Mood::kStatement);
  Clause& clause = result_.clauses.back();
  clause.wish = true;
  if (const Frame wanted = language_.wanted_by_state(clause.state); wanted != Frame::kNone)
    clause.frame = wanted, clause.verb = clause.state;
  return done;
}

// "could the coffee go in the microwave?", "could the plate and the bowl be set on the table?"
auto ClauseParser::ClauseStart::could_it_be() -> Read {
  static constexpr std::array kAsks = {"can"sv, "could"sv, "may"sv, "should"sv, "would"sv};
  static constexpr std::array kHappens = {"go"sv, "be"sv, "get"sv, "have"sv};
  static constexpr std::array kMoves = {"come"sv, "move"sv};
  if (one_of(word(), kAsks)) {
    NounPhrase subject;
    std::size_t done = reader_.read(i_ + 1, end_, subject);
    const bool named = done != i_ + 1;
    for (NounPhrase more; people() && named && is(done, "and") && done + 1 < end_; more = {}) {
      const std::size_t after = reader_.read(done + 1, end_, more);
      if (after == done + 1 || more.person) break;
      done = after;
    }
    if (named && !subject.person && done < end_ &&
        (one_of(words_[done], kHappens) || (people() && one_of(words_[done], kMoves)))) {
      parser_.ensured_ = true;
      const std::size_t stop = parser_.statement(i_ + 1, end_);
      parser_.ensured_ = false;
      return stop;
    }
  }
  if (language_.asks(word()) && i_ + 1 < end_ && language_.copula(words_[i_ + 1]))
    return parser_.question(i_, end_);
  return {};
}

// "before", "because"; "so that I can sit", "so I can sit" say why, "so the coke please" goes on
auto ClauseParser::ClauseStart::subordinate() -> Read {
  static constexpr std::array kOught = {"can"sv,  "should"sv, "must"sv,   "may"sv,  "could"sv,
                                        "goes"sv, "has"sv,    "belong"sv, "needs"sv};
  static constexpr std::array kWhy = {"that"sv, "i"sv, "we"sv, "nobody"sv};
  if (!one_of(word(), kSubordinate)) return {};
  if (word() != "so") return parser_.subordinate(i_, end_);
  const bool that_ought =
      i_ + 2 < end_ && words_[i_ + 1] == "that" &&
      (one_of(words_[i_ + 2], kOught) || words_[i_ + 2] == "one" || parser_.that_thing_ought(i_ + 1, end_));
  const bool why = i_ + 1 < end_ && !that_ought && one_of(words_[i_ + 1], kWhy);
  if (why && !opens_command(parser_.skip_joins(i_ + 1, end_))) return parser_.subordinate(i_, end_);
  return i_ + 1;
}

auto ClauseParser::ClauseStart::command() -> Read {
  if (parser_.told_on(i_, end_)) return parser_.command(i_, end_, Mood::kStatement);
  if (opens_command(i_)) return parser_.command(i_, end_, Mood::kCommand);
  if (language_.asks(word())) return parser_.question(i_, end_);
  return {};
}

// "in the sink, put the mug", "in the microwave you put the bowl"
auto ClauseParser::ClauseStart::place_first() -> Read {
  NounPhrase place;
  const std::size_t done = reader_.read_place(i_, end_, place);
  if (done == i_) return {};
  std::size_t next = parser_.skip_joins(done, end_);
  if (people() && is(next, "you") && opens_command(next + 1)) ++next;
  place.role = Role::kDestination;
  if (opens_command(next)) {
    parser_.fronted_ = {place};
    return next;
  }
  if (const Read thing = thing_into_place(done, place)) return thing;
  return place_at_last(done, place);
}

// "into the bin with the chips"
auto ClauseParser::ClauseStart::thing_into_place(std::size_t at, NounPhrase& place) -> Read {
  if (!is(at, "with")) return {};
  NounPhrase thing;
  const std::size_t after = reader_.read(at + 1, end_, thing);
  if (after == at + 1 || thing.unknown || thing.person) return {};
  Clause clause;
  clause.frame = Frame::kPlace, clause.verb = "put";
  clause.phrases = {std::move(thing), std::move(place)};
  parser_.add(std::move(clause));
  return after;
}

// "take out the bag ... to the bin I mean"
auto ClauseParser::ClauseStart::place_at_last(std::size_t at, NounPhrase& place) -> Read {
  if (!after_command() || !parser_.ends_here(at, end_) ||
      result_.clauses.back().first(Role::kDirect) == nullptr)
    return {};
  Clause& last = result_.clauses.back();
  std::erase_if(last.phrases, [](const NounPhrase& old) { return old.role == Role::kDestination; });
  if (last.frame == Frame::kTake) last.frame = Frame::kPlace, last.to_person = false;
  last.phrases.push_back(std::move(place));
  return parser_.part_end(at, end_);
}

// "alexa turn the tap on"
auto ClauseParser::ClauseStart::called_by_name() -> Read {
  if ((i_ > 0 && words_[i_ - 1] != ".") || language_.known(word()) || !opens_command(i_ + 1)) return {};
  return i_ + 1;
}

// "share the coffee, pour it into the glass": nobody knows how to share, but what comes next says it
auto ClauseParser::ClauseStart::verb_nobody_knows() -> Read {
  const std::size_t stop = parser_.part_end(i_, end_);
  const bool begins = i_ == 0 || words_[i_ - 1] == "." || words_[i_ - 1] == ",";
  if (!people() || !begins || !is(stop, ",") || stop + 1 >= end_ || !language_.english_verb(word()) ||
      language_.verb(word()) != Frame::kNone || !reader_.starts(i_ + 1, stop) || language_.copula(word()) ||
      !opens_command(parser_.skip_joins(stop, end_)) || !any_word(stop, end_, is_pronoun))
    return {};
  parser_.add_told(i_, stop);
  return stop;
}

}  // namespace goalnet::inference
