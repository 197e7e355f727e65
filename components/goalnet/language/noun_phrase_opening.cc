// What a noun phrase begins with, up to its head: "the", "both", "the second", "three empty", "the rest of".
#include "components/goalnet/language/noun_phrase_opening.h"

#include <algorithm>

namespace goalnet::inference {

using namespace word_group;

std::size_t NounPhraseReader::Opening::read() {
  while (i_ < end_ && !done_) {
    // "the second" is a place in a row where a thing follows; "a second" is time
    if (reader_.names_[i_] > 0 && !(one_of(word(), kStates) && reader_.modifier_ahead(i_ + 1, end_))) break;
    if (!determiner() && !rest() && !of() && !number() && !adjective()) break;
    if (!done_) ++i_;
  }
  if (done_) return *done_;
  const std::size_t done = reader_.head(i_, end_, determined_, phrase_);
  if (done == i_ && !(determined_ && i_ > at_)) return at_;
  return done;
}

// "the", "another", "that", "every", "both", "some"
bool NounPhraseReader::Opening::determiner() {
  static constexpr std::array kSome = {"some"sv, "few"sv, "several"sv, "any"sv, "enough"sv, "more"sv};
  if (one_of(word(), kArticles)) {
    if (word() == "another") phrase_.adjectives.push_back("other");
    phrase_.definite = word() == "the";
  } else if (one_of(word(), kPointers)) {
    if (!reader_.starts(i_ + 1, end_)) return false;
    if (word() == "this" || word() == "that") phrase_.plural = false;
    phrase_.definite = true;
  } else if (one_of(word(), kAll)) {
    phrase_.all = true;
  } else if (word() == "both") {
    phrase_.all = true, phrase_.count = 2;
  } else if (one_of(word(), kSome)) {
    phrase_.some = word() != "any";
  } else {
    return false;
  }
  determined_ = true;
  return true;
}

// "the rest", "the remaining plates", "the others"
bool NounPhraseReader::Opening::rest() {
  const bool others = word() == "other" && i_ < reader_.words_.plural.size() && reader_.words_.plural[i_];
  if (word() != "rest" && word() != "remaining" && !others) return false;
  phrase_.rest = phrase_.all = determined_ = true;
  if (i_ + 1 >= end_ || (words_[i_ + 1] != "of" && reader_.names_[i_ + 1] == 0)) {
    phrase_.everything = true, phrase_.word = word();
    done_ = reader_.after(i_ + 1, end_, phrase_);
  }
  return true;
}

// "all of the", "one of the"
bool NounPhraseReader::Opening::of() const {
  return word() == "of" && determined_ && i_ > at_ && reader_.names_[i_ - 1] == 0;
}

// "three plates", "one", "the channel to 5", "get me two", "the second burner"
bool NounPhraseReader::Opening::number() {
  const int number = number_word(word());
  if (number == 0) {
    const int ordinal = ordinal_word(word());
    if (ordinal == 0) return false;
    phrase_.ordinal = ordinal, determined_ = true;
    return true;
  }
  const bool counts = reader_.starts(i_ + 1, end_) && !stands_alone() && !relative_follows();
  if (word() == "one" && determined_ && !counts && !is(i_ + 1, "of")) return false;
  if (number_of_last(number) || one_of_last() || some_of_last(number)) return true;
  if (i_ + 1 >= end_) return false;
  phrase_.count = number, determined_ = true;
  return true;
}

// "give that one a pillow"
bool NounPhraseReader::Opening::stands_alone() const {
  return reader_.language_.hears_people() && i_ > at_ && one_of(words_[i_ - 1], kPointers) && i_ + 1 < end_ &&
         one_of(words_[i_ + 1], kArticles);
}

// "the one my bowl is on"
bool NounPhraseReader::Opening::relative_follows() const {
  const Language& language = reader_.language_;
  return language.hears_people() && word() == "one" && determined_ && i_ + 1 < end_ &&
         (one_of(words_[i_ + 1], kDeterminers) ||
          (words_[i_ + 1] == "that" && i_ + 2 < end_ && language.copula(words_[i_ + 2])));
}

// "change the channel to 5"
bool NounPhraseReader::Opening::number_of_last(int number) {
  if (!reader_.in_place_ || (i_ + 1 < end_ && !reader_.language_.joins(words_[i_ + 1]))) return false;
  phrase_.number = number, phrase_.phrase = phrase_.word = reader_.one();
  done_ = phrase_.phrase.empty() ? at_ : i_ + 1;
  return true;
}

// "get me one", "put one on the table", "put one in"
bool NounPhraseReader::Opening::one_of_last() {
  static constexpr std::array kBehind = {"for"sv, "there"sv, "here"sv};
  const Language& language = reader_.language_;
  if (word() != "one" || determined_ || reader_.last_thing_.empty()) return false;
  if (i_ + 1 < end_) {
    const std::string& next = words_[i_ + 1];
    const bool place = language.hears_people() && (place_preposition(next) || one_of(next, kBehind));
    const bool in = (next == "in" || next == "on") && (i_ + 2 >= end_ || language.joins(words_[i_ + 2]));
    if (!language.joins(next) && next != "please" && !place && !in) return false;
  }
  phrase_.phrase = phrase_.word = reader_.last_thing_;
  done_ = i_ + 1;
  return true;
}

// "one pillow is not enough, get me two"
bool NounPhraseReader::Opening::some_of_last(int number) {
  const Language& language = reader_.language_;
  const std::string& last = reader_.last_thing_;
  if (!language.hears_people() || number <= 1 || determined_ || i_ != at_ || at_ == 0 || last.empty() ||
      !(one_of(words_[at_ - 1], kPersons) || language.verb(words_[at_ - 1]) != Frame::kNone) ||
      language.tv_word(last) || reader_.lexicon_.is_place_name(last) ||
      !(i_ + 1 >= end_ || words_[i_ + 1] == "please"))
    return false;
  phrase_.phrase = phrase_.word = last, phrase_.count = number, phrase_.plural = true;
  done_ = i_ + 1;
  return true;
}

// "empty", "hot"; "big" says nothing here
bool NounPhraseReader::Opening::adjective() {
  const bool state = one_of(word(), kStates);
  if (!state && !one_of(word(), kVague)) return false;
  if (!determined_ && !reader_.modifier_ahead(i_, end_)) return false;
  if (state) phrase_.adjectives.push_back(word());
  return true;
}

}  // namespace goalnet::inference
