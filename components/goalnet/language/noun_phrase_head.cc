// The head of a noun phrase that is no name: "the other one", "it", "everything", "a scoop of ice cream".
#include "components/goalnet/language/noun_phrase_head.h"

#include <array>

namespace goalnet::inference {

using namespace word_group;

std::string NounPhraseReader::one() const {
  if (in_place_) return last_place_.empty() ? last_thing_ : last_place_;
  return last_thing_.empty() ? last_place_ : last_thing_;
}

std::size_t NounPhraseReader::head(std::size_t i, std::size_t end, bool determined,
                                   NounPhrase& phrase) const {
  return Head(*this, i, end, determined, phrase).read();
}

std::size_t NounPhraseReader::Head::read() {
  static constexpr std::array<Rule, 19> kRules = {
      &Head::nothing,            // "(put) both", "(onto) the fourth"
      &Head::name,               // "(the) mug"
      &Head::that_one,           // "(bring me that) one"
      &Head::other_name_of_one,  // "(the) instant one(s)"
      &Head::the_one,            // "(the empty) one"
      &Head::the_thing,          // "(close the) thing"
      &Head::any_thing,          // "everything", "stuff"
      &Head::pronoun,            // "it", "them all"
      &Head::person,             // "me", "grandma"
      &Head::scoop,              // "(a) scoop of ice cream"
      &Head::measure,            // "(a) splash of milk"
      &Head::hand,               // "(your) hand"
      &Head::undetermined,       // any other word needs "the", "two" or the like before it
      &Head::other_ones,         // "(the other two) on the table"
      &Head::as_many,            // "(both) in the sink"
      &Head::first_of_several,   // "(the first) and third burner"
      &Head::the_second,         // "(the second) on the shelf"
      &Head::known,              // "(the) quickly": nothing
      &Head::unknown,            // "(the) flurb", "(the fluffy) pillow"
  };
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return *done;
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::nothing() {
  if (i_ < end_) return std::nullopt;
  if (!determined_) return i_;
  if ((phrase_.ordinal > 0 || !phrase_.adjectives.empty()) && !reader_.one().empty()) {
    phrase_.phrase = phrase_.word = reader_.one();
    return i_;
  }
  phrase_.pronoun = phrase_.plural = phrase_.all || phrase_.count > 0;
  if (!phrase_.pronoun) phrase_.unknown = true;
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::that_one() {
  if (word() != "one" || i_ == 0 || !(is(i_ - 1, "that") || is(i_ - 1, "this")) || words_.plural[i_])
    return std::nullopt;
  phrase_.pronoun = true, phrase_.word = "that";
  return after(i_ + 1);
}

// "the instant ones", "the tall one": the word makes another name of what was spoken of
NounPhraseReader::Head::Read NounPhraseReader::Head::other_name_of_one() {
  if (!people() || !is(i_ + 1, "one") || !determined_ || reader_.one().empty()) return std::nullopt;
  const std::string one = reader_.one();
  const std::size_t blank = one.rfind(' ');
  const std::string name = word() + " " + one.substr(blank == std::string::npos ? 0 : blank + 1);
  if (!lexicon_.is_name(name)) return std::nullopt;
  phrase_.phrase = phrase_.word = name, phrase_.plural = words_.plural[i_ + 1];
  return after(i_ + 2);
}

NounPhraseReader::Head::Read NounPhraseReader::Head::the_one() {
  if (word() != "one" || !(determined_ || !phrase_.adjectives.empty())) return std::nullopt;
  phrase_.phrase = reader_.one(), phrase_.word = "one", phrase_.plural = words_.plural[i_];
  if (phrase_.phrase.empty()) phrase_.pronoun = true;
  return after(i_ + 1);
}

// "(take the bowl out of the microwave, then) close the thing"
NounPhraseReader::Head::Read NounPhraseReader::Head::the_thing() {
  NounPhrase place;
  if (!people() || word() != "thing" || words_.plural[i_] || !phrase_.definite ||
      !phrase_.adjectives.empty() || phrase_.count > 0 || phrase_.ordinal > 0 || phrase_.all ||
      reader_.after(i_ + 1, end_, place) != i_ + 1 || reader_.read_place(i_ + 1, end_, place) != i_ + 1)
    return std::nullopt;
  phrase_.pronoun = true, phrase_.word = "it";
  return i_ + 1;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::any_thing() {
  static constexpr std::array kEvery = {"everything"sv, "stuff"sv, "whatever"sv};
  if (!one_of(word(), kThings)) return std::nullopt;
  phrase_.everything = phrase_.plural = true, phrase_.word = word();
  phrase_.all = phrase_.all || one_of(word(), kEvery) || words_.plural[i_];
  return after(i_ + 1);
}

NounPhraseReader::Head::Read NounPhraseReader::Head::pronoun() {
  static constexpr std::array kMany = {"them"sv, "they"sv, "these"sv, "those"sv};
  if (!one_of(word(), kPronouns) && !one_of(word(), kPointers)) return std::nullopt;
  phrase_.pronoun = true, phrase_.word = word();
  phrase_.plural = one_of(word(), kMany) || phrase_.all;
  const bool given = people() && i_ + 2 < end_ && one_of(words_.text[i_ + 2], kArticles) &&
                     words_.text[i_ + 2] != "the";  // "give them both a rinse"
  if (!(is(i_ + 1, "all") || is(i_ + 1, "both")) || !(given || !reader_.starts(i_ + 2, end_))) return i_ + 1;
  phrase_.plural = true;
  return i_ + 2;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::person() {
  if (!one_of(word(), kPersons) && !language_.person(word())) return std::nullopt;
  phrase_.person = true;
  return i_ + 1;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::scoop() {
  if (word() != "scoop" && word() != "spoonful") return std::nullopt;
  phrase_.scoop = true, phrase_.word = word();
  if (!is(i_ + 1, "of")) return i_ + 1;
  NounPhrase what;
  const std::size_t done = reader_.read(i_ + 2, end_, what);
  phrase_.phrase = what.phrase, phrase_.unknown = what.unknown, phrase_.word = what.word;
  return done;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::measure() {
  if (!one_of(word(), kMeasures) || !(is(i_ + 1, "of") || name_at(i_ + 1) > 0)) return std::nullopt;
  phrase_.some = true, phrase_.count = 0;
  return reader_.head(is(i_ + 1, "of") ? i_ + 2 : i_ + 1, end_, true, phrase_);
}

NounPhraseReader::Head::Read NounPhraseReader::Head::hand() {
  if (!determined_ || !(word() == "hand" || word() == "gripper" || word() == "arm")) return std::nullopt;
  phrase_.hand = true;
  return i_ + 1;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::undetermined() {
  if (determined_) return std::nullopt;
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::other_ones() {
  if (!phrase_.has("other") || phrase_.count == 0 || reader_.one().empty()) return std::nullopt;
  phrase_.phrase = phrase_.word = reader_.one(), phrase_.plural = phrase_.count > 1;
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::as_many() {
  if (!phrase_.all && phrase_.count == 0) return std::nullopt;
  phrase_.pronoun = phrase_.plural = true, phrase_.word = phrase_.count == 2 ? "both" : "all";
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::first_of_several() {
  if (phrase_.ordinal == 0 || !language_.joins(word())) return std::nullopt;
  NounPhrase next;
  if (reader_.read(i_ + 1, end_, next) == i_ + 1 || next.phrase.empty()) return std::nullopt;
  phrase_.phrase = phrase_.word = next.phrase;
  return i_;
}

// "the second on the shelf", "and the other in"
NounPhraseReader::Head::Read NounPhraseReader::Head::the_second() {
  const bool ends = place_preposition(word()) || language_.joins(word()) ||
                    (people() && (language_.copula(word()) || word() == "for" || one_of(word(), kDesire)));
  if ((phrase_.ordinal == 0 && phrase_.adjectives.empty()) || reader_.one().empty() || !ends)
    return std::nullopt;
  phrase_.phrase = phrase_.word = reader_.one();
  return i_;
}

NounPhraseReader::Head::Read NounPhraseReader::Head::known() {
  if (!language_.known(word())) return std::nullopt;
  return i_;
}

// A thing that nobody here knows. An unknown word before a name is an adjective ("the fluffy pillow").
NounPhraseReader::Head::Read NounPhraseReader::Head::unknown() {
  if (name_at(i_ + 1) > 0) return reader_.head(i_ + 1, end_, determined_, phrase_);
  phrase_.unknown = true, phrase_.word = word();
  return i_ + 1;
}

}  // namespace goalnet::inference
