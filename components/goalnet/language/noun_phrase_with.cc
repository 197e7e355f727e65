// "with" behind a thing or place: "with the kettle on it", "with the coffee in it", "with the other one".
#include <array>

#include "components/goalnet/language/noun_phrase_behind.h"

namespace goalnet::inference {

using namespace word_group;

// Whether the place before `at` is what its part begins with: "into the bin with the chips".
bool NounPhraseReader::leads_part(std::size_t at) const {
  std::size_t k = at;
  while (k > 0 && !place_preposition(words_.text[k - 1]) && words_.text[k - 1] != "," &&
         words_.text[k - 1] != ".")
    --k;
  return k < 2 || words_.text[k - 2] == "," || words_.text[k - 2] == ".";
}

// "(the mug that has) coffee in it", "(the table that has) a plate on it"
auto NounPhraseReader::Behind::that_holds(std::size_t at) -> Read {
  NounPhrase inner;
  std::size_t done = reader_.read(at, end_, inner);
  if (done != at && language_.content(inner.phrase) != symbol::kNone) {
    phrase_.content = inner.phrase;
    if (done + 1 < end_ && (words_[done] == "in" || words_[done] == "inside"))
      done += words_[done + 1] == "it" ? 2 : 1;
    return done;
  }
  done = reader_.has_on_it(at, end_, phrase_);
  if (done == at) return {};
  return done;
}

// "the burner with the kettle on it"
auto NounPhraseReader::Behind::with_on_it() -> Read {
  if (word() != "with") return {};
  const std::size_t done = reader_.has_on_it(i_ + 1, end_, phrase_);
  if (done == i_ + 1) return {};
  return done;
}

// "on the shelf with the plate", "... with the other one"
auto NounPhraseReader::Behind::with_beside() -> Read {
  if (!people() || word() != "with" || !lexicon_.is_place_name(phrase_.phrase) || !phrase_.definite ||
      !reader_.in_place_ || !is(i_ + 1, "the") || reader_.leads_part(i_))
    return {};
  NounPhrase beside;
  const bool outer = reader_.in_place_;
  reader_.in_place_ = false;  // "one" is no place
  const std::size_t done = reader_.read(i_ + 1, end_, beside);
  reader_.in_place_ = outer;
  if (done == i_ + 1 || beside.person || beside.unknown || beside.bare() || beside.pronoun ||
      language_.content(beside.phrase) != symbol::kNone || (done < end_ && !language_.joins(words_[done])))
    return {};
  beside.where = Where::kUnder;
  phrase_.at.push_back(beside);
  return done;
}

// "full of coffee", "containing water", "with the coffee in it", "a can with coke"
auto NounPhraseReader::Behind::with_in_it() -> Read {
  const bool full_of = word() == "full" && is(i_ + 1, "of");
  const bool filled = word() == "containing" || full_of;
  if (!filled && word() != "with") return {};
  NounPhrase inner;
  const std::size_t from = full_of ? i_ + 2 : i_ + 1;
  const std::size_t done = reader_.read(from, end_, inner);
  const bool inside = is(done, "inside");
  const bool in_it = inside || (is(done, "in") &&
                                (done + 1 == end_ || words_[done + 1] == "it" || words_[done + 1] == "them"));
  const bool carrier =
      people() && word() == "with" && !inner.bare() &&
      (phrase_.word == "one" || (!inner.definite && (phrase_.phrase == "bottle" || phrase_.phrase == "can")));
  if (done == from || language_.content(inner.phrase) == symbol::kNone || !(filled || in_it || carrier))
    return i_;
  phrase_.content = inner.phrase;
  if (!in_it) return done;
  return std::min(inside && !is(done + 1, "it") ? done + 1 : done + 2, end_);
}

}  // namespace goalnet::inference
