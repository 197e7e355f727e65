#include "components/goalnet/language/language.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using std::string_view_literals::operator""sv;

const std::vector<std::string>& Language::homes(const std::string& class_name) const {
  static const std::vector<std::string> kNowhere;
  const auto it = homes_.find(class_name);
  return it == homes_.end() ? kNowhere : it->second;
}

std::string Language::kind_of(const std::string& word) const {
  for (const std::string& form : {word, singular(word)})
    if (const auto it = kinds_.find(form); it != kinds_.end()) return it->second;
  return {};
}

std::string Language::verb_base(const std::string& word) const {
  if (verbs_.contains(word)) return word;
  if (const auto it = inflected_.find(word); it != inflected_.end()) return it->second;
  const auto known_verb = [&](const std::string& stem) { return stem.size() > 1 && verbs_.contains(stem); };
  for (const std::string_view ending : {"ing", "ed", "d", "es", "s"}) {
    if (rewrites_.empty() || !word.ends_with(ending) || word.size() < ending.size() + 2) continue;
    const std::string stem = word.substr(0, word.size() - ending.size());
    if (known_verb(stem)) return stem;
    if (ending == "ing" || ending == "ed") {
      if (known_verb(stem + "e")) return stem + "e";
      if (stem.size() > 2 && stem.back() == stem[stem.size() - 2] &&
          known_verb(stem.substr(0, stem.size() - 1)))
        return stem.substr(0, stem.size() - 1);
    }
    if (ending == "ed" && stem.ends_with("i") && known_verb(stem.substr(0, stem.size() - 1) + "y"))
      return stem.substr(0, stem.size() - 1) + "y";
  }
  return {};
}

bool Language::english_verb(const std::string& word) const {
  if (english_verbs_.contains(word) || verb(word) != Frame::kNone) return true;
  for (const std::string_view ending : {"ing", "ed", "es", "s"}) {
    if (!word.ends_with(ending) || word.size() < ending.size() + 2) continue;
    std::string stem = word.substr(0, word.size() - ending.size());
    if (english_verbs_.contains(stem) || english_verbs_.contains(stem + "e")) return true;
    if (stem.size() > 2 && stem.back() == stem[stem.size() - 2]) stem.pop_back();
    if (stem.ends_with("i")) stem.back() = 'y';
    if (english_verbs_.contains(stem)) return true;
  }
  return false;
}

Frame Language::verb(const std::string& word) const {
  const auto it = verbs_.find(verb_base(word));
  return it == verbs_.end() ? Frame::kNone : it->second;
}

bool Language::participle(const std::string& word) const {
  const std::string base = verb_base(word);
  return !base.empty() && base != word && !(word == base + "s" || word == base + "es");
}

bool Language::adverb(const std::string& word) const {
  return word.size() > 4 && word.ends_with("ly") && !no_adverbs_.contains(word) &&
         !lexicon_->is_word_of_name(word);
}

bool Language::names_something(const std::string& word) const {
  return verbs_.contains(word) || lexicon_->is_name(word) || lexicon_->is_name(singular(word));
}

bool Language::names_thing(const std::string& word) const {
  return lexicon_->is_name(word) || lexicon_->is_name(singular(word));
}

bool Language::names_place(const std::string& phrase) const { return lexicon_->is_place_name(phrase); }

bool Language::small_word(const std::string& word) const {
  static constexpr std::array kSmall = {"the"sv, "on"sv, "off"sv, "in"sv,     "into"sv, "it"sv, "to"sv,
                                        "up"sv,  "my"sv, "and"sv, "please"sv, "onto"sv, "me"sv};
  return one_of(word, kSmall);
}

bool Language::joins(const std::string& word) const {
  static constexpr std::array kJoins = {"and"sv,  ","sv,    "then"sv,       "or"sv,
                                        "but"sv,  "also"sv, "afterwards"sv, "afterward"sv,
                                        "plus"sv, "next"sv, "finally"sv,    "lastly"sv};
  return one_of(word, kJoins);
}

bool Language::copula(const std::string& word) const {
  static constexpr std::array kCopulas = {
      "is"sv,   "are"sv,    "was"sv,    "were"sv, "be"sv,     "been"sv,    "being"sv, "am"sv,    "has"sv,
      "have"sv, "had"sv,    "gone"sv,   "went"sv, "got"sv,    "get"sv,     "look"sv,  "feel"sv,  "seem"sv,
      "does"sv, "do"sv,     "did"sv,    "goe"sv,  "belong"sv, "becomes"sv, "will"sv,  "would"sv, "could"sv,
      "stay"sv, "remain"sv, "should"sv, "must"sv, "need"sv,   "ought"sv};
  return one_of(word, kCopulas);
}

bool Language::time_unit(const std::string& word) const {
  static constexpr std::array kUnits = {"second"sv, "minute"sv, "hour"sv, "moment"sv, "while"sv,
                                        "time"sv,   "min"sv,    "sec"sv,  "bit"sv,    "now"sv};
  return one_of(word, kUnits);
}

bool Language::holds_things(const std::string& phrase) const {
  static constexpr std::array kVessels = {
      "mug"sv,    "cup"sv,     "glass"sv,    "long cup"sv,   "bowl"sv,       "plate"sv,
      "kettle"sv, "pot"sv,     "tall cup"sv, "coffee cup"sv, "coffee mug"sv, "saucepan"sv,
      "pan"sv,    "tumbler"sv, "dish"sv,     "container"sv,  "vessel"sv};
  return one_of(phrase, kVessels);
}

bool Language::side_or_part(const std::string& phrase) const {
  static constexpr std::array kParts = {"door"sv,   "left door"sv, "right door"sv, "side"sv,   "knob"sv,
                                        "button"sv, "top"sv,       "burner"sv,     "handle"sv, "screen"sv,
                                        "volume"sv, "sound"sv,     "channel"sv,    "end"sv};
  return one_of(phrase, kParts);
}

bool Language::tv_word(const std::string& phrase) const {
  return phrase == "channel" || phrase == "volume" || phrase == "sound";
}

bool Language::keeps_its_s(const std::string& word) const {
  return (fillers_.contains(word) || verbs_.contains(word) || copula(word) || states_.contains(word) ||
          inflected_.contains(word)) &&
         !lexicon_->is_name(singular(word)) && !verbs_.contains(singular(word));
}

Frame Language::wanted_by_state(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? Frame::kNone : it->second.wanted;
}

Frame Language::complaint(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? Frame::kNone : it->second.complaint;
}

std::string Language::opposite_state(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? std::string() : it->second.opposite;
}

const std::vector<std::string>* Language::wish(const std::string& word) const {
  const auto it = wishes_.find(word);
  return it == wishes_.end() ? nullptr : &it->second;
}

std::vector<std::string> Language::rewrite(std::vector<std::string> words, std::size_t most) const {
  return rewrites_.apply(std::move(words), most);
}

Symbol Language::content(const std::string& phrase) const {
  const auto it = contents_.find(phrase);
  return it == contents_.end() ? Symbol{symbol::kNone} : it->second;
}

bool Language::known(const std::string& word) const {
  return word == "." || word == "," || (!rewrites_.empty() && (verb(word) != Frame::kNone || adverb(word))) ||
         std::binary_search(vocabulary_.begin(), vocabulary_.end(), word) ||
         std::binary_search(vocabulary_.begin(), vocabulary_.end(), singular(word)) || seen_.contains(word) ||
         seen_.contains(singular(word)) ||
         lexicon_->is_word_of_name(singular(word));  // names learned from this world
}

const std::string& Language::synonym(const std::string& word) const {
  const auto it = synonyms_.find(word);
  return it == synonyms_.end() ? word : it->second;
}

}  // namespace goalnet::inference
