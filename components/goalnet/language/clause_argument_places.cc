// Behind a verb: where the thing should go, where it is, what belongs to it.
#include <algorithm>

#include "components/goalnet/language/clause_argument.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// Frames whose places say where the thing is, not where it should go: "take the cup on the counter".
bool locates(Frame frame) {
  return frame == Frame::kTake || frame == Frame::kWash || frame == Frame::kOpen || frame == Frame::kClose ||
         frame == Frame::kFill || frame == Frame::kTurn || frame == Frame::kStart || frame == Frame::kStop ||
         frame == Frame::kCool;
}
// Frames that put one thing to another with "with".
bool adds(Frame frame) {
  return frame == Frame::kFill || frame == Frame::kAdd || frame == Frame::kSqueeze || frame == Frame::kMake ||
         frame == Frame::kScoop || frame == Frame::kSwap || frame == Frame::kPour;
}

}  // namespace

// "put on the coffee table the bowl"
auto ClauseParser::Argument::place_before_thing() -> Read {
  if (word_ != "on" || clause_.frame != Frame::kPlace || !clause_.phrases.empty()) return {};
  NounPhrase there;
  const std::size_t done = reader_.read_place(at_, end_, there);
  if (done == at_ || !lexicon_.is_place_name(there.phrase) || !reader_.starts(done, end_)) return {};
  there.role = Role::kDestination;
  clause_.phrases.push_back(std::move(there));
  return done;
}

// "pour the coke in there"
auto ClauseParser::Argument::in_there() -> Read {
  NounPhrase there;
  if (!is(at_ + 1, "there") || !place_preposition(word_, &there.where)) return {};
  there.role = Role::kDestination, there.pronoun = true, there.word = "there";
  clause_.phrases.push_back(std::move(there));
  return at_ + 2;
}

auto ClauseParser::Argument::there() -> Read {
  if (word_ != "there") return {};
  if (people()) make_there_a_goal();
  if (clause_.frame != Frame::kPlace && clause_.frame != Frame::kBring) return {};
  NounPhrase there;
  there.role = Role::kDestination, there.pronoun = true, there.word = word_;
  clause_.phrases.push_back(std::move(there));
  return at_ + 1;
}

void ClauseParser::Argument::make_there_a_goal() {
  if (clause_.phrases.size() != 1) return;
  // "the sink is for dirty things, I would like both plates there"
  if (clause_.wish && parser_.ends_here(at_ + 1, end_) && !result_.clauses.empty())
    clause_.frame = Frame::kPlace, clause_.verb = "put", clause_.wish = false;
  // "and get the controller there as well"
  if (clause_.frame == Frame::kTake && !clause_.to_person && !clause_.wish &&
      (clause_.verb == "get" || clause_.verb == "take") &&
      std::any_of(result_.clauses.begin(), result_.clauses.end(), [](const Clause& before) {
        return before.first(Role::kDestination) != nullptr && before.mood == Mood::kCommand;
      }))
    clause_.frame = Frame::kPlace;
}

// "open the microwave and put the mug inside"
auto ClauseParser::Argument::inside() -> Read {
  if ((word_ != "inside" && word_ != "in") || reader_.starts(at_ + 1, end_) || clause_.phrases.empty() ||
      clause_.first(Role::kDestination) != nullptr ||
      !(clause_.frame == Frame::kPlace || clause_.frame == Frame::kBring || clause_.frame == Frame::kInsert))
    return {};
  NounPhrase it;
  it.role = Role::kDestination, it.where = Where::kIn, it.pronoun = true, it.word = "it";
  clause_.phrases.push_back(std::move(it));
  return at_ + 1;
}

// "(take the milk) from the fridge", "from inside the fridge", "from there"
auto ClauseParser::Argument::from() -> Read {
  if (word_ != "from") return {};
  role_ = Role::kSource;
  where_ = Where::kTo;
  NounPhrase phrase;
  std::size_t from = at_ + 1;
  Where inner = Where::kTo;
  if (from < end_ && place_preposition(words_[from], &inner) && words_[from] != "to") ++from;
  const std::size_t done = reader_.read(from, end_, phrase, true);
  if (done == from && is(from, "there")) {
    phrase.role = role_, phrase.pronoun = true, phrase.word = "there";
    clause_.phrases.push_back(std::move(phrase));
    return from + 1;
  }
  if (done == from) return at_ + 1;
  phrase.role = role_, phrase.where = inner;
  if (!phrase.hand && !phrase.person) clause_.phrases.push_back(std::move(phrase));
  return done;
}

// "(fill the mug) with coffee", "(take) the cup with coffee", "(scoop it) using the spoon"
auto ClauseParser::Argument::with() -> Read {
  if (word_ != "with" && word_ != "using" && word_ != "via") return {};
  NounPhrase phrase;
  const std::size_t done = reader_.read(at_ + 1, end_, phrase);
  if (done == at_ + 1) return done;
  if (phrase.unknown && !adds(clause_.frame) && one_of(words_[at_ + 1], kPossessives))
    return done;  // "with my fingers"
  // "the cup with coffee"
  if (!adds(clause_.frame) && role_ == Role::kDirect && !clause_.phrases.empty() &&
      phrase.adjectives.empty() && phrase.modifier.empty() &&
      language_.content(phrase.phrase) != symbol::kNone &&
      language_.holds_things(clause_.phrases.back().phrase) && clause_.phrases.back().content.empty()) {
    clause_.phrases.back().content = phrase.phrase;
    return done;
  }
  std::size_t after = done;
  if (NounPhrase there; people()) {  // "with the beer beside it"
    const std::size_t beside = reader_.read_place(done, end_, there);
    if (beside != done && there.pronoun) {
      after = beside;
      phrase.at = {std::move(there)};
    }
  }
  role_ = Role::kWith;
  phrase.role = role_;
  if (!phrase.hand && !phrase.person) clause_.phrases.push_back(std::move(phrase));
  return after;
}

// "(put the mug) in the sink", "(take the cup) on the counter", "(bring it) to me"
auto ClauseParser::Argument::place() -> Read {
  NounPhrase place;
  const std::size_t done = reader_.read_place(at_, end_, place);
  if (done == at_) return {};
  if (place.person || place.hand) {
    clause_.to_person = true;
    return done;
  }
  if (place.phrase.empty() && place.unknown && language_.time_unit(place.word)) return done;  // "in a minute"
  const bool moves =
      word_ == "to" || word_ == "into" || word_ == "onto" || word_ == "toward" || word_ == "towards";
  if (locates(clause_.frame) && !moves && !place.pronoun && !clause_.phrases.empty() &&
      clause_.phrases.back().role == Role::kDirect && !clause_.phrases.back().pronoun) {
    clause_.phrases.back().at.push_back(std::move(place));
    return done;
  }
  role_ = Role::kDestination, where_ = place.where;
  place.role = role_;
  clause_.phrases.push_back(std::move(place));
  return done;
}

}  // namespace goalnet::inference
