// Who wants something may speak through somebody else: "my wife needs the salt", "mum says to put the plates
// away".
#include <algorithm>
#include <array>
#include <string_view>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/ways_of_saying.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;
using Text = std::vector<std::string>;

constexpr std::array kWhose = {"my"sv, "our"sv, "the"sv, "your"sv, "his"sv, "her"sv, "their"sv, "a"sv};

void erase(Text& text, std::size_t from, std::size_t to) {
  text.erase(text.begin() + static_cast<long>(from), text.begin() + static_cast<long>(to));
}

// Where somebody's name at `i` begins: "my wife".
std::size_t begin_of(const Text& text, std::size_t i) {
  return i > 0 && one_of(text[i - 1], kWhose) ? i - 1 : i;
}

// "my son is asking for a fork" -> "my son wants a fork"
void asks_for(Text& text, std::size_t next) {
  static constexpr std::array kAsking = {"asking"sv,   "begging"sv, "calling"sv, "crying"sv,
                                         "shouting"sv, "looking"sv, "waiting"sv, "hoping"sv};
  if (next + 2 >= text.size() || (text[next] != "is" && text[next] != "are") ||
      !one_of(text[next + 1], kAsking) || text[next + 2] != "for")
    return;
  erase(text, next + 1, next + 3);
  text[next] = "wants";
}

// "mum says to put the plates in the sink", "dad wants you to open it" -> "please put ..."
bool says_to(Text& text, std::size_t i, std::size_t next, const Language& language) {
  static constexpr std::array kSays = {"said"sv,  "says"sv,  "told"sv,  "asks"sv,
                                       "asked"sv, "wants"sv, "wanted"sv};
  if (next + 2 >= text.size() || !one_of(text[next], kSays)) return false;
  std::size_t verb = next + 1;
  if (text[verb] == "you" || text[verb] == "me" || text[verb] == "us") ++verb;
  const bool says = text[next] == "said" || text[next] == "says";
  if (verb + 1 >= text.size() || text[verb] != "to" || language.verb(text[verb + 1]) == Frame::kNone ||
      !(says || text[verb - 1] == "you"))
    return false;
  const std::size_t begin = begin_of(text, i);
  erase(text, begin, verb + 1);
  text.insert(text.begin() + static_cast<long>(begin), "please");
  return true;
}

// "my wife says the plates belong in the sink": what they say counts
bool says_what_ought(Text& text, std::size_t i, std::size_t next) {
  static constexpr std::array kTells = {"says"sv,    "said"sv,    "thinks"sv,
                                        "reckons"sv, "insists"sv, "believes"sv};
  static constexpr std::array kOught = {"should"sv, "belong"sv, "belongs"sv, "must"sv, "go"sv,
                                        "goes"sv,   "needs"sv,  "need"sv,    "has"sv,  "ought"sv};
  if (next + 2 >= text.size() || !one_of(text[next], kTells)) return false;
  const std::size_t said = text[next + 1] == "that" ? next + 2 : next + 1;
  bool ought = false;
  for (std::size_t k = said; k < text.size() && text[k] != "." && text[k] != ","; ++k)
    ought = ought || one_of(text[k], kOught);
  if (!ought || !one_of(text[said], word_group::kArticles)) return false;
  erase(text, begin_of(text, i), said);
  return true;
}

// "my dear old wife needs the salt", "the kid is thirsty" -> "i need the salt", "i is thirsty"; where the "i"
// stands, `i` where nobody wants anything.
std::size_t wants(Text& text, std::size_t i, std::size_t next, const Language& language) {
  static constexpr std::array kWant = {"want"sv,     "wants"sv, "need"sv, "needs"sv, "would"sv,
                                       "requires"sv, "can"sv,   "cant"sv, "cannot"sv};
  static constexpr std::array kDear = {"little"sv, "old"sv, "dear"sv};
  std::size_t feels = next;
  while (feels < text.size() && (text[feels] == "is" || text[feels] == "are")) ++feels;
  const bool wishes = feels < text.size() && language.wish(text[feels]) != nullptr;
  if (next >= text.size() || !(one_of(text[next], kWant) || wishes)) return i;
  std::size_t from = i;
  while (from > 0 && i - from < 2 && (one_of(text[from - 1], kWhose) || one_of(text[from - 1], kDear)))
    --from;
  if (text[next].ends_with("s")) text[next].pop_back();
  text[from] = "i";
  erase(text, from + 1, next);
  return from;
}

}  // namespace

void speak_for_others(std::vector<std::string>& text, const Language& language) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!language.person(singular(text[i]))) continue;
    std::size_t next = i + 1;
    while (next < text.size() && (text[next] == "here" || text[next] == "also")) ++next;
    if (language.hears_people()) {
      asks_for(text, next);
      if (says_to(text, i, next, language) || says_what_ought(text, i, next)) continue;
    }
    i = wants(text, i, next, language);
  }
}

}  // namespace goalnet::inference
