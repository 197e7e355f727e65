#include "components/goalnet/language/noun_phrase_opening.h"

#include <algorithm>

#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::size_t kLongestCompound = 4;  // words

}  // namespace

bool NounPhrase::has(std::string_view adjective) const {
  return std::find(adjectives.begin(), adjectives.end(), adjective) != adjectives.end();
}

bool is_pronoun(const std::string& word) { return one_of(word, kPronouns); }

NounPhraseReader::NounPhraseReader(const Words& words, const Language& language, const Lexicon& lexicon)
    : words_(words), language_(language), lexicon_(lexicon), names_(words.text.size(), 0) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    std::string phrase;
    for (std::size_t n = 1; n <= kLongestCompound && i + n <= names_.size(); ++n) {
      phrase += (n == 1 ? "" : " ") + words.text[i + n - 1];
      if (lexicon_.is_name(phrase) || language_.content(phrase) != symbol::kNone) names_[i] = n;
    }
    // "the one on the shelf can stay": no can of something
    if (words.text[i] == "can" && names_[i] == 1 && i + 1 < names_.size() &&
        (i == 0 || !one_of(words.text[i - 1], kArticles)) &&
        (words.text[i + 1] == "not" || words.text[i + 1] == "be" ||
         language_.english_verb(words.text[i + 1]) || language_.person(words.text[i + 1]) ||
         one_of(words.text[i + 1], kPersons)))
      names_[i] = 0;
    if (language_.hears_people() && words.text[i] == "new" && !words.plural[i] && names_[i] == 1)
      names_[i] = 0;  // "a new job" is no news
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
  if (language_.hears_people() && word == "any" && modifier_ahead(at + 1, end))
    return true;  // "on any burner"
  if (ordinal_word(word) > 0 && at + 2 < end && words_.text[at + 1] == "and" &&
      ordinal_word(words_.text[at + 2]) > 0)
    return modifier_ahead(at + 2, end);  // "first and third burner"
  return (number_word(word) || ordinal_word(word) || one_of(word, kStates) || one_of(word, kVague)) &&
         modifier_ahead(at, end);
}

std::size_t NounPhraseReader::read(std::size_t at, std::size_t end, NounPhrase& phrase, bool place) const {
  const bool outer = in_place_;
  in_place_ = in_place_ || place;
  const std::size_t done = read_phrase(at, end, phrase);
  in_place_ = outer;
  return done;
}

std::size_t NounPhraseReader::read_phrase(std::size_t at, std::size_t end, NounPhrase& phrase) const {
  return Opening(*this, at, end, phrase).read();
}

std::size_t NounPhraseReader::read_place(std::size_t at, std::size_t end, NounPhrase& place) const {
  if (at >= end || !place_preposition(words_.text[at], &place.where)) return at;
  const std::size_t done = read(at + 1, end, place, true);
  return done == at + 1 ? at : done;
}

}  // namespace goalnet::inference
