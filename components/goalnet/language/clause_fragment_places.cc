// Requests without a verb that name a place: "spoon in sink", "water in", "coke fridge", "plates sink".
#include <array>

#include "components/goalnet/language/clause_fragment.h"

namespace goalnet::inference {

using namespace word_group;

// "the bowl, into the microwave": the pause says nothing
auto ClauseParser::Fragment::place_behind_pause() -> Read {
  if (!is(i_, ",") || i_ + 1 >= end_ || !place_preposition(words_[i_ + 1])) return {};
  NounPhrase place;
  const std::size_t done = reader_.read_place(i_ + 1, end_, place);
  if (done != i_ + 1 && !place.person && parser_.ends_here(done, end_)) ++i_;
  return {};
}

// "water in": into what was spoken of
auto ClauseParser::Fragment::in() -> Read {
  if (!is(i_, "in") && !is(i_, "into") && !(people() && is(i_, "inside"))) return {};
  if (i_ + 1 < end_ && !language_.joins(words_[i_ + 1])) return {};
  clause_.particles = {"in"};
  return ask(Frame::kPlace, "put", i_ + 1);
}

// "coke in there too"
auto ClauseParser::Fragment::in_there() -> Read {
  NounPhrase there;
  if (!is(i_ + 1, "there") || !place_preposition(words_[i_], &there.where)) return {};
  there.role = Role::kDestination, there.pronoun = true, there.word = "there";
  clause_.phrases.push_back(std::move(there));
  return ask(Frame::kPlace, "put", i_ + 2);
}

// "everything off the stove", "spoon out of the mug"
auto ClauseParser::Fragment::off_place() -> Read {
  const bool out_of = people() && is(i_, "out") && is(i_ + 1, "of") && i_ + 2 < end_;
  if (i_ + 1 >= end_ || !(is(i_, "off") || out_of)) return {};
  NounPhrase place, to;
  const std::size_t from = out_of ? i_ + 2 : i_ + 1;
  const std::size_t done = reader_.read(from, end_, place, true);
  const bool moves = out_of && reader_.read_place(done, end_, to) != done;
  if (done == from || place.unknown || place.person || moves) return {};
  place.role = Role::kSource;
  clause_.phrases.push_back(std::move(place));
  return ask(Frame::kTake, "take", done);
}

// "a pillow for every armchair", "one long cup for coke"
auto ClauseParser::Fragment::for_place() -> Read {
  if (!is(i_, "for") || i_ + 1 >= end_) return {};
  NounPhrase place;
  const std::size_t done = reader_.read(i_ + 1, end_, place, true);
  if (done == i_ + 1) return {};
  const bool drink = language_.content(place.phrase) != symbol::kNone;
  if (people() && drink && parser_.ends_here(done, end_) && language_.holds_things(subject_.phrase) &&
      subject_.content.empty()) {
    place.role = Role::kWith;
    clause_.phrases.push_back(std::move(place));
    return ask(Frame::kFill, "fill", done);
  }
  const bool named_place = lexicon_.is_place_name(place.phrase);
  const bool holds = language_.holds_things(place.phrase);
  const bool holder =
      people() && !place.unknown && !place.person && (named_place || holds || (subject_.some && drink));
  if (!holder && !(place.all && named_place)) return {};
  place.role = Role::kDestination, place.where = holds ? Where::kIn : Where::kOn;
  clause_.phrases.push_back(std::move(place));
  return ask(Frame::kPlace, "put", done);
}

// "the salt to me", "the spoon in my hand"
auto ClauseParser::Fragment::to_somebody() -> Read {
  NounPhrase place;
  if (!people()) return {};
  const std::size_t done = reader_.read_place(i_, end_, place);
  if (done == i_ || !(place.person || place.hand) || !parser_.ends_here(done, end_)) return {};
  return ask_to_bring(done);
}

// "spoon in sink"
auto ClauseParser::Fragment::to_place() -> Read {
  NounPhrase place, second, with;
  std::size_t last = reader_.read_place(i_, end_, place);
  if (last == i_ || place.person) return {};
  // "everything on the counter into the sink"
  if (const std::size_t after = reader_.read_place(last, end_, second); after != last) {
    for (NounPhrase& phrase : clause_.phrases) phrase.at.push_back(place);
    place = second, last = after;
  }
  place.role = Role::kDestination;
  clause_.phrases.push_back(place);
  last = more_places(last, place.where);
  const std::size_t topped = topping(last, place, with);
  ask(Frame::kPlace, "put", last);
  if (topped == last) return last;
  Clause top;
  top.frame = Frame::kAdd, top.verb = "add", top.words = {"add"};
  top.phrases = {std::move(with), std::move(place)};
  parser_.add(std::move(top));
  return topped;
}

// "(pillows on armchair 4) and the couch"; where it ends, `at` where there is none
std::size_t ClauseParser::Fragment::more_places(std::size_t at, Where where) {
  std::size_t last = at;
  for (NounPhrase more; people() && last + 1 < end_ && words_[last] == "and"; more = {}) {
    const std::size_t after = reader_.read(last + 1, end_, more, true);
    if (after == last + 1 || !lexicon_.is_place_name(more.phrase) || !parser_.ends_here(after, end_)) break;
    more.role = Role::kDestination, more.where = where, more.joined = true;
    clause_.phrases.push_back(more);
    last = after;
  }
  return last;
}

// "(ice cream in the bowl) with chocolate syrup": into the same; where it ends, `at` where there is none
std::size_t ClauseParser::Fragment::topping(std::size_t at, const NounPhrase& place, NounPhrase& with) const {
  static constexpr std::array kToppings = {"syrup"sv, "sauce"sv, "topping"sv};
  if (!people() || !is(at, "with") || !language_.holds_things(place.phrase)) return at;
  const std::size_t topped = reader_.read(at + 1, end_, with);
  const bool tops = topped != at + 1 && clause_.phrases.size() == 2 && parser_.ends_here(topped, end_) &&
                    language_.content(subject_.phrase) != symbol::kNone &&
                    (language_.content(with.phrase) != symbol::kNone ||
                     one_of(with.phrase.substr(with.phrase.rfind(' ') + 1), kToppings));
  return tops ? topped : at;
}

// "coke and ginger ale fridge": the last thing of a list and the place side by side
auto ClauseParser::Fragment::listed_then_place() -> Read {
  if (!people() || clause_.phrases.size() < 2 || !parser_.ends_here(i_, end_)) return {};
  NounPhrase place = clause_.phrases.back();
  const std::string name = place.modifier.empty() ? place.content : place.modifier;
  if (!lexicon_.is_name(name) || lexicon_.is_place_name(name) || !lexicon_.is_place_name(place.phrase) ||
      language_.holds_things(place.phrase))
    return {};
  NounPhrase last;
  last.phrase = last.word = name, last.plural = place.modifier_plural;
  place.modifier.clear(), place.content.clear();
  place.role = Role::kDestination, place.where = Where::kTo;
  clause_.phrases.back() = std::move(last);
  clause_.phrases.push_back(std::move(place));
  return ask(Frame::kPlace, "put", i_);
}

// "coke fridge"
auto ClauseParser::Fragment::content_then_place() -> Read {
  if (!people() || subject_.content.empty() || !lexicon_.is_place_name(subject_.phrase) ||
      language_.holds_things(subject_.phrase) || !behind().harmless)
    return {};
  NounPhrase& there = clause_.phrases.front();
  there.modifier = there.content;
  there.content.clear(), subject_.content.clear();
  return ask(Frame::kPlace, "put", i_);
}

// "pillow 4 armchair 4", "plate bowl both counter": things side by side, then the place where they go
auto ClauseParser::Fragment::things_then_place() -> Read {
  const auto thing = [](const NounPhrase& said) {
    return !said.bare() && !said.pronoun && !said.unknown && !said.person && !said.everything;
  };
  const NounPhrase& first = clause_.phrases.front();
  if (!people() || !thing(first) || lexicon_.is_place_name(first.phrase)) return {};
  Clause placed = clause_;
  bool both = placed.phrases.size() > 1;  // "plate and bowl counter"
  for (std::size_t i = i_; i < end_;) {
    if (words_[i] == "both" || words_[i] == "all") {
      ++i, both = true;
      continue;
    }
    NounPhrase next;
    const std::size_t done = reader_.read(i, end_, next);
    if (done == i || !thing(next)) return {};
    i = done;
    if (!lexicon_.is_place_name(next.phrase) || language_.holds_things(next.phrase)) {
      placed.phrases.push_back(std::move(next));
      continue;
    }
    const bool several = placed.phrases.size() > 1 || !placed.phrases.front().modifier.empty();
    if (!parser_.ends_here(i, end_) || (several && !both)) return {};  // "mug kettle sink" may mean anything
    split_modifiers(placed);
    next.role = Role::kDestination, next.where = Where::kTo;
    placed.phrases.push_back(std::move(next));
    clause_ = std::move(placed);
    return ask(Frame::kPlace, "put", i);
  }
  return {};
}

// "plate bowl" are two things here, no bowl for plates.
void ClauseParser::Fragment::split_modifiers(Clause& clause) const {
  for (std::size_t k = 0; k < clause.phrases.size(); ++k) {
    NounPhrase& thing = clause.phrases[k];
    if (thing.modifier.empty() || lexicon_.is_place_name(thing.modifier)) continue;
    NounPhrase other;
    other.phrase = other.word = thing.modifier, other.plural = thing.modifier_plural;
    thing.modifier.clear();
    clause.phrases.push_back(std::move(other));
  }
}

// "plates sink"
auto ClauseParser::Fragment::thing_then_place() -> Read {
  if (subject_.modifier.empty() || !behind().harmless) return {};
  return ask(Frame::kPlace, "put", i_);
}

// "that controller has no business on the couch, shelf please": there it goes
auto ClauseParser::Fragment::place_alone() -> Read {
  if (!people() || !behind().harmless || !polite() || result_.clauses.empty() ||
      !lexicon_.is_place_name(subject_.phrase) || language_.holds_things(subject_.phrase))
    return {};
  const Clause& before = result_.clauses.back();
  if (before.mood == Mood::kQuestion || before.first(Role::kDirect) == nullptr ||
      before.first(Role::kDestination) != nullptr)
    return {};
  NounPhrase it;
  it.pronoun = true, it.word = "it", it.plural = before.phrases.size() > 1;
  subject_.role = Role::kDestination, subject_.where = Where::kTo;
  clause_.phrases = {std::move(it), std::move(subject_)};
  std::size_t next = i_;
  while (next < end_ && !language_.joins(words_[next])) ++next;
  return ask(Frame::kPlace, "put", next);
}

}  // namespace goalnet::inference
