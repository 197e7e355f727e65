#include "components/goalnet/language/noun_phrase.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

template <std::size_t N>
bool one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::size_t kLongestName = 4;  // words
constexpr int kMostCounted = 20;

constexpr std::array kArticles = {"the"sv, "a"sv,   "an"sv,  "my"sv,    "your"sv,   "our"sv,
                                  "his"sv, "her"sv, "its"sv, "their"sv, "another"sv};
constexpr std::array kPointers = {"this"sv, "that"sv, "these"sv, "those"sv};
constexpr std::array kPronouns = {"it"sv, "them"sv, "they"sv};
constexpr std::array kPersons = {"me"sv, "us"sv, "you"sv, "him"sv, "myself"sv, "everyone"sv, "everybody"sv};
constexpr std::array kAll = {"all"sv, "every"sv, "each"sv};
constexpr std::array kThings = {"everything"sv, "stuff"sv,    "thing"sv,  "anything"sv,
                                "something"sv,  "whatever"sv, "object"sv, "item"sv};
constexpr std::array kMeasures = {"bit"sv,    "pinch"sv,   "splash"sv, "drop"sv,  "lot"sv,    "little"sv,
                                  "piece"sv,  "dash"sv,    "cube"sv,   "slice"sv, "dollop"sv, "kind"sv,
                                  "plenty"sv, "handful"sv, "packet"sv, "tub"sv,   "carton"sv, "squirt"sv,
                                  "sip"sv,    "amount"sv,  "pair"sv};
// Words for many things at once.
constexpr std::array kCollective = {"cutlery"sv,   "silverware"sv, "flatware"sv,  "glassware"sv,
                                    "tableware"sv, "crockery"sv,   "drinkware"sv, "furniture"sv};
constexpr std::array kStates = {"empty"sv,    "full"sv,  "hot"sv,   "cold"sv,  "warm"sv,    "open"sv,
                                "closed"sv,   "left"sv,  "right"sv, "other"sv, "nearest"sv, "near"sv,
                                "farthest"sv, "dirty"sv, "clean"sv, "wet"sv,   "dry"sv,     "different"sv,
                                "lit"sv,      "free"sv,  "same"sv,  "held"sv,  "boiling"sv, "last"sv,
                                "previous"sv, "next"sv};
// Adjectives that nothing in a world of facts can tell; kept in mind as such.
constexpr std::array kVague = {"big"sv,    "small"sv,  "little"sv, "large"sv,     "new"sv,      "old"sv,
                               "red"sv,    "blue"sv,   "green"sv,  "white"sv,     "brown"sv,    "black"sv,
                               "yellow"sv, "pink"sv,   "nice"sv,   "soft"sv,      "lovely"sv,   "entire"sv,
                               "whole"sv,  "single"sv, "own"sv,    "favourite"sv, "favorite"sv, "round"sv,
                               "shiny"sv,  "usual"sv,  "only"sv,   "fresh"sv};
constexpr std::array kLying = {"lying"sv,   "standing"sv, "sitting"sv,   "placed"sv, "kept"sv, "located"sv,
                               "resting"sv, "left"sv,     "currently"sv, "still"sv,  "now"sv,  "lie"sv,
                               "sit"sv,     "stand"sv,    "right"sv,     "is"sv,     "are"sv,  "was"sv,
                               "were"sv,    "all"sv,      "already"sv,   "laying"sv};

}  // namespace

bool NounPhrase::has(std::string_view adjective) const {
  return std::find(adjectives.begin(), adjectives.end(), adjective) != adjectives.end();
}

int number_word(const std::string& word) {
  static constexpr std::array kWords = {"one"sv, "two"sv,   "three"sv, "four"sv, "five"sv,
                                        "six"sv, "seven"sv, "eight"sv, "nine"sv, "ten"sv};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (kWords[i] == word) return static_cast<int>(i) + 1;
  if (word == "couple" || word == "both") return 2;
  if (word.empty() || word.size() > 2 || word.find_first_not_of("0123456789") != std::string::npos) return 0;
  return std::min(std::stoi(word), kMostCounted);
}

int ordinal_word(const std::string& word) {
  static constexpr std::array kWords = {"first"sv, "second"sv, "third"sv, "fourth"sv, "fifth"sv, "sixth"sv};
  static constexpr std::array kDigits = {"1st"sv, "2nd"sv, "3rd"sv, "4th"sv, "5th"sv, "6th"sv};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (kWords[i] == word || kDigits[i] == word) return static_cast<int>(i) + 1;
  return 0;
}

bool is_pronoun(const std::string& word) { return one_of(word, kPronouns); }

bool place_preposition(const std::string& word, Where* where) {
  static constexpr std::array<std::pair<std::string_view, Where>, 26> kPlaces = {{
      {"on", Where::kOn},       {"onto", Where::kOn},       {"upon", Where::kOn},
      {"over", Where::kOn},     {"atop", Where::kOn},       {"in", Where::kIn},
      {"into", Where::kIn},     {"inside", Where::kIn},     {"within", Where::kIn},
      {"to", Where::kTo},       {"toward", Where::kTo},     {"at", Where::kTo},
      {"near", Where::kNear},   {"by", Where::kNear},       {"beside", Where::kNear},
      {"nearby", Where::kNear}, {"behind", Where::kNear},   {"under", Where::kUnder},
      {"below", Where::kUnder}, {"beneath", Where::kUnder}, {"underneath", Where::kUnder},
      {"towards", Where::kTo},  {"along", Where::kNear},    {"between", Where::kNear},
      {"among", Where::kNear},  {"against", Where::kNear},
  }};
  for (const auto& [name, value] : kPlaces)
    if (name == word) {
      if (where != nullptr) *where = value;
      return true;
    }
  return false;
}

NounPhraseReader::NounPhraseReader(const Words& words, const Language& language, const Lexicon& lexicon)
    : words_(words), language_(language), lexicon_(lexicon), names_(words.text.size(), 0) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    std::string phrase;
    for (std::size_t n = 1; n <= kLongestName && i + n <= names_.size(); ++n) {
      phrase += (n == 1 ? "" : " ") + words.text[i + n - 1];
      if (lexicon_.is_name(phrase) || language_.content(phrase) != symbol::kNone) names_[i] = n;
    }
  }
}

std::string NounPhraseReader::name(std::size_t at) const {
  std::string phrase = words_.text[at];
  for (std::size_t k = 1; k < names_[at]; ++k) phrase += " " + words_.text[at + k];
  return phrase;
}

bool NounPhraseReader::modifier_ahead(std::size_t at, std::size_t end) const {
  for (std::size_t i = at; i < end && i < at + 4; ++i) {
    const std::string& word = words_.text[i];
    if (names_[i] > 0 || word == "one" || one_of(word, kThings)) return true;
    if (!one_of(word, kStates) && !one_of(word, kVague) && !number_word(word) && !ordinal_word(word))
      return false;
  }
  return false;
}

bool NounPhraseReader::starts(std::size_t at, std::size_t end) const {
  if (at >= end) return false;
  const std::string& word = words_.text[at];
  if (names_[at] > 0 || one_of(word, kArticles) || one_of(word, kPointers) || one_of(word, kPronouns) ||
      one_of(word, kAll) || one_of(word, kThings) || word == "both" || word == "some" ||
      one_of(word, kPersons))
    return true;
  return (number_word(word) || ordinal_word(word) || one_of(word, kStates) || one_of(word, kVague)) &&
         modifier_ahead(at, end);
}

std::string NounPhraseReader::one() const {
  if (in_place_) return last_place_.empty() ? last_thing_ : last_place_;
  return last_thing_.empty() ? last_place_ : last_thing_;
}

std::size_t NounPhraseReader::read(std::size_t at, std::size_t end, NounPhrase& phrase, bool place) const {
  const bool outer = in_place_;
  in_place_ = in_place_ || place;
  const std::size_t done = read_phrase(at, end, phrase);
  in_place_ = outer;
  return done;
}

std::size_t NounPhraseReader::read_phrase(std::size_t at, std::size_t end, NounPhrase& phrase) const {
  std::size_t i = at;
  bool determined = false;
  for (; i < end; ++i) {
    const std::string& word = words_.text[i];
    // "the second" is a place in a row where a thing follows; "a second" is time
    if (names_[i] > 0 && !(one_of(word, kStates) && modifier_ahead(i + 1, end))) break;
    if (one_of(word, kArticles)) {
      if (word == "another") phrase.adjectives.push_back("other");
      determined = true;
    } else if (one_of(word, kPointers)) {
      if (!starts(i + 1, end)) break;
      if (word == "this" || word == "that") phrase.plural = false;
      determined = true;
    } else if (one_of(word, kAll)) {
      phrase.all = determined = true;
    } else if (word == "both") {
      phrase.all = determined = true, phrase.count = 2;
    } else if (word == "some" || word == "few" || word == "several" || word == "any" || word == "enough" ||
               word == "more") {
      phrase.some = word != "any";
      determined = true;
    } else if (word == "rest" || word == "remaining" ||
               (word == "other" && i < words_.plural.size() && words_.plural[i])) {
      phrase.rest = phrase.all = determined = true;
      if (i + 1 >= end || (words_.text[i + 1] != "of" && names_[i + 1] == 0)) {
        phrase.everything = true, phrase.word = word;
        return after(i + 1, end, phrase);
      }
    } else if (word == "of" && determined && i > at && names_[i - 1] == 0) {
      continue;  // "all of the", "one of the"
    } else if (const int number = number_word(word)) {
      if (word == "one" && determined && !starts(i + 1, end) && !(i + 1 < end && words_.text[i + 1] == "of"))
        break;
      if (in_place_ && (i + 1 >= end || language_.joins(words_.text[i + 1]))) {  // "change the channel to 5"
        phrase.number = number, phrase.phrase = phrase.word = one();
        return phrase.phrase.empty() ? at : i + 1;
      }
      if (i + 1 >= end) break;
      phrase.count = number, determined = true;
    } else if (const int ordinal = ordinal_word(word)) {
      phrase.ordinal = ordinal, determined = true;
    } else if (one_of(word, kStates)) {
      if (!determined && !modifier_ahead(i, end)) break;
      phrase.adjectives.push_back(word);
    } else if (one_of(word, kVague)) {
      if (!determined && !modifier_ahead(i, end)) break;
      phrase.vague = phrase.vague || (word != "only" && word != "single" && word != "whole" &&
                                      word != "entire" && word != "own");
    } else {
      break;
    }
  }
  const std::size_t done = head(i, end, determined, phrase);
  if (done == i && !(determined && i > at)) return at;
  return done;
}

std::size_t NounPhraseReader::head(std::size_t i, std::size_t end, bool determined,
                                   NounPhrase& phrase) const {
  if (i >= end) {
    if (!determined) return i;
    if ((phrase.ordinal > 0 || !phrase.adjectives.empty()) &&
        !one().empty()) {  // "onto the fourth", "the other"
      phrase.phrase = phrase.word = one();
      return i;
    }
    phrase.pronoun = phrase.all || phrase.count > 0;  // "put both in the sink"
    phrase.plural = phrase.pronoun;
    if (!phrase.pronoun) phrase.unknown = true;
    return i;
  }
  const std::string& word = words_.text[i];
  if (names_[i] > 0) {
    std::size_t after_name = i + names_[i];
    // Two names side by side: the first says which of the second ("the shelf pillow", "the vanilla syrup").
    if (after_name < end && names_[after_name] > 0 && language_.content(name(i)) == symbol::kNone) {
      phrase.modifier = name(i);
      i = after_name;
    } else if (after_name < end && names_[after_name] > 0 && lexicon_.is_name(name(after_name))) {
      phrase.content = name(i);  // "the coffee mug", "a water glass"
      i = after_name;
    }
    phrase.phrase = phrase.word = name(i);
    phrase.plural = words_.plural[i + names_[i] - 1] || one_of(words_.text[i + names_[i] - 1], kCollective);
    i += names_[i];
    if (i < end && (words_.text[i] == "one") && !lexicon_.is_name(phrase.phrase + " one"))
      ++i;  // "the vanilla one"
    if (i < end && words_.text[i] == "number" && i + 1 < end && number_word(words_.text[i + 1])) ++i;
    if (i < end && phrase.count == 0 && !phrase.plural && words_.text[i] != "one" &&
        number_word(words_.text[i]) && !(i + 1 < end && names_[i + 1] > 0)) {
      phrase.number = number_word(words_.text[i]);
      ++i;
    }
    (in_place_ ? last_place_ : last_thing_) = phrase.phrase;
    return after(i, end, phrase);
  }
  if (word == "one" && (determined || !phrase.adjectives.empty())) {
    phrase.phrase = one(), phrase.word = "one", phrase.plural = words_.plural[i];
    if (phrase.phrase.empty()) phrase.pronoun = true;
    return after(i + 1, end, phrase);
  }
  if (one_of(word, kThings)) {
    phrase.everything = phrase.plural = true, phrase.all = word == "everything" || word == "stuff" ||
                                                           word == "whatever" || phrase.all ||
                                                           words_.plural[i];
    phrase.word = word;
    return after(i + 1, end, phrase);
  }
  if (one_of(word, kPronouns) || one_of(word, kPointers)) {
    phrase.pronoun = true, phrase.word = word;
    phrase.plural = word == "them" || word == "they" || word == "these" || word == "those" || phrase.all;
    if (i + 1 < end && (words_.text[i + 1] == "all" || words_.text[i + 1] == "both") && !starts(i + 2, end))
      ++i, phrase.plural = true;
    return i + 1;
  }
  if (one_of(word, kPersons)) {
    phrase.person = true;
    return i + 1;
  }
  if (word == "scoop" || word == "spoonful") {
    phrase.scoop = true, phrase.word = word;
    if (i + 1 < end && words_.text[i + 1] == "of") {
      NounPhrase what;
      const std::size_t done = read(i + 2, end, what);
      phrase.phrase = what.phrase, phrase.unknown = what.unknown, phrase.word = what.word;
      return done;
    }
    return i + 1;
  }
  if (one_of(word, kMeasures) && i + 1 < end && (words_.text[i + 1] == "of" || names_[i + 1] > 0)) {
    phrase.some = true, phrase.count = 0;
    return head(words_.text[i + 1] == "of" ? i + 2 : i + 1, end, true, phrase);
  }
  if ((word == "hand" || word == "gripper" || word == "arm") && determined) {
    phrase.hand = true;
    return i + 1;
  }
  if (!determined) return i;
  if (phrase.all || phrase.count > 0) {  // "put both in the sink", "take two"
    phrase.pronoun = phrase.plural = true, phrase.word = phrase.count == 2 ? "both" : "all";
    return i;
  }
  if (phrase.ordinal > 0 && language_.joins(word)) {  // "the first and third burner"
    NounPhrase next;
    if (read(i + 1, end, next) != i + 1 && !next.phrase.empty()) {
      phrase.phrase = phrase.word = next.phrase;
      return i;
    }
  }
  if ((phrase.ordinal > 0 || !phrase.adjectives.empty()) && !one().empty() &&
      (place_preposition(word) || language_.joins(word))) {  // "the second on the shelf", "and the other in"
    phrase.phrase = phrase.word = one();
    return i;
  }
  // A thing that nobody here knows. An unknown word before a name is an adjective ("the fluffy pillow").
  if (language_.known(word)) return i;
  if (i + 1 < end && names_[i + 1] > 0) {
    phrase.vague = true;
    return head(i + 1, end, determined, phrase);
  }
  phrase.unknown = true, phrase.word = word;
  return i + 1;
}

std::size_t NounPhraseReader::of(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  NounPhrase inner;
  const std::size_t done = read(i + 1, end, inner);
  if (done == i + 1) return i;
  if (inner.unknown) {  // "a cup of tea"
    phrase.unknown = true, phrase.word = inner.word;
  } else if (language_.content(inner.phrase) != symbol::kNone && language_.holds_things(phrase.phrase)) {
    phrase.content = inner.phrase;
    for (const std::string& adjective : inner.adjectives) phrase.adjectives.push_back(adjective);
  } else if (language_.holds_things(phrase.phrase)) {
    phrase.unknown = inner.phrase.empty(), phrase.modifier = inner.phrase;
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
    } else {
      phrase.modifier = inner.phrase;
    }
  }
  return done;
}

std::size_t NounPhraseReader::relative(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  std::size_t k = i;
  while (k < end && one_of(words_.text[k], kLying)) ++k;
  if (k + 1 < end && (words_.text[k] == "you" || words_.text[k] == "i") &&
      (words_.text[k + 1] == "are" || words_.text[k + 1] == "am" || words_.text[k + 1] == "have" ||
       language_.verb(words_.text[k + 1]) == Frame::kTake)) {
    ++k;
    while (k < end && (words_.text[k] == "are" || words_.text[k] == "am" || words_.text[k] == "have" ||
                       words_.text[k] == "currently" || words_.text[k] == "just" ||
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
  NounPhrase place;
  if (const std::size_t done = read_place(k, end, place); done != k) {
    if (place.hand || place.person)
      phrase.adjectives.push_back("held");
    else
      phrase.at.push_back(place);
    return done;
  }
  if (k < end && one_of(words_.text[k], kStates) && k > i) {
    phrase.adjectives.push_back(words_.text[k]);
    return k + 1;
  }
  return i;
}

std::size_t NounPhraseReader::after(std::size_t i, std::size_t end, NounPhrase& phrase) const {
  for (int round = 0; round < 4 && i < end; ++round) {
    const std::string& word = words_.text[i];
    if (word == "of" && !phrase.phrase.empty()) {
      const std::size_t done = of(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
    }
    if ((word == "that" || word == "which" || word == "who" || word == "where") && i + 1 < end) {
      std::size_t k = i + 1;
      // "the burner that the kettle is on", "the shelf where the beer is"
      if (NounPhrase there; names_[k] > 0 || one_of(words_.text[k], kArticles)) {
        const std::size_t done = read(k, end, there);
        if (done < end &&
            (words_.text[done] == "is" || words_.text[done] == "are" || words_.text[done] == "stand" ||
             words_.text[done] == "lie" || words_.text[done] == "sit")) {
          there.where = Where::kUnder;
          phrase.at.push_back(there);
          i = done + 1;
          if (i < end && (words_.text[i] == "on" || words_.text[i] == "in" || words_.text[i] == "at")) ++i;
          continue;
        }
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
      }
      const std::size_t done = relative(k, end, phrase);
      if (done == k) return i;
      i = done;
      continue;
    }
    if (phrase.everything && (word == "is" || word == "are")) {  // "whatever is on the stove"
      const std::size_t done = relative(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
    }
    if (((word == "you" || word == "i") && i + 1 < end &&
         (words_.text[i + 1] == "are" || words_.text[i + 1] == "am" || words_.text[i + 1] == "have" ||
          language_.verb(words_.text[i + 1]) == Frame::kTake)) ||
        word == "lying" || word == "sitting" || word == "standing" || word == "currently" ||
        word == "laying") {
      const std::size_t done = relative(i, end, phrase);
      if (done == i) return i;
      i = done;
      continue;
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
      if (done != from && language_.content(inner.phrase) != symbol::kNone && (filled || in_it)) {
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

std::size_t NounPhraseReader::read_place(std::size_t at, std::size_t end, NounPhrase& place) const {
  if (at >= end || !place_preposition(words_.text[at], &place.where)) return at;
  const std::size_t done = read(at + 1, end, place, true);
  return done == at + 1 ? at : done;
}

}  // namespace goalnet::inference
