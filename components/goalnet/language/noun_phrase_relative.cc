// What tells a thing apart by where it is, what stands there, and what it lacks: "lying with the plate", "the
// one the kettle is standing on", "the plate without an egg on it".
#include <algorithm>
#include <array>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t NounPhraseReader::floor(std::size_t at, std::size_t end) const {
  static constexpr std::array kFrom = {"on"sv, "from"sv, "off"sv, "of"sv, "the"sv};
  static constexpr std::array kFloor = {"floor"sv, "ground"sv, "carpet"sv, "rug"sv};
  std::size_t k = at;
  while (k < end && one_of(words_.text[k], kFrom)) ++k;
  return k > at && k < end && one_of(words_.text[k], kFloor) && words_.text[at] != "of" &&
                 words_.text[at] != "the"
             ? k + 1
             : at;
}

std::size_t NounPhraseReader::relative(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  std::size_t k = i;
  while (k < end && one_of(words_.text[k], kLying)) ++k;
  if (k + 1 < end && (words_.text[k] == "you" || words_.text[k] == "i") &&
      (words_.text[k + 1] == "are" || words_.text[k + 1] == "am" || words_.text[k + 1] == "have" ||
       language_.verb(words_.text[k + 1]) == Frame::kTake ||
       (language_.hears_people() && words_.text[k + 1] == "carry"))) {
    ++k;
    while (k < end &&
           (words_.text[k] == "are" || words_.text[k] == "am" || words_.text[k] == "have" ||
            words_.text[k] == "currently" || words_.text[k] == "carry" || words_.text[k] == "just" ||
            language_.verb(words_.text[k]) == Frame::kTake || words_.text[k] == "up"))
      ++k;
    if (k < end && (words_.text[k] == "in" || words_.text[k] == "with")) {  // "have in your hand"
      NounPhrase hand;
      const std::size_t done = read(k + 1, end, hand);
      if (hand.hand) k = done;
    }
    phrase.adjectives.push_back("held");
    return k;
  }
  if (language_.hears_people() && floor(k, end) != k) {  // "lying on the floor"
    phrase.on_floor = true;
    return floor(k, end);
  }
  NounPhrase place;
  if (language_.hears_people() && k > i && k < end && words_.text[k] == "with") {  // "lying with the plate"
    const std::size_t done = read(k + 1, end, place);
    if (done != k + 1 && !place.person && !place.bare() && !place.unknown &&
        language_.content(place.phrase) == symbol::kNone) {
      place.where = Where::kNear;
      phrase.at.push_back(place);
      return done;
    }
    place = {};
  }
  if (language_.hears_people() && k > i && k < end &&
      words_.text[k] == "not") {  // "that are not on the shelf"
    const std::size_t done = read_place(k + 1, end, place);
    if (done != k + 1 && !place.hand && !place.person) {
      place.negated = true;
      phrase.at.push_back(place);
      NounPhrase other;  // "that is not on a shelf or on the couch"
      const std::size_t after =
          done < end && words_.text[done] == "or" ? read_place(done + 1, end, other) : done;
      if (after <= done + 1 || other.hand || other.person) return done;
      other.negated = true;
      phrase.at.push_back(other);
      return after;
    }
    place = {};
  }
  if (const std::size_t done = read_place(k, end, place); done != k) {
    if (place.hand || place.person)
      phrase.adjectives.push_back("held");
    else
      phrase.at.push_back(place);
    return done;
  }
  // "the burner that is on"
  if (language_.hears_people() && k > i && k < end &&
      (words_.text[k] == "on" || words_.text[k] == "running" || words_.text[k] == "burning")) {
    phrase.adjectives.emplace_back("lit");
    return k + 1;
  }
  if (k < end && one_of(words_.text[k], kStates) && k > i) {
    phrase.adjectives.push_back(words_.text[k]);
    return k + 1;
  }
  return i;
}

// "(the burner that) the kettle is on", "(the one) my bowl is standing on": what bears the thing; `i` where
// it is none. `stranded`: its preposition must be said.
std::size_t NounPhraseReader::bears(std::size_t i, std::size_t end, NounPhrase& phrase, bool stranded) const {
  static constexpr std::array kOn = {"on"sv, "in"sv, "at"sv};
  if (i >= end || (names_[i] == 0 && !one_of(words_.text[i], kArticles))) return i;
  NounPhrase there;
  const std::string last_thing = last_thing_;
  const std::size_t named = read(i, end, there);
  std::size_t k = named;
  while (k < end && one_of(words_.text[k], kLying)) ++k;
  const bool runs_on = k < end && k > named && words_.text[k] == "onto";  // "the egg is lying on to the sink"
  const bool preposition = k < end && one_of(words_.text[k], kOn) && (!stranded || !starts(k + 1, end));
  if (named == i || k == named || (stranded && !preposition && !runs_on) || there.person || there.unknown) {
    last_thing_ = last_thing;
    return i;
  }
  there.where = Where::kUnder;
  phrase.at.push_back(std::move(there));
  return preposition ? k + 1 : k;
}

// "(the shelf with, that has) the plate on it"; `i` where it is none.
std::size_t NounPhraseReader::has_on_it(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  const bool place = lexicon_.is_place_name(phrase.phrase) || one_of(phrase.phrase, kFurniture);
  if (!language_.hears_people() || !place) return i;
  NounPhrase on_it;
  const std::size_t done = read(i, end, on_it);
  if (done == i || done + 1 >= end || on_it.person || on_it.unknown ||
      (words_.text[done] != "on" && words_.text[done] != "in") || words_.text[done + 1] != "it")
    return i;
  on_it.where = Where::kUnder;
  phrase.at.push_back(std::move(on_it));
  return done + 2;
}

// "without a pillow (on it)", "with nothing in it"; `i` where it is none.
std::size_t NounPhraseReader::lacks(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  const bool place = lexicon_.is_place_name(phrase.phrase) ||
                     (language_.hears_people() && one_of(phrase.phrase, kFurniture));
  const bool dish = language_.hears_people() && language_.holds_things(phrase.phrase);
  if ((!place && !dish) || i + 1 >= end) return i;
  const auto behind = [&](std::size_t done) {  // "on it", "in there", "inside"
    if (done < end && words_.text[done] == "inside") return done + 1;
    const bool on = done + 1 < end && (words_.text[done] == "on" || words_.text[done] == "in");
    return on && (is_pronoun(words_.text[done + 1]) || words_.text[done + 1] == "there") ? done + 2 : done;
  };
  const std::string& word = words_.text[i];
  if (language_.hears_people() && word == "with" && words_.text[i + 1] == "nothing") {
    const std::size_t done = behind(i + 2);
    if (done == i + 2) return i;
    phrase.adjectives.insert(phrase.adjectives.end(), {"empty", "free"});
    return done;
  }
  if (word != "without") return i;
  NounPhrase missing;
  std::size_t done = read(i + 1, end, missing);
  if (done == i + 1 && (words_.text[i + 1] == "one" || words_.text[i + 1] == "any"))
    done = i + 2;  // "put it on the armchair without one"
  if (done == i + 1) return i;
  const std::size_t after = language_.hears_people() ? behind(done) : done;
  if (dish) {
    if (missing.bare() || missing.unknown || missing.pronoun || (after == done && !phrase.definite)) return i;
    missing.where = Where::kUnder, missing.negated = true;
    phrase.at.push_back(std::move(missing));
    return after;
  }
  phrase.adjectives.push_back("free");
  if (!missing.phrase.empty()) last_thing_ = missing.phrase;
  return after;
}

}  // namespace goalnet::inference
