#include "components/goalnet/language/spoken_forms.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

}  // namespace

void resolve_endings(std::vector<std::string>& words, const Language& language) {
  // Behind these "'s" is a verb; before a name it says whose.
  static constexpr std::array kBehindIs = {
      "a"sv,        "an"sv,    "the"sv,   "too"sv,    "so"sv,     "very"sv,   "really"sv, "just"sv,
      "still"sv,    "all"sv,   "been"sv,  "gone"sv,   "got"sv,    "going"sv,  "not"sv,    "already"sv,
      "always"sv,   "never"sv, "now"sv,   "on"sv,     "in"sv,     "at"sv,     "off"sv,    "over"sv,
      "out"sv,      "up"sv,    "under"sv, "by"sv,     "near"sv,   "here"sv,   "there"sv,  "about"sv,
      "quite"sv,    "way"sv,   "only"sv,  "no"sv,     "beside"sv, "behind"sv, "lying"sv,  "sitting"sv,
      "standing"sv, "done"sv,  "had"sv,   "become"sv, "getting"sv};
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != "'s") {
      kept.push_back(words[i]);
      continue;
    }
    // "armchair 1's pillow" is the one on armchair 1
    if (i > 1 && number_word(words[i - 1]) > 0 && language.names_something(words[i - 2]) && kept.size() > 1 &&
        (ends_part(words, i + 1) || language.names_something(words[i + 1]))) {
      std::string thing = "one";
      if (!ends_part(words, i + 1)) thing = words[++i];
      kept.insert(kept.end() - 2, {"the", thing, "on"});
      continue;
    }
    if (ends_part(words, i + 1)) continue;
    const std::string& next = words[i + 1];
    const bool noun_next = language.names_something(next);
    const bool noun_behind = i + 2 < words.size() && language.names_something(words[i + 2]);
    const bool state = language.wanted_by_state(next) != Frame::kNone ||
                       language.complaint(next) != Frame::kNone || language.wish(next) != nullptr;
    const bool verb_form = (next.size() > 4 && (next.ends_with("ing") || next.ends_with("ed"))) ||
                           (language.participle(next) && !noun_next);
    // "this coffee's ancient, ...": of a word behind which the part ends
    const bool describes = !noun_next && ends_part(words, i + 2);
    if (one_of(next, kBehindIs) || (state && !noun_behind) || (verb_form && !noun_behind) || describes)
      kept.emplace_back(next == "got" ? "has" : "is");  // "it's got coffee in it"
  }
  words = std::move(kept);
}

void expand_contractions(std::vector<std::string>& words, const Language& language) {
  // "heat the mug, its cold": no thing of it follows
  static constexpr std::array kBehindItIs = {"too"sv,     "so"sv,     "not"sv,  "still"sv,
                                             "very"sv,    "really"sv, "just"sv, "gone"sv,
                                             "getting"sv, "going"sv,  "all"sv,  "already"sv};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] != "its") continue;
    const std::string& next = words[i + 1];
    const bool state =
        language.wanted_by_state(next) != Frame::kNone || language.complaint(next) != Frame::kNone;
    const bool thing_behind = i + 2 < words.size() && language.names_thing(words[i + 2]);
    const bool doing = next.size() > 5 && next.ends_with("ing") && !thing_behind;  // "its melting"
    if (!one_of(next, kBehindItIs) && !doing && (!state || thing_behind)) continue;
    words[i] = "it";
    words.insert(words.begin() + static_cast<long>(i) + 1, "is");
  }
  static constexpr std::array<std::array<std::string_view, 3>, 21> kForms = {
      {{"im", "i", "am"},          {"ive", "i", "have"},       {"id", "i", "would"},
       {"youre", "you", "are"},    {"youve", "you", "have"},   {"youd", "you", "would"},
       {"theyre", "they", "are"},  {"theyve", "they", "have"}, {"weve", "we", "have"},
       {"wed", "we", "would"},     {"theyd", "they", "would"}, {"youll", "you", "will"},
       {"itd", "it", "would"},     {"itll", "it", "will"},     {"thatd", "that", "would"},
       {"thatll", "that", "will"}, {"hes", "he", "is"},        {"shes", "she", "is"},
       {"thats", "that", "is"},    {"theres", "there", "is"},  {"whats", "what", "is"}}};
  static constexpr std::array kBeforeDays = {"on"sv, "next"sv, "every"sv, "by"sv, "until"sv};
  std::vector<std::string> whole;
  for (const std::string& word : words) {
    const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const auto& f) { return f[0] == word; });
    const bool day = word == "wed" && !whole.empty() && one_of(whole.back(), kBeforeDays);
    if (form == kForms.end() || day) {
      whole.push_back(word);
      continue;
    }
    whole.emplace_back(form->at(1));
    whole.emplace_back(form->at(2));
  }
  words = std::move(whole);
}

void drop_thrown_in(std::vector<std::string>& words, const Language& language) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (language.adverb(word) && words.size() > 1) continue;
    // "could you please bring": found as "could you bring"
    if ((word == "please" || word == "kindly" || word == "pls" || word == "plz") && i > 0 &&
        !ends_part(words, i - 1) && !ends_part(words, i + 1) && words[i - 1] != "and") {
      std::size_t end = i + 1;
      while (!ends_part(words, end)) ++end;
      bool verb = false;
      for (std::size_t k = i + 1; k < end; ++k) verb = verb || language.verb(words[k]) != Frame::kNone;
      if (verb) continue;
    }
    kept.push_back(word);
  }
  words = std::move(kept);
}

// "what this coffee needs is a squirt of chocolate"
void needs_first(std::vector<std::string>& words) {
  constexpr std::size_t kLongestAsked = 5;
  for (std::size_t i = 0; i + 3 < words.size(); ++i) {
    if (words[i] != "what" || !(i == 0 || ends_part(words, i - 1))) continue;
    for (std::size_t k = i + 2; k + 1 < words.size() && k <= i + kLongestAsked; ++k)
      if ((words[k] == "needs" || words[k] == "need" || words[k] == "wants" || words[k] == "lacks") &&
          words[k + 1] == "is" && words[i + 1] != "i" && words[i + 1] != "we" && words[i + 1] != "you") {
        words.erase(words.begin() + static_cast<long>(k) + 1);
        words.erase(words.begin() + static_cast<long>(i));
        break;
      }
  }
}

// "the stove is no place for a coke": it should not be there
void no_places(std::vector<std::string>& words) {
  for (std::size_t i = 0; i + 4 < words.size(); ++i) {
    if (words[i] != "is" || words[i + 1] != "no" || words[i + 2] != "place" || words[i + 3] != "for")
      continue;
    std::size_t begin = i, end = i + 4;
    while (begin > 0 && !ends_part(words, begin - 1)) --begin;
    while (!ends_part(words, end)) ++end;
    std::vector<std::string> said(words.begin() + static_cast<long>(i) + 4,
                                  words.begin() + static_cast<long>(end));
    said.insert(said.end(), {"should", "not", "be", "on"});
    said.insert(said.end(), words.begin() + static_cast<long>(begin), words.begin() + static_cast<long>(i));
    std::copy(said.begin(), said.end(), words.begin() + static_cast<long>(begin));  // of the same length
  }
}

// "not the coke, the beer": the beer is wanted
void not_but(std::vector<std::string>& words) {
  constexpr std::size_t kLongest = 5;
  for (std::size_t begin = 0; begin < words.size(); ++begin) {
    if (begin > 0 && words[begin - 1] != ".") continue;
    std::size_t i = begin;
    static constexpr std::array kBefore = {"no"sv, ","sv,  "wait"sv, "nah"sv,     "nope"sv,
                                           "oh"sv, "er"sv, "um"sv,   "actually"sv};
    while (i < words.size() && one_of(words[i], kBefore)) ++i;  // "no, not the coke, ..."
    if (i + 4 >= words.size() || words[i] != "not" || !one_of(words[i + 1], word_group::kArticles)) continue;
    std::size_t end = i + 1;
    while (end < words.size() && !ends_part(words, end) && words[end] != "but") ++end;
    std::size_t next = end;
    while (next < words.size() && (words[next] == "," || words[next] == "but")) ++next;
    if (end > i + kLongest || next == end || next >= words.size() ||
        !one_of(words[next], word_group::kArticles))
      continue;
    words.erase(words.begin() + static_cast<long>(begin), words.begin() + static_cast<long>(next));
    if (begin == 0)
      words.insert(words.begin(), "wish");
    else  // of what was asked in the sentence before
      words.insert(words.begin() + static_cast<long>(begin), {"no", ","});
  }
}

// "the beer. No, I am driving. Coke then.": the reason in between is passed over
void reasons_of_corrections(std::vector<std::string>& words) {
  static constexpr std::array kWho = {"i"sv, "we"sv, "it"sv, "he"sv, "she"sv, "they"sv, "that"sv};
  constexpr std::size_t kLongest = 3;
  for (std::size_t i = 1; i + 4 < words.size(); ++i) {
    if (words[i - 1] != "." || words[i] != "no") continue;
    const std::size_t who = words[i + 1] == "," ? i + 2 : i + 1;
    if (!one_of(words[who], kWho)) continue;
    std::size_t end = who;
    while (end < words.size() && words[end] != "." && words[end] != ",") ++end;
    std::size_t next = end + 1, last = next;
    while (last < words.size() && words[last] != ".") ++last;
    if (end >= words.size() || words[end] != "." || last <= next || last - next > kLongest) continue;
    words.erase(words.begin() + static_cast<long>(i), words.begin() + static_cast<long>(next));
    words.insert(words.begin() + static_cast<long>(i), {"no", ","});
  }
}

void afterthoughts_first(std::vector<std::string>& words) {
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (words[i] != "i" || (words[i + 1] != "mean" && words[i + 1] != "meant") || !ends_part(words, i + 2))
      continue;
    std::size_t begin = i;
    while (begin > 0 && !ends_part(words, begin - 1)) --begin;
    if (begin == i || begin == 0) continue;
    words.erase(words.begin() + static_cast<long>(i), words.begin() + static_cast<long>(i) + 2);
    words.insert(words.begin() + static_cast<long>(begin), "correction");
  }
}

void join_pauses(std::vector<std::string>& words) {
  std::vector<std::string> kept;
  for (const std::string& word : words) {
    const bool pause = word == "," || word == ".";
    if (pause && !kept.empty() && kept.back() == ",") kept.pop_back();
    if (word == "," && (kept.empty() || kept.back() == ".")) continue;
    if (word == "." && !kept.empty() && kept.back() == ".") continue;
    kept.push_back(word);
  }
  words = std::move(kept);
}

}  // namespace goalnet::inference
