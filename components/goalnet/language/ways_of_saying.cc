#include "components/goalnet/language/ways_of_saying.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

// "I would be very grateful", "could you maybe": ways of saying the same are found without these.
void drop_intensifiers(std::vector<std::string>& text) {
  static constexpr std::array kDropped = {"very"sv,       "really"sv,    "just"sv,       "maybe"sv,
                                          "perhaps"sv,    "truly"sv,     "absolutely"sv, "totally"sv,
                                          "definitely"sv, "ever"sv,      "so"sv,         "possibly"sv,
                                          "honestly"sv,   "seriously"sv, "literally"sv};
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string& word = text[i];
    // "so" joins clauses, unless it stresses: "so thirsty", "so kind"
    const bool after_be = i > 0 && (text[i - 1] == "am" || text[i - 1] == "is" || text[i - 1] == "are");
    const bool joins = word == "so" && (!after_be || (i + 1 < text.size() && text[i + 1] == "kind"));
    if (!one_of(word, kDropped) || joins || text.size() == 1) kept.push_back(word);
  }
  text = std::move(kept);
}

// "the mug and the cups all need to go in the sink"
void drop_distributive(std::vector<std::string>& text, bool hears_people) {
  static constexpr std::array kBefore = {"need"sv,   "needs"sv, "belong"sv, "belongs"sv,
                                         "should"sv, "must"sv,  "ought"sv};
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if ((text[i] == "all" || text[i] == "both" || text[i] == "each") && text[i - 1] != "," &&
        text[i - 1] != "." && text[i - 1] != "and" &&
        (one_of(text[i + 1], kBefore) || (hears_people && text[i + 1] == "go")))
      text.erase(text.begin() + static_cast<long>(i));
}

// "we're wasting it" comes as "were": at the beginning of a clause nothing else fits.
void split_were(std::vector<std::string>& text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == "were" &&
        (i == 0 || text[i - 1] == "," || text[i - 1] == "." || text[i - 1] == "because" ||
         text[i - 1] == "and" || text[i - 1] == "since" || text[i - 1] == "so" || text[i - 1] == "but")) {
      text[i] = "we";
      text.insert(text.begin() + static_cast<long>(i) + 1, "are");
    }
}

// "burners 2 and 3" -> "burner 2 and burner 3"
void repeat_numbered(std::vector<std::string>& text, const Language& language) {
  const auto number = [&](std::size_t i) {
    return i < text.size() && number_word(text[i]) > 0 && number_word(text[i]) <= 6 &&
           !(i + 1 < text.size() && language.names_something(text[i + 1]));
  };
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    const std::string one = singular(text[i]);
    if (one == text[i] || !language.names_something(one) || !number(i + 1)) continue;
    std::size_t at = i + 2;
    for (; at + 1 < text.size() && (text[at] == "and" || text[at] == ",") && number(at + 1); at += 3)
      text.insert(text.begin() + static_cast<long>(at) + 1, one);
    if (at > i + 2) text[i] = one;
  }
}

// "it would make my day if you brought me a coke": only what comes behind matters.
void ask_politely(std::vector<std::string>& text, bool hears_people) {
  constexpr std::size_t kFarthest = 9;
  static constexpr std::array kCould = {"could"sv, "would"sv, "can"sv, "might"sv, "will"sv};
  // "I would be annoyed if the tap was on": that is what is not wanted
  static constexpr std::array kUnwished = {
      "shame"sv,   "pity"sv,      "waste"sv,        "disaster"sv, "nightmare"sv, "mistake"sv,
      "bad"sv,     "terrible"sv,  "horrible"sv,     "awful"sv,    "sad"sv,       "angry"sv,
      "annoyed"sv, "mad"sv,       "upset"sv,        "cross"sv,    "hate"sv,      "worse"sv,
      "furious"sv, "dangerous"sv, "disappointed"sv, "not"sv,      "worried"sv};
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    const bool opens = (text[i] == "it" || text[i] == "i" || text[i] == "that") &&
                       (text[i + 1] == "would" || text[i + 1] == "will" ||
                        (hears_people && text[i + 1] == "should" && text[i + 2] == "be"));
    // "would be nice if the fridge was open"
    const bool begins = i == 0 || text[i - 1] == "." || text[i - 1] == ",";
    const bool short_for = hears_people && begins && text[i] == "would" && text[i + 1] == "be";
    if (!opens && !short_for) continue;
    for (std::size_t k = i + 2; k + 1 < text.size() && k < i + kFarthest && text[k] != "," && text[k] != ".";
         ++k) {
      if (hears_people && one_of(text[k], kUnwished)) break;
      if (text[k] != "if") continue;
      if (text[k + 1] != "you" && text[k + 1] != "someone" && text[k + 1] != "somebody") {
        if (!hears_people || text[k + 1] == "i" || text[k + 1] == "we") continue;
        text[i] = "ensure";  // "I would feel better if the bowl was on the counter"
        text.erase(text.begin() + static_cast<long>(i) + 1, text.begin() + static_cast<long>(k) + 1);
        break;
      }
      k += 2;
      while (k < text.size() && one_of(text[k], kCould)) ++k;
      text[i] = "please";
      text.erase(text.begin() + static_cast<long>(i) + 1, text.begin() + static_cast<long>(k));
      break;
    }
  }
}

// "I was wondering whether the salt could go back": a request by its "could"; "I wonder if the tv is on"
// asks.
void drop_wondering(std::vector<std::string>& text) {
  static constexpr std::array kWonder = {"wonder"sv, "wondering"sv, "wondered"sv, "hoping"sv, "thinking"sv};
  static constexpr std::array kModals = {"could"sv, "can"sv, "might"sv, "may"sv, "should"sv};
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    if (text[i] != "i" && text[i] != "we") continue;
    std::size_t k = i + 1;
    if (text[k] == "was" || text[k] == "am" || text[k] == "were" || text[k] == "are") ++k;
    if (k + 2 >= text.size() || !one_of(text[k], kWonder)) continue;
    if (text[k + 1] == "if" || text[k + 1] == "whether" || text[k + 1] == "that") ++k;
    if (!one_of(text[k + 1], word_group::kArticles)) continue;
    bool modal = false;
    for (std::size_t m = k + 1; m < text.size() && text[m] != "." && text[m] != ","; ++m)
      modal = modal || one_of(text[m], kModals);
    if (modal) text.erase(text.begin() + static_cast<long>(i), text.begin() + static_cast<long>(k) + 1);
  }
}

// "might I prevail upon you to bring me the beer": what is asked begins behind "you to".
void drop_preambles(std::vector<std::string>& text, const Language& language) {
  constexpr std::size_t kFarthest = 12;
  static constexpr std::array kOpens = {"i"sv,   "we"sv,    "may"sv,  "might"sv,  "could"sv,
                                        "can"sv, "would"sv, "dare"sv, "should"sv, "it"sv};
  static constexpr std::array kTurnsAway = {
      "not"sv, "never"sv, "no"sv,      "without"sv, "forbid"sv, "hate"sv, "stop"sv, "refuse"sv, "warned"sv,
      "saw"sv, "heard"sv, "thought"sv, "used"sv,    "who"sv,    "why"sv,  "if"sv,   "dont"sv};
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    if ((i > 0 && text[i - 1] != "." && text[i - 1] != ",") || !one_of(text[i], kOpens)) continue;
    for (std::size_t k = i + 1; k + 2 < text.size() && k < i + kFarthest && text[k] != "," && text[k] != ".";
         ++k) {
      if (one_of(text[k], kTurnsAway) || language.names_thing(text[k])) break;
      if (text[k] != "you" || text[k + 1] != "to" || language.verb(text[k + 2]) == Frame::kNone) continue;
      text[i] = "please";
      text.erase(text.begin() + static_cast<long>(i) + 1, text.begin() + static_cast<long>(k) + 2);
      break;
    }
  }
}

// "be a good lad and get the spoon", "be an angel and ...".
void be_so_good(std::vector<std::string>& text) {
  constexpr std::size_t kFarthest = 6;
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    if (text[i] != "be" || (text[i + 1] != "a" && text[i + 1] != "an" && text[i + 1] != "the")) continue;
    for (std::size_t k = i + 2; k < text.size() && k < i + kFarthest && text[k] != "," && text[k] != "."; ++k)
      if (text[k] == "and") {
        text[i] = "please";
        text.erase(text.begin() + static_cast<long>(i) + 1, text.begin() + static_cast<long>(k) + 1);
        break;
      }
  }
}

// "something to stir my coffee with" is a spoon.
void name_tools(std::vector<std::string>& text) {
  constexpr std::size_t kFarthest = 10;
  static constexpr std::array<std::array<std::string_view, 2>, 7> kTools = {{{"stir", "spoon"},
                                                                             {"mix", "spoon"},
                                                                             {"scoop", "spoon"},
                                                                             {"eat", "fork"},
                                                                             {"drink", "glass"},
                                                                             {"rest", "pillow"},
                                                                             {"lean", "pillow"}}};
  for (std::size_t i = 0; i + 3 < text.size(); ++i) {
    if ((text[i] != "something" && text[i] != "anything") || text[i + 1] != "to") continue;
    const auto tool =
        std::find_if(kTools.begin(), kTools.end(), [&](const auto& t) { return t[0] == text[i + 2]; });
    if (tool == kTools.end()) continue;
    bool soft_food = false;
    for (std::size_t k = i + 3; k < text.size() && k < i + kFarthest && text[k] != "," && text[k] != ".";
         ++k) {
      soft_food = soft_food || text[k] == "cream" || text[k] == "icecream" || text[k] == "soup";
      if (text[k] != "with" && text[k] != "from" && text[k] != "of" && text[k] != "on" &&
          text[k] != "against")
        continue;
      if (text[k] == "with" && k + 1 < text.size() && text[k + 1] != "." && text[k + 1] != ",") continue;
      text[i] = "a", text[i + 1] = soft_food && tool->at(0) == "eat" ? "spoon" : std::string(tool->at(1));
      text.erase(text.begin() + static_cast<long>(i) + 2, text.begin() + static_cast<long>(k) + 1);
      break;
    }
  }
}

}  // namespace

void say_plainly(std::vector<std::string>& text, const Language& language) {
  split_were(text);
  drop_intensifiers(text);
  drop_distributive(text, language.hears_people());
  speak_for_others(text, language);
  repeat_numbered(text, language);
  ask_politely(text, language.hears_people());
  if (language.hears_people()) drop_wondering(text);
  if (language.hears_people()) drop_preambles(text, language);
  be_so_good(text);
  name_tools(text);
}

// "you know what I would like? An egg.": the thing comes in a sentence of its own.
void join_wishes(std::vector<std::string>& text) {
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    if (text[i] == "wish" && text[i + 1] == ".") text.erase(text.begin() + static_cast<long>(i) + 1);
  if (!text.empty() && text.front() == ".") text.erase(text.begin());
  if (!text.empty() && text.back() == ".") text.pop_back();
}

}  // namespace goalnet::inference
