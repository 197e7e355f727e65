// The head of a noun phrase: the name, or what stands for one.
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::string NounPhraseReader::one() const {
  if (in_place_) return last_place_.empty() ? last_thing_ : last_place_;
  return last_thing_.empty() ? last_place_ : last_thing_;
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
      phrase.modifier = name(i), phrase.modifier_plural = words_.plural[after_name - 1];
      i = after_name;
    } else if (language_.hears_people() && after_name < end && names_[after_name] == 1 &&
               (words_.text[after_name] == "can" || words_.text[after_name] == "bottle")) {
      phrase.phrase = phrase.word = name(i);  // "the cola can" is the cola, full or not
      phrase.plural = words_.plural[after_name];
      last_thing_ = phrase.phrase;
      return after(after_name + 1, end, phrase);
    } else if (after_name < end && names_[after_name] > 0 && lexicon_.is_name(name(after_name))) {
      phrase.content = name(i);  // "the coffee mug", "a water glass"
      i = after_name;
    }
    phrase.phrase = phrase.word = name(i);
    phrase.plural = words_.plural[i + names_[i] - 1] || one_of(words_.text[i + names_[i] - 1], kCollective);
    i += names_[i];
    if (language_.hears_people() && phrase.phrase == "channel" && phrase.count == 0)
      phrase.number = phrase.ordinal;  // "the sixth channel"
    if (i < end && words_.text[i] == "one" && determined && !lexicon_.is_name(phrase.phrase + " one"))
      ++i;  // "the vanilla one"
    if (i < end && words_.text[i] == "number" && i + 1 < end && number_word(words_.text[i + 1])) ++i;
    if (i < end && phrase.count == 0 && !phrase.plural && (words_.text[i] != "one" || !determined) &&
        number_word(words_.text[i]) &&
        (!(i + 1 < end && names_[i + 1] > 0) ||
         (language_.hears_people() && i + 1 + names_[i + 1] < end &&  // "pillow 4 armchair 4"
          number_word(words_.text[i + 1 + names_[i + 1]]) > 0))) {
      phrase.number = number_word(words_.text[i]);
      ++i;
    }
    const bool furniture =
        language_.hears_people() && lexicon_.is_place_name(phrase.phrase) && !last_thing_.empty();
    // "fill one cup with water and put the other one away": what it is filled with is no "one"
    const bool only_content = language_.hears_people() && language_.holds_things(last_thing_) &&
                              language_.content(phrase.phrase) != symbol::kNone;
    if (!only_content) (in_place_ || furniture ? last_place_ : last_thing_) = phrase.phrase;
    // "pour the coffee into one cup and put the other one away"
    const Symbol before = language_.content(last_thing_);
    const bool only_content_before = before == symbol::kWater || before == symbol::kCoffee;
    if (language_.hears_people() && in_place_ && only_content_before && language_.holds_things(phrase.phrase))
      last_thing_ = phrase.phrase;
    return after(i, end, phrase);
  }
  if (word == "one" && i > 0 && (words_.text[i - 1] == "that" || words_.text[i - 1] == "this") &&
      !words_.plural[i]) {
    phrase.pronoun = true, phrase.word = "that";  // "bring me that one"
    return after(i + 1, end, phrase);
  }
  // "the instant ones", "the tall one": the word makes another name of what was spoken of
  if (language_.hears_people() && i + 1 < end && words_.text[i + 1] == "one" && determined &&
      !one().empty()) {
    const std::string last = one().substr(one().rfind(' ') == std::string::npos ? 0 : one().rfind(' ') + 1);
    if (lexicon_.is_name(word + " " + last)) {
      phrase.phrase = word + " " + last, phrase.word = phrase.phrase, phrase.plural = words_.plural[i + 1];
      return after(i + 2, end, phrase);
    }
  }
  if (word == "one" && (determined || !phrase.adjectives.empty())) {
    phrase.phrase = one(), phrase.word = "one", phrase.plural = words_.plural[i];
    if (phrase.phrase.empty()) phrase.pronoun = true;
    return after(i + 1, end, phrase);
  }
  if (NounPhrase place; language_.hears_people() && word == "thing" && !words_.plural[i] && phrase.definite &&
                        phrase.adjectives.empty() && phrase.count == 0 && phrase.ordinal == 0 &&
                        !phrase.all && after(i + 1, end, place) == i + 1 &&
                        read_place(i + 1, end, place) == i + 1) {
    phrase.pronoun = true,
    phrase.word = "it";  // "(take the bowl out of the microwave, then) close the thing"
    return i + 1;
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
    const bool given = language_.hears_people() && i + 2 < end && one_of(words_.text[i + 2], kArticles) &&
                       words_.text[i + 2] != "the";  // "give them both a rinse"
    if (i + 1 < end && (words_.text[i + 1] == "all" || words_.text[i + 1] == "both") &&
        (given || !starts(i + 2, end)))
      ++i, phrase.plural = true;
    return i + 1;
  }
  if (one_of(word, kPersons) || language_.person(word)) {
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
  if (phrase.has("other") && phrase.count > 0 && !one().empty()) {  // "and the other two on the table"
    phrase.phrase = phrase.word = one(), phrase.plural = phrase.count > 1;
    return i;
  }
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
      (place_preposition(word) || language_.joins(word) ||
       (language_.hears_people() &&
        (language_.copula(word) || word == "for" ||
         one_of(word, kDesire))))) {  // "the second on the shelf", "and the other in"
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

}  // namespace goalnet::inference
