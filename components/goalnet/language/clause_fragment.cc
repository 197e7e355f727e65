// Requests without a verb: "spoon in sink", "tap on please", "channel 5", "and the other plate too".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "spoon in sink", "tap on please", "volume down", "channel 5", "the mug please".
std::size_t ClauseParser::fragment(std::size_t at, std::size_t end) {
  Clause clause;
  clause.frame = Frame::kNone;
  NounPhrase subject;
  std::size_t i = things_of_fragment(at, end, clause, subject);
  if (const std::size_t done = all_of_them(at, end, subject, i); done != at) return done;
  NounPhrase place;
  bool polite = false;
  for (const std::string& word : words_)
    polite = polite || word == "please" || word == "now" || word == "quick" || word == "asap" ||
             (word == "fast" && language_.hears_people()) || word == "thank" ||
             (word == "thanks" && language_.hears_people());
  const auto only_harmless_from = [&](std::size_t from) {
    std::size_t k = from;
    if (NounPhrase purpose; k < end && words_[k] == "for") {
      k = std::max(reader_.read(k + 1, end, purpose), k + 1);
      polite = polite || purpose.person;
    }
    for (; k < end && !language_.joins(words_[k]); ++k) {
      if (!harmless(k) && !(words_[k] == "here" && language_.hears_people())) return false;
      polite = polite || words_[k] == "please" || words_[k] == "me" || words_[k] == "us" ||
               (words_[k] == "here" && language_.hears_people());
    }
    if (k + 1 < end && words_[k] == "," && words_[k + 1] == "please") polite = true;
    return true;
  };
  if (language_.hears_people() && subject.word == "one" && words_[at] == "the" &&
      subject.adjectives.empty() &&
      (!subject.at.empty() ||
       (i < end && place_preposition(words_[i])))) {  // "the one on the shelf": of what?
    result_.stray.push_back("one");
    return part_end(at, end);
  }
  if (language_.hears_people())  // "another book please, not the one on the couch"
    for (std::size_t k = i; k < end; ++k) {
      if (words_[k] != "not" && !language_.joins(words_[k]) && !harmless(k)) break;
      NounPhrase left_out;
      if (words_[k] != "not") continue;
      const std::size_t after = denied(k, end, left_out);
      if (after == k || !ends_here(after, end)) break;
      clause.frame = Frame::kTake, clause.verb = "bring", clause.to_person = clause.wish = true;
      clause.phrases.push_back(std::move(left_out));
      add(std::move(clause));
      return after;
    }
  // "on the table please, the coffee table"
  if (NounPhrase* there = nullptr; language_.hears_people() && at > 0 && words_[at - 1] == "," &&
                                   !result_.clauses.empty() &&
                                   result_.clauses.back().mood == Mood::kCommand && ends_here(i, end)) {
    for (NounPhrase& phrase : result_.clauses.back().phrases)
      if (phrase.role == Role::kDestination) there = &phrase;
    if (there != nullptr && subject.phrase != there->phrase &&
        subject.phrase.ends_with(" " + there->phrase)) {
      there->phrase = subject.phrase;
      return i;
    }
  }
  if (subject.unknown) {
    result_.stray.push_back(subject.word);
    return std::max(i, at + 1);
  }
  if (i < end && (words_[i] == "on" || words_[i] == "off" || words_[i] == "up" || words_[i] == "down") &&
      !reader_.starts(i + 1, end)) {
    clause.frame = Frame::kTurn, clause.verb = "turn";
    clause.particles = {words_[i]};
    clause.words.push_back(words_[i]);
    add(std::move(clause));
    return i + 1;
  }
  // "the telly's too loud": its "is" was lost with the apostrophe
  if (i + 1 < end && words_[i] == "too" && language_.complaint(words_[i + 1]) != Frame::kNone) {
    clause.mood = Mood::kStatement, clause.frame = Frame::kNone, clause.state = words_[i + 1];
    add(std::move(clause));
    return part_end(i, end);
  }
  // "the bowl, into the microwave"
  if (i + 1 < end && words_[i] == "," && place_preposition(words_[i + 1])) {
    const std::size_t done = reader_.read_place(i + 1, end, place);
    if (done != i + 1 && !place.person && ends_here(done, end)) ++i;
    place = {};
  }
  // "water in": into what was spoken of
  if (i < end &&
      (words_[i] == "in" || words_[i] == "into" || (words_[i] == "inside" && language_.hears_people())) &&
      (i + 1 >= end || language_.joins(words_[i + 1]))) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    clause.particles = {"in"};
    add(std::move(clause));
    return i + 1;
  }
  // "coke in there too"
  if (i + 1 < end && words_[i + 1] == "there" && place_preposition(words_[i], &place.where)) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    place.role = Role::kDestination, place.pronoun = true, place.word = "there";
    clause.phrases.push_back(place);
    add(std::move(clause));
    return i + 2;
  }
  if (const std::size_t done = off_or_for(i, end, clause, subject); done != i) return done;
  if (const std::size_t done = reader_.read_place(i, end, place);
      language_.hears_people() && done != i && (place.person || place.hand) && ends_here(done, end)) {
    clause.frame = Frame::kTake, clause.verb = "bring", clause.to_person = clause.wish = true;
    add(std::move(clause));
    return done;
  }
  place = {};
  if (const std::size_t done = reader_.read_place(i, end, place); done != i && !place.person) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    std::size_t last = done;
    NounPhrase second;  // "everything on the counter into the sink"
    if (const std::size_t after = reader_.read_place(done, end, second); after != done) {
      for (NounPhrase& phrase : clause.phrases) phrase.at.push_back(place);
      place = second, last = after;
    }
    place.role = Role::kDestination;
    clause.phrases.push_back(place);
    for (NounPhrase more; language_.hears_people() && last + 1 < end && words_[last] == "and"; more = {}) {
      const std::size_t after = reader_.read(last + 1, end, more, true);  // "on armchair 4 and the couch"
      if (after == last + 1 || !lexicon_->is_place_name(more.phrase) || !ends_here(after, end)) break;
      more.role = Role::kDestination, more.where = place.where, more.joined = true;
      clause.phrases.push_back(more);
      last = after;
    }
    // "ice cream in the bowl with chocolate syrup": into the same
    static constexpr std::array kToppings = {"syrup"sv, "sauce"sv, "topping"sv};
    NounPhrase with;
    const std::size_t topped = language_.hears_people() && last < end && words_[last] == "with" &&
                                       language_.holds_things(place.phrase)
                                   ? reader_.read(last + 1, end, with)
                                   : last + 1;
    const bool tops = topped != last + 1 && ends_here(topped, end) && clause.phrases.size() == 2 &&
                      language_.content(subject.phrase) != symbol::kNone &&
                      (language_.content(with.phrase) != symbol::kNone ||
                       one_of(with.phrase.substr(with.phrase.rfind(' ') + 1), kToppings));
    add(std::move(clause));
    if (!tops) return last;
    Clause top;
    top.frame = Frame::kAdd, top.verb = "add", top.words = {"add"};
    top.phrases = {std::move(with), std::move(place)};
    add(std::move(top));
    return topped;
  }
  if (i < end && language_.wanted_by_state(words_[i]) != Frame::kNone) {
    clause.frame = language_.wanted_by_state(words_[i]), clause.verb = clause.state = words_[i];
    add(std::move(clause));
    return i + 1;
  }
  if (subject.phrase == "channel" && (subject.has("next") || subject.has("previous"))) {
    clause.frame = Frame::kChange, clause.verb = "change";
    add(std::move(clause));
    return i;
  }
  if (language_.tv_word(subject.phrase) && (subject.number > 0 || subject.ordinal > 0)) {
    clause.frame = Frame::kChange, clause.verb = "change";
    add(std::move(clause));
    return i;
  }
  if (language_.hears_people() && !subject.content.empty() && lexicon_->is_place_name(subject.phrase) &&
      !language_.holds_things(subject.phrase) && only_harmless_from(i)) {  // "coke fridge"
    NounPhrase& there = clause.phrases.front();
    there.modifier = there.content;
    there.content.clear(), subject.content.clear();
    clause.frame = Frame::kPlace, clause.verb = "put";
    add(std::move(clause));
    return i;
  }
  if (Clause placed = clause; language_.hears_people())
    if (const std::size_t done = things_then_place(i, end, placed); done != i) return done;
  if (!subject.modifier.empty() && only_harmless_from(i)) {  // "plates sink"
    clause.frame = Frame::kPlace, clause.verb = "put";
    add(std::move(clause));
    return i;
  }
  // "the other plate too"
  if (i < end && words_[i] == "too" && ends_here(i, end) && again(clause)) return i + 1;
  // "that controller has no business on the couch, shelf please": there it goes
  if (language_.hears_people() && only_harmless_from(i) && polite &&
      lexicon_->is_place_name(subject.phrase) && !language_.holds_things(subject.phrase) &&
      !result_.clauses.empty() && result_.clauses.back().mood != Mood::kQuestion &&
      result_.clauses.back().first(Role::kDirect) != nullptr &&
      result_.clauses.back().first(Role::kDestination) == nullptr) {
    NounPhrase it;
    it.pronoun = true, it.word = "it", it.plural = result_.clauses.back().phrases.size() > 1;
    subject.role = Role::kDestination, subject.where = Where::kTo;
    clause.frame = Frame::kPlace, clause.verb = "put";
    clause.phrases = {std::move(it), std::move(subject)};
    add(std::move(clause));
    while (i < end && !language_.joins(words_[i])) ++i;
    return i;
  }
  // "the coke goes in the trash, and the beer": as well, though there is a "now" somewhere
  if (language_.hears_people() && at > 0 && words_[at - 1] == "and" && subject.definite &&
      ends_here(i, end) &&
      std::find(words_.begin() + static_cast<long>(at), words_.begin() + static_cast<long>(end), "please") ==
          words_.begin() + static_cast<long>(end) &&
      !result_.clauses.empty() &&
      (result_.clauses.back().frame == Frame::kPlace || result_.clauses.back().frame == Frame::kDiscard ||
       result_.clauses.back().frame == Frame::kWash || result_.clauses.back().frame == Frame::kHeat) &&
      again(clause))
    return part_end(i, end);
  // "spoon and fork": a list of things and nothing else
  const bool list = language_.hears_people() && at == 0 && i >= words_.size() && clause.phrases.size() > 1 &&
                    std::none_of(clause.phrases.begin(), clause.phrases.end(), [&](const NounPhrase& phrase) {
                      return phrase.unknown || phrase.person || phrase.pronoun || phrase.bare() ||
                             phrase.alternative ||  // "(which is better,) beer or coke?"
                             phrase.role != Role::kDirect || lexicon_->is_place_name(phrase.phrase);
                    });
  if (only_harmless_from(i) && (polite || list)) {
    clause.frame = Frame::kTake, clause.verb = "bring", clause.to_person = clause.wish = true;
    add(std::move(clause));
    while (language_.hears_people() && i < end && !language_.joins(words_[i])) ++i;
    return i;
  }
  if (ends_here(i, end) && again(clause)) {
    while (i < end && words_[i] != ",") ++i;
    return i;
  }
  if (says_nothing_here(at, end)) {
    result_.passed.push_back(words_[at]);
    add_told(at, part_end(at, end));
    return part_end(at, end);
  }
  result_.stray.push_back(words_[at]);
  return std::max(i, at + 1);
}

}  // namespace goalnet::inference
