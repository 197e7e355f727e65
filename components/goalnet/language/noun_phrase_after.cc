// What follows the head: "of coffee", "in the sink", "that is on the table", "full of water".
#include <algorithm>
#include <array>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

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

// Whether the place before `at` is what its part begins with: "into the bin with the chips".
bool NounPhraseReader::leads_part(std::size_t at) const {
  std::size_t k = at;
  while (k > 0 && !place_preposition(words_.text[k - 1]) && words_.text[k - 1] != "," &&
         words_.text[k - 1] != ".")
    --k;
  return k < 2 || words_.text[k - 2] == "," || words_.text[k - 2] == ".";
}

std::size_t NounPhraseReader::after(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  for (int round = 0; round < 4 && i < end; ++round) {
    const std::string& word = words_.text[i];
    if (language_.hears_people() && !phrase.bare() && floor(i, end) != i) {
      phrase.on_floor = true;
      i = floor(i, end);
      continue;
    }
    if (word == "of" && !phrase.phrase.empty()) {
      const std::size_t done = of(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
    }
    const bool what_is = language_.hears_people() && word == "what" && !phrase.bare() && i + 1 < end &&
                         one_of(words_.text[i + 1], kLying);  // "the pillow what is on the shelf"
    if ((word == "that" || word == "which" || word == "who" || word == "where" || what_is) && i + 1 < end) {
      std::size_t k = i + 1;
      if (words_.text[k] == "belong" || words_.text[k] == "should" || words_.text[k] == "goe" ||
          words_.text[k] == "need")
        return i;  // "a book that belongs on the shelf" asks for something
      // "the burner that the kettle is on", "the shelf where the beer is"
      if (word == "where" && !lexicon_.is_place_name(phrase.phrase) &&
          !(language_.hears_people() && one_of(phrase.phrase, kFurniture)))
        return i;  // "put the mug where the coke is"
      if (const std::size_t done = bears(k, end, phrase); done != k) {
        i = done;
        continue;
      }
      if (word == "where") return i;
      // "the mug that has coffee in it"
      if (words_.text[k] == "has" || words_.text[k] == "have" || words_.text[k] == "hold" ||
          words_.text[k] == "contain") {
        NounPhrase inner;
        const std::size_t done = read(k + 1, end, inner);
        if (done != k + 1 && language_.content(inner.phrase) != symbol::kNone) {
          phrase.content = inner.phrase;
          i = done;
          if (i + 1 < end && (words_.text[i] == "in" || words_.text[i] == "inside"))
            i += words_.text[i + 1] == "it" ? 2 : 1;
          continue;
        }
        if (const std::size_t on_it = has_on_it(k + 1, end, phrase); on_it != k + 1) {
          i = on_it;
          continue;
        }
      }
      const std::size_t done = relative(k, end, phrase);
      if (done == k) return i;
      i = done;
      continue;
    }
    // "the one the kettle is standing on"
    if (language_.hears_people() && !phrase.bare() && one_of(word, kDeterminers)) {
      const std::size_t done = bears(i, end, phrase, true);
      if (done != i) {
        i = done;
        continue;
      }
    }
    const bool whatever = !language_.hears_people() || phrase.word != "everything";  // "everything is warm"
    if (phrase.everything && whatever && (word == "is" || word == "are")) {  // "whatever is on the stove"
      const std::size_t done = relative(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
    }
    if (((word == "you" || word == "i") && i + 1 < end &&
         (words_.text[i + 1] == "are" || words_.text[i + 1] == "am" || words_.text[i + 1] == "have" ||
          language_.verb(words_.text[i + 1]) == Frame::kTake ||
          (language_.hears_people() && words_.text[i + 1] == "carry"))) ||
        word == "lying" || word == "sitting" || word == "standing" || word == "currently" ||
        word == "laying") {
      const std::size_t done = relative(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
    }
    // "every cup we have", "the books you can find"
    if ((word == "we" || word == "i" || word == "you") && i + 1 < end && phrase.plural != phrase.all) {
      static constexpr std::array kOwned = {"have"sv, "own"sv,  "got"sv, "get"sv,
                                            "see"sv,  "find"sv, "can"sv, "need"sv};
      std::size_t k = i + 1;
      while (k < end && one_of(words_.text[k], kOwned)) ++k;
      if (k > i + 1 && (word == "we" || words_.text[i + 1] != "have")) {
        i = k;
        continue;
      }
    }
    // "the armchair without a pillow", "the plate without an egg on it", "the table with nothing on it"
    if (const std::size_t done = lacks(i, end, phrase); done != i) {
      i = done;
      continue;
    }
    // "the burner with the kettle on it"
    if (word == "with") {
      const std::size_t done = has_on_it(i + 1, end, phrase);
      if (done != i + 1) {
        i = done;
        continue;
      }
    }
    // "on the shelf with the plate", "... with the other one"
    if (NounPhrase beside; language_.hears_people() && word == "with" &&
                           lexicon_.is_place_name(phrase.phrase) && phrase.definite && in_place_ &&
                           i + 1 < end && words_.text[i + 1] == "the" && !leads_part(i)) {
      const bool outer = in_place_;
      in_place_ = false;  // "one" is no place
      const std::size_t done = read(i + 1, end, beside);
      in_place_ = outer;
      if (done != i + 1 && !beside.person && !beside.unknown && !beside.bare() && !beside.pronoun &&
          language_.content(beside.phrase) == symbol::kNone &&
          (done >= end || language_.joins(words_.text[done]))) {
        beside.where = Where::kUnder;
        phrase.at.push_back(beside);
        i = done;
        continue;
      }
    }
    // "full of coffee", "containing water", "with the coffee in it"
    const bool filled = word == "containing" || (word == "full" && i + 1 < end && words_.text[i + 1] == "of");
    if (filled || word == "with") {
      NounPhrase inner;
      const std::size_t from = word == "full" ? i + 2 : i + 1;
      const std::size_t done = read(from, end, inner);
      const bool in_it = done + 1 < end + 1 && done < end &&
                         (words_.text[done] == "in" || words_.text[done] == "inside") &&
                         (done + 1 == end || words_.text[done + 1] == "it" ||
                          words_.text[done + 1] == "them" || words_.text[done] == "inside");
      const bool carrier = language_.hears_people() && word == "with" && !inner.bare() &&
                           (phrase.word == "one" ||
                            (!inner.definite && (phrase.phrase == "bottle" || phrase.phrase == "can")));
      if (done != from && language_.content(inner.phrase) != symbol::kNone && (filled || in_it || carrier)) {
        phrase.content = inner.phrase;
        i = in_it ? std::min(done + (words_.text[done] == "inside" &&
                                             !(done + 1 < end && words_.text[done + 1] == "it")
                                         ? 1
                                         : 2),
                             end)
                  : done;
        continue;
      }
      return i;
    }
    // "closest to the sink", "next to the tv" (rewritten to "beside")
    if ((word == "nearest" || word == "beside" || word == "near") && !phrase.bare()) {
      std::size_t k = i + 1;
      if (k < end && words_.text[k] == "to") ++k;
      NounPhrase place;
      const std::size_t done = read(k, end, place);
      if (done == k || word == "beside" || word == "near") return i;
      if (place.person) {
        phrase.adjectives.push_back("nearest");
      } else {
        place.where = Where::kNear;
        phrase.at.push_back(place);
      }
      i = done;
      continue;
    }
    // "the door on the left"
    if ((word == "on" || word == "to") && i + 2 < end + 0 && words_.text[i + 1] == "the" &&
        (words_.text[i + 2] == "left" || words_.text[i + 2] == "right") && names_[i + 2] == 0) {
      phrase.adjectives.push_back(words_.text[i + 2]);
      i += 3;
      if (i < end && (words_.text[i] == "side" || words_.text[i] == "hand")) ++i;
      continue;
    }
    return i;
  }
  return i;
}

}  // namespace goalnet::inference
