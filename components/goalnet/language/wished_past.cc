// Wishes in the past tense: "it would be nice if the salt stood on the counter again", "I wish the tv was
// on".
#include <array>
#include <string>

#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::array kStood = {"stood"sv, "sat"sv, "lay"sv, "rested"sv, "lived"sv, "stayed"sv, "remained"sv};
constexpr std::array kWas = {"was"sv, "were"sv, "had"sv};
// Whatever comes, goes or gets somewhere shall be there in the end.
constexpr std::array kCame = {"come"sv, "comes"sv, "came"sv, "go"sv,  "goes"sv,
                              "went"sv, "get"sv,   "gets"sv, "got"sv, "lands"sv};
constexpr std::array kInto = {"in"sv, "into"sv, "on"sv, "onto"sv, "inside"sv};
constexpr std::array kAgain = {"again"sv, "already"sv, "finally"sv, "once"sv};

bool comes_there(const std::vector<std::string>& words, std::size_t i) {
  return one_of(words[i], kCame) && i + 1 < words.size() && one_of(words[i + 1], kInto);
}

// Where "before my sister starts talking" began that the word at `at` follows without a comma.
bool behind_subordinate(const std::vector<std::string>& words, std::size_t at) {
  static constexpr std::array kBegins = {"before"sv, "until"sv, "while"sv, "when"sv, "because"sv, "since"sv};
  std::size_t begin = at;
  while (begin > 0 && !ends_part(words, begin - 1)) --begin;
  return begin < at && one_of(words[begin], kBegins);
}

// "... on the loveseat with the chips": the chips on it tell which, nobody wishes them there.
void place_told_by(std::vector<std::string>& words, std::size_t from) {
  static constexpr std::array kOthers = {"other"sv, "others"sv, "rest"sv};
  constexpr std::size_t kLongestName = 2;
  std::size_t end = from;
  while (!ends_part(words, end)) ++end;
  for (std::size_t k = from; k + 3 < end; ++k) {
    if (words[k] != "on" || words[k + 1] != "the") continue;
    std::size_t with = k + 3;
    if (with + 2 < end && words[with] != "with") ++with;  // "the coffee table"
    const bool told = with + 2 < end && words[with] == "with" && words[with + 1] == "the" &&
                      end - with - 2 <= kLongestName && !one_of(words[with + 2], kOthers);
    if (!told) continue;
    const std::array<std::string, 2> on_it = {"on", "it"};
    words.insert(words.begin() + static_cast<long>(end), on_it.begin(), on_it.end());
    return;
  }
}

}  // namespace

void wished_past(std::vector<std::string>& words) {
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const bool wishes =
        (words[i] == "i" || words[i] == "we") && (words[i + 1] == "wish" || words[i + 1] == "wished");
    if (words[i] != "ensure" && !wishes) continue;
    std::size_t thing = i + 1 + (wishes ? 1 : 0);
    if (thing < words.size() && words[thing] == "that") ++thing;
    std::size_t verb = thing + 1;  // "I wish you had ..." is about what somebody did
    while (!ends_part(words, verb) && !one_of(words[verb], kStood) && !one_of(words[verb], kWas) &&
           !comes_there(words, verb))
      ++verb;
    const bool there = words[thing] == "there";
    if (ends_part(words, verb) || (one_of(words[thing], kSubjects) && !there) ||
        one_of(words[thing], kPersons))
      continue;
    // "once more", but not "once you are done"
    for (std::size_t k = thing; !ends_part(words, k);)
      if (one_of(words[k], kAgain) &&
          (words[k] != "once" || (!ends_part(words, k + 1) && words[k + 1] == "again")))
        words.erase(words.begin() + static_cast<long>(k));
      else
        ++k;
    for (verb = thing + 1; !ends_part(words, verb); ++verb)
      if (one_of(words[verb], kStood) || comes_there(words, verb))
        words[verb] = "is";
      else if (words[verb] == "had")
        words[verb] = "has";
      else if (words[verb] == "was" || words[verb] == "were")
        words[verb] = "is";
    if (there) place_told_by(words, thing);
    if (wishes) {
      words[i] = "ensure";
      words.erase(words.begin() + static_cast<long>(i) + 1, words.begin() + static_cast<long>(thing));
    }
    if (behind_subordinate(words, i)) words.insert(words.begin() + static_cast<long>(i), ",");
  }
}

// "wish the fork to be placed in the bowl and the spoon to be placed in the mug": two wishes
void repeat_the_wish(std::vector<std::string>& words, const Language& language) {
  bool wished = false;
  for (std::size_t i = 0; i + 3 < words.size(); ++i) {
    const WordSpans spans(words, language);
    if (words[i] == ".") wished = false;
    const bool joined = spans.is_one(i, {"and", ","}) && !spans.is_one(i + 1, {"and", "wish"});
    const bool asks = spans.is_one(i, {"wish", "want", "need", "like", "require"});
    const std::size_t thing = asks || joined ? i + 1 : i;
    const std::size_t named = thing == i ? i : spans.things(thing);
    if (named == thing || spans.phrase(named, {"to be"}) == named) continue;
    if (wished && joined) {
      const bool pause = spans.ends(i) || spans.ends(i - 1);
      words.insert(words.begin() + static_cast<long>(thing), "wish");
      if (!pause) words[i] = ",";
    }
    wished = true;
  }
}

}  // namespace goalnet::inference
