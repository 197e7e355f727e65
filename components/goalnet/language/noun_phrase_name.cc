// The name that is the head of a noun phrase: "the coffee mug", "the shelf pillow", "pillow 4", "the vanilla
// one".
#include "components/goalnet/language/noun_phrase_head.h"

namespace goalnet::inference {

using namespace word_group;

NounPhraseReader::Head::Read NounPhraseReader::Head::name() {
  if (reader_.names_[i_] == 0) return std::nullopt;
  if (two_names()) return after(i_);
  phrase_.phrase = phrase_.word = reader_.name(i_);
  const std::size_t last = i_ + reader_.names_[i_] - 1;
  phrase_.plural = words_.plural[last] || one_of(words_.text[last], kCollective);
  i_ = last + 1;
  if (people() && phrase_.phrase == "channel" && phrase_.count == 0)
    phrase_.number = phrase_.ordinal;  // "the sixth channel"
  if (is(i_, "one") && determined_ && !lexicon_.is_name(phrase_.phrase + " one")) ++i_;  // "the vanilla one"
  numbered();
  remember_name();
  return after(i_);
}

// Two names side by side: the first says which of the second ("the shelf pillow", "the vanilla syrup", "the
// coffee mug"). Whether both are read so; else the name is at `i_`.
bool NounPhraseReader::Head::two_names() {
  const std::size_t next = i_ + reader_.names_[i_];
  if (name_at(next) == 0) return false;
  if (language_.content(reader_.name(i_)) == symbol::kNone) {
    phrase_.modifier = reader_.name(i_), phrase_.modifier_plural = words_.plural[next - 1];
    i_ = next;
  } else if (people() && reader_.names_[next] == 1 && (is(next, "can") || is(next, "bottle"))) {
    phrase_.phrase = phrase_.word = reader_.name(i_);  // "the cola can" is the cola, full or not
    phrase_.plural = words_.plural[next];
    reader_.last_thing_ = phrase_.phrase;
    i_ = next + 1;
    return true;
  } else if (lexicon_.is_name(reader_.name(next))) {
    phrase_.content = reader_.name(i_);  // "the coffee mug", "a water glass"
    i_ = next;
  }
  return false;
}

// "pillow 4", "burner number two"
void NounPhraseReader::Head::numbered() {
  if (is(i_, "number") && i_ + 1 < end_ && number_word(words_.text[i_ + 1])) ++i_;
  if (i_ >= end_ || phrase_.count > 0 || phrase_.plural || (word() == "one" && determined_)) return;
  const std::size_t behind = i_ + 1 + name_at(i_ + 1);
  const bool counts_next =  // "pillow 4 armchair 4" does not
      name_at(i_ + 1) > 0 && !(people() && behind < end_ && number_word(words_.text[behind]) > 0);
  if (number_word(word()) == 0 || counts_next) return;
  phrase_.number = number_word(word());
  ++i_;
}

// What "one" will stand for.
void NounPhraseReader::Head::remember_name() {
  std::string& last_thing = reader_.last_thing_;
  const bool furniture = people() && lexicon_.is_place_name(phrase_.phrase) && !last_thing.empty();
  // "fill one cup with water and put the other one away": what it is filled with is no "one"
  const bool only_content =
      people() && language_.holds_things(last_thing) && language_.content(phrase_.phrase) != symbol::kNone;
  if (!only_content) (reader_.in_place_ || furniture ? reader_.last_place_ : last_thing) = phrase_.phrase;
  // "pour the coffee into one cup and put the other one away"
  const Symbol before = language_.content(last_thing);
  const bool only_content_before = before == symbol::kWater || before == symbol::kCoffee;
  if (people() && reader_.in_place_ && only_content_before && language_.holds_things(phrase_.phrase))
    last_thing = phrase_.phrase;
}

}  // namespace goalnet::inference
