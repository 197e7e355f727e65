// The things, places and particles behind a verb.
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

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
// Frames whose object may be followed by the state it should be in: "leave the door open".
bool takes_state(Frame frame) {
  return frame == Frame::kTake || frame == Frame::kPlace || frame == Frame::kMake || frame == Frame::kBring;
}

}  // namespace

std::size_t ClauseParser::argument(std::size_t i, std::size_t end, Clause& clause, Role& role, Where& where) {
  const std::string& word = words_[i];
  if (const std::size_t done = caused(i, end, clause); done != i) return done;
  const auto state_here = [&] {
    return takes_state(clause.frame) && !clause.phrases.empty() &&
           language_.wanted_by_state(word) != Frame::kNone &&
           !((place_preposition(word) || word == "off") && reader_.starts(i + 1, end)) &&
           reader_.name_length(i) == 0;
  };
  if (state_here() &&
      !(word == "on" && clause.frame == Frame::kPlace && clause.verb != "leave" && clause.verb != "keep") &&
      !((word == "off") && clause.verb != "leave" && clause.verb != "keep" && !clause.wish &&
        clause.verb != "get" && clause.verb != "want")) {
    clause.state = word;
    return i + 1;
  }
  if ((clause.wish || clause.frame == Frame::kTake || clause.frame == Frame::kMake) &&
      !clause.phrases.empty() && language_.verb(word) != Frame::kNone && language_.participle(word) &&
      reader_.name_length(i) == 0) {
    clause.frame = language_.verb(word);  // "I want the plates washed"
    clause.verb = language_.verb_base(word);
    return i + 1;
  }
  // "put on the coffee table the bowl"
  if (NounPhrase there; word == "on" && clause.frame == Frame::kPlace && clause.phrases.empty()) {
    const std::size_t done = reader_.read_place(i, end, there);
    if (done != i && lexicon_->is_place_name(there.phrase) && reader_.starts(done, end)) {
      there.role = Role::kDestination;
      clause.phrases.push_back(std::move(there));
      return done;
    }
  }
  const auto behind_there = [&] {  // "pour the coke in there"
    Where there_where = Where::kTo;
    if (i + 1 >= end || words_[i + 1] != "there" || !place_preposition(word, &there_where)) return false;
    NounPhrase there;
    there.role = Role::kDestination, there.pronoun = true, there.word = "there", there.where = there_where;
    clause.phrases.push_back(std::move(there));
    return true;
  };
  if (language_.hears_people() && behind_there()) return i + 2;
  if (one_of(word, kParticles) &&
      !(one_of(word, kParticles) && place_preposition(word) && reader_.starts(i + 1, end) &&
        !(clause.first(Role::kDirect) == nullptr && (word == "on" || word == "over")))) {
    if (const std::size_t done = particle(i, end, clause, role); done != i) return done;
  }
  if (word == "on" && clause.first(Role::kDirect) == nullptr &&
      (clause.frame == Frame::kTurn || clause.frame == Frame::kStart || clause.frame == Frame::kPlace)) {
    clause.particles.push_back(word);
    return i + 1;
  }
  // "give the mug a wash"
  if (word == "a" && clause.frame == Frame::kTake && !clause.phrases.empty() && i + 1 < end) {
    std::size_t k = i + 1;
    while (k + 1 < end &&
           (words_[k] == "quick" || words_[k] == "good" || words_[k] == "nice" || words_[k] == "little"))
      ++k;
    const Frame noun = language_.verb(words_[k]);
    if ((noun == Frame::kWash || noun == Frame::kHeat) && reader_.name_length(k) == 0) {
      clause.frame = noun, clause.verb = language_.verb_base(words_[k]), clause.to_person = false;
      return k + 1;
    }
  }
  if (behind_there()) return i + 2;
  // "the sink is for dirty things, I would like both plates there"
  if (language_.hears_people() && word == "there" && clause.wish && clause.phrases.size() == 1 &&
      ends_here(i + 1, end) && !result_.clauses.empty())
    clause.frame = Frame::kPlace, clause.verb = "put", clause.wish = false;
  // "and get the controller there as well"
  if (language_.hears_people() && word == "there" && clause.frame == Frame::kTake && !clause.to_person &&
      !clause.wish && (clause.verb == "get" || clause.verb == "take") && clause.phrases.size() == 1 &&
      std::any_of(result_.clauses.begin(), result_.clauses.end(), [](const Clause& before) {
        return before.first(Role::kDestination) != nullptr && before.mood == Mood::kCommand;
      }))
    clause.frame = Frame::kPlace;
  if (word == "there" && (clause.frame == Frame::kPlace || clause.frame == Frame::kBring)) {
    NounPhrase there;
    there.role = Role::kDestination, there.pronoun = true, there.word = word;
    clause.phrases.push_back(there);
    return i + 1;
  }
  // "open the microwave and put the mug inside"
  if ((word == "inside" || word == "in") && !reader_.starts(i + 1, end) && !clause.phrases.empty() &&
      clause.first(Role::kDestination) == nullptr &&
      (clause.frame == Frame::kPlace || clause.frame == Frame::kBring || clause.frame == Frame::kInsert)) {
    NounPhrase it;
    it.role = Role::kDestination, it.where = Where::kIn, it.pronoun = true, it.word = "it";
    clause.phrases.push_back(it);
    return i + 1;
  }
  if (language_.hears_people() && word == "first" && !clause.phrases.empty() && ends_here(i + 1, end)) {
    if (clause.phrases.front().pronoun && !result_.clauses.empty() && clause.mood == Mood::kCommand &&
        result_.clauses.back().mood == Mood::kCommand && clause.condition.empty() &&
        conditional_.condition.empty())
      insert_before_ = result_.clauses.size() - 1;  // "put it in the sink, but empty it first"
    return i + 1;                                   // "fill it first"
  }
  if (word == "here") {
    clause.to_person = true;
    return i + 1;
  }
  if (word == "from") {
    role = Role::kSource;
    where = Where::kTo;
    NounPhrase phrase;
    std::size_t from = i + 1;
    Where inner = Where::kTo;
    if (from < end && place_preposition(words_[from], &inner) && words_[from] != "to")
      ++from;  // "from inside the fridge"
    const std::size_t done = reader_.read(from, end, phrase, true);
    if (done == from && from < end && words_[from] == "there") {
      phrase.role = role, phrase.pronoun = true, phrase.word = "there";
      clause.phrases.push_back(std::move(phrase));
      return from + 1;
    }
    if (done == from) return i + 1;
    phrase.role = role, phrase.where = inner;
    if (phrase.hand || phrase.person) return done;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (word == "with" || word == "using" || word == "via") {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 1, end, phrase);
    if (done == i + 1) return i + 1;
    if (phrase.unknown && !adds(clause.frame) && one_of(words_[i + 1], kPossessives))
      return done;  // "with my fingers"
    // "the cup with coffee"
    if (!adds(clause.frame) && role == Role::kDirect && !clause.phrases.empty() &&
        phrase.adjectives.empty() && phrase.modifier.empty() &&
        language_.content(phrase.phrase) != symbol::kNone &&
        language_.holds_things(clause.phrases.back().phrase) && clause.phrases.back().content.empty()) {
      clause.phrases.back().content = phrase.phrase;
      return done;
    }
    std::size_t after = done;
    if (NounPhrase there;
        language_.hears_people() && reader_.read_place(done, end, there) != done && there.pronoun) {
      after = reader_.read_place(done, end, there);  // "with the beer beside it"
      phrase.at = {there};
    }
    role = Role::kWith;
    phrase.role = role;
    if (!phrase.hand && !phrase.person) clause.phrases.push_back(std::move(phrase));
    return after;
  }
  if ((word == "a" || word == "one" || word == "another" || number_word(word) > 0) && i + 1 < end &&
      language_.time_unit(words_[i + 1]) && reader_.name_length(i + 1) == 0)
    return i + 2;  // "hold it for me a moment"
  if (word == "for") return for_whom(i, end, clause);
  NounPhrase place;
  if (const std::size_t done = reader_.read_place(i, end, place); done != i) {
    if (place.person || place.hand) {
      clause.to_person = true;
      return done;
    }
    if (place.phrase.empty() && place.unknown && language_.time_unit(place.word))
      return done;  // "in a minute"
    const bool moves =
        word == "to" || word == "into" || word == "onto" || word == "toward" || word == "towards";
    if (locates(clause.frame) && !moves && !place.pronoun && !clause.phrases.empty() &&
        clause.phrases.back().role == Role::kDirect && !clause.phrases.back().pronoun) {
      clause.phrases.back().at.push_back(std::move(place));
      return done;
    }
    role = Role::kDestination, where = place.where;
    place.role = role;
    clause.phrases.push_back(std::move(place));
    return done;
  }
  // a second verb without a join: "turn on the tv put the remote down"
  if (!clause.phrases.empty() && opens_command(i, end) && !language_.participle(word) &&
      language_.wanted_by_state(word) == Frame::kNone)
    return i;
  NounPhrase phrase;
  if (const std::size_t done = reader_.read(i, end, phrase); done != i) {
    // "... the mug it is dirty": a statement begins
    if (!clause.phrases.empty() && done < end && language_.copula(words_[done])) return i;
    if (phrase.person) {
      const bool speaks = words_[i] == "you" && done < end && language_.verb(words_[done]) == Frame::kNone &&
                          !clause.phrases.empty();
      if (speaks && !harmless(done)) return i;
      clause.to_person = true;
      return done;
    }
    phrase.role = role, phrase.where = where;
    if (role == Role::kSource || role == Role::kWith)
      phrase.role = clause.first(Role::kDirect) != nullptr ? role : Role::kDirect;
    // "bring to the table the mug"
    if (role == Role::kDestination && clause.first(Role::kDirect) == nullptr) phrase.role = Role::kDirect;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (word == "i" || word == "we") return clause.phrases.empty() ? i + 1 : i;  // "... i cannot hear anything"
  if (place_preposition(word) && i + 1 < end && words_[i + 1] != "." && !language_.known(words_[i + 1])) {
    clause.unknown.push_back(words_[i + 1]);
    return i + 2;
  }
  if (!harmless(i) && !place_preposition(word) && !one_of(word, kParticles) && !language_.known(word))
    clause.unknown.push_back(word);
  return i + 1;
}

}  // namespace goalnet::inference
