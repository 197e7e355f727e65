// What follows the head: "of coffee", "in the sink", "that is on the table", "full of water".
#include <array>

#include "components/goalnet/language/noun_phrase_behind.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t NounPhraseReader::of(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  NounPhrase inner;
  const std::size_t done = read(i + 1, end, inner);
  if (done == i + 1 && language_.holds_things(phrase.phrase) && i + 1 < end &&
      lexicon_.is_word_of_name(words_.text[i + 1])) {  // "a glass of wine": known of wine glasses only
    phrase.unknown = true, phrase.word = words_.text[i + 1];
    return i + 2;
  }
  if (done == i + 1) return i;
  if (inner.unknown) {  // "a cup of tea"
    phrase.unknown = true, phrase.word = inner.word;
  } else if (language_.content(inner.phrase) != symbol::kNone && language_.holds_things(phrase.phrase)) {
    phrase.content = inner.phrase;
    for (const std::string& adjective : inner.adjectives) phrase.adjectives.push_back(adjective);
  } else if (language_.holds_things(phrase.phrase)) {
    phrase.unknown = inner.phrase.empty(), phrase.modifier = inner.phrase;
    phrase.filled_with_things = !inner.phrase.empty();
  } else if (language_.side_or_part(phrase.phrase)) {
    if (phrase.phrase == "knob") inner.adjectives.push_back("knob");
    inner.adjectives.insert(inner.adjectives.end(), phrase.adjectives.begin(), phrase.adjectives.end());
    if (inner.ordinal == 0) inner.ordinal = phrase.ordinal;
    inner.role = phrase.role, inner.where = phrase.where, inner.all = inner.all || phrase.all;
    if (inner.count == 0) inner.count = phrase.count;
    inner.plural = inner.plural || phrase.plural;
    phrase = inner;  // "the door of the fridge": the fridge, as opened
  } else if (!inner.phrase.empty()) {
    const bool carrier = phrase.phrase == "can" || phrase.phrase == "bottle";
    if (carrier) {  // "a can of coke"
      inner.count = phrase.count, inner.role = phrase.role, inner.where = phrase.where;
      phrase = inner;
    } else if (language_.hears_people() && inner.number > 0 && lexicon_.is_place_name(inner.phrase)) {
      inner.where = Where::kOn;  // "the cushion of armchair number two"
      phrase.at.push_back(inner);
    } else {
      phrase.modifier = inner.phrase;
    }
  }
  return done;
}

std::size_t NounPhraseReader::after(std::size_t at, std::size_t end, NounPhrase& phrase) const {
  return Behind(*this, at, end, phrase).read();
}

std::size_t NounPhraseReader::Behind::read() {
  static constexpr std::array<Rule, 13> kRules = {
      &Behind::on_floor,        &Behind::of,          &Behind::that_is,
      &Behind::bears_something, &Behind::whatever_is, &Behind::held_or_lying,
      &Behind::that_we_have,    &Behind::lacking,     &Behind::with_on_it,
      &Behind::with_beside,     &Behind::with_in_it,  &Behind::nearest,
      &Behind::left_or_right};
  constexpr int kMost = 4;  // things told of one thing
  for (int round = 0; round < kMost && i_ < end_; ++round) {
    Read done;
    for (const Rule rule : kRules)
      if (done = (this->*rule)(); done) break;
    if (!done || *done == i_) return i_;
    i_ = *done;
  }
  return i_;
}

// "off the floor"
auto NounPhraseReader::Behind::on_floor() -> Read {
  if (!people() || phrase_.bare()) return {};
  const std::size_t done = reader_.floor(i_, end_);
  if (done == i_) return {};
  phrase_.on_floor = true;
  return done;
}

// "a cup of coffee", "the door of the fridge"
auto NounPhraseReader::Behind::of() -> Read {
  if (word() != "of" || phrase_.phrase.empty()) return {};
  return reader_.of(i_, end_, phrase_);
}

// "the mug that is in the sink", "the burner that the kettle is on", "the shelf where the beer is"
auto NounPhraseReader::Behind::that_is() -> Read {
  static constexpr std::array kThat = {"that"sv, "which"sv, "who"sv, "where"sv};
  static constexpr std::array kAsks = {"belong"sv, "should"sv, "goe"sv, "need"sv};
  static constexpr std::array kHolds = {"has"sv, "have"sv, "hold"sv, "contain"sv};
  if (i_ + 1 >= end_) return {};
  const bool what_is = people() && word() == "what" && !phrase_.bare() &&
                       one_of(words_[i_ + 1], kLying);  // "the pillow what is on the shelf"
  if (!one_of(word(), kThat) && !what_is) return {};
  const std::size_t k = i_ + 1;
  if (one_of(words_[k], kAsks)) return i_;  // "a book that belongs on the shelf" asks for something
  if (word() == "where" && !lexicon_.is_place_name(phrase_.phrase) &&
      !(people() && one_of(phrase_.phrase, kFurniture)))
    return i_;  // "put the mug where the coke is"
  if (const std::size_t done = reader_.bears(k, end_, phrase_); done != k) return done;
  if (word() == "where") return i_;
  if (one_of(words_[k], kHolds))
    if (const Read done = that_holds(k + 1)) return done;
  const std::size_t done = reader_.relative(k, end_, phrase_);
  return done == k ? i_ : done;
}

// "the one the kettle is standing on"
auto NounPhraseReader::Behind::bears_something() -> Read {
  if (!people() || phrase_.bare() || !one_of(word(), kDeterminers)) return {};
  const std::size_t done = reader_.bears(i_, end_, phrase_, true);
  if (done == i_) return {};
  return done;
}

// "whatever is on the stove"; of "everything is warm" it tells
auto NounPhraseReader::Behind::whatever_is() -> Read {
  if (!phrase_.everything || (people() && phrase_.word == "everything") ||
      (word() != "is" && word() != "are"))
    return {};
  return reader_.relative(i_, end_, phrase_);
}

// "the cup you are holding", "the mug lying in the sink"
auto NounPhraseReader::Behind::held_or_lying() -> Read {
  static constexpr std::array kLies = {"lying"sv, "sitting"sv, "standing"sv, "currently"sv, "laying"sv};
  static constexpr std::array kHold = {"are"sv, "am"sv, "have"sv};
  const bool holds = (word() == "you" || word() == "i") && i_ + 1 < end_ &&
                     (one_of(words_[i_ + 1], kHold) || language_.verb(words_[i_ + 1]) == Frame::kTake ||
                      (people() && words_[i_ + 1] == "carry"));
  if (!holds && !one_of(word(), kLies)) return {};
  return reader_.relative(i_, end_, phrase_);
}

// "every cup we have", "the books you can find"
auto NounPhraseReader::Behind::that_we_have() -> Read {
  static constexpr std::array kOwned = {"have"sv, "own"sv,  "got"sv, "get"sv,
                                        "see"sv,  "find"sv, "can"sv, "need"sv};
  if ((word() != "we" && word() != "i" && word() != "you") || phrase_.plural == phrase_.all) return {};
  std::size_t k = i_ + 1;
  while (k < end_ && one_of(words_[k], kOwned)) ++k;
  if (k == i_ + 1 || (word() != "we" && words_[i_ + 1] == "have")) return {};
  return k;
}

// "the armchair without a pillow", "the plate without an egg on it", "the table with nothing on it"
auto NounPhraseReader::Behind::lacking() -> Read {
  const std::size_t done = reader_.lacks(i_, end_, phrase_);
  if (done == i_) return {};
  return done;
}

// "closest to the sink"; "next to the tv" (rewritten to "beside") is where something goes
auto NounPhraseReader::Behind::nearest() -> Read {
  if ((word() != "nearest" && word() != "beside" && word() != "near") || phrase_.bare()) return {};
  const std::size_t k = is(i_ + 1, "to") ? i_ + 2 : i_ + 1;
  NounPhrase place;
  const std::size_t done = reader_.read(k, end_, place);  // what stands beside it may be meant by "one" later
  if (done == k || word() != "nearest") return i_;
  if (place.person) {
    phrase_.adjectives.push_back("nearest");
  } else {
    place.where = Where::kNear;
    phrase_.at.push_back(place);
  }
  return done;
}

// "the door on the left"
auto NounPhraseReader::Behind::left_or_right() -> Read {
  if ((word() != "on" && word() != "to") || !is(i_ + 1, "the") ||
      !(is(i_ + 2, "left") || is(i_ + 2, "right")) || reader_.names_[i_ + 2] != 0)
    return {};
  phrase_.adjectives.push_back(words_[i_ + 2]);
  return is(i_ + 3, "side") || is(i_ + 3, "hand") ? i_ + 4 : i_ + 3;
}

}  // namespace goalnet::inference
