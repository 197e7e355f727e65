// What somebody complains of without asking: what was left undone, cannot be heard, is out of reach, is
// missing.
#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// Behind "somebody", "my son", "the kids": who may have left something undone; `at` where it is nobody.
std::size_t somebody(const Sentence& words, const Language& language, std::size_t at) {
  static constexpr std::array kWho = {"i"sv,        "you"sv,     "he"sv,  "she"sv,  "they"sv,  "we"sv,
                                      "somebody"sv, "someone"sv, "who"sv, "guys"sv, "idiot"sv, "whoever"sv};
  std::size_t i = at;
  while (i < words.size() &&
         (one_of(words[i], kArticles) || one_of(words[i], kPointers) || words[i] == "some"))
    ++i;
  if (i >= words.size()) return at;
  return one_of(words[i], kWho) || language.person(words[i]) || language.person(singular(words[i])) ? i + 1
                                                                                                    : at;
}

// Whether what the verb at `at` does is missed where it was not done: "shut", "turn ... off", "put ... away".
bool leaves_undone(const Sentence& words, const WordSpans& spans, const Language& language, std::size_t at) {
  const Frame frame = at < words.size() ? language.verb(words[at]) : Frame::kNone;
  if (frame == Frame::kClose || frame == Frame::kStop || frame == Frame::kEmpty || frame == Frame::kWash)
    return true;
  if (frame != Frame::kTurn && frame != Frame::kPlace && frame != Frame::kTake) return false;
  for (std::size_t i = at + 1; !spans.ends(i); ++i)
    if (words[i] == (frame == Frame::kTurn ? "off" : "away") ||
        (frame == Frame::kPlace && words[i] == "back"))
      return true;
  return false;
}

}  // namespace

void say_what_was_left_undone(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 3 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) && !spans.is_one(begin - 1, {"and", "because", "so", "but"})) continue;
    std::size_t i =
        spans.phrase(begin, {"i do not think", "i dont think", "i do not believe", "i dont believe"});
    const bool doubts = i != begin;
    i = spans.phrase(i, {"that"});
    const std::size_t who = somebody(words, language, i);
    if (who == i) continue;
    std::size_t verb =
        spans.phrase(who, {"did not", "didnt", "does not", "doesnt", "do not", "dont", "has not", "hasnt",
                           "have not", "havent", "never", "did not even", "didnt even"});
    if (verb == who && !doubts) continue;
    verb = spans.phrase(verb, {"even", "ever", "properly", "bother to", "think to"});
    if (!leaves_undone(words, spans, language, verb) ||
        (words[who - 1] == "i" && !doubts && words[who] == "do"))
      continue;
    const std::string base = language.verb_base(words[verb]);
    replace(words, begin, verb + 1, {"you", "forgot", "to", base});
  }
}

// "I can't hear a single word they're saying on the tv"
void say_what_is_not_heard(Sentence& words, const Language& language) {
  static constexpr std::array kTold = {
      "a"sv,          "one"sv,      "any"sv,   "single"sv, "word"sv,  "words"sv,  "thing"sv,   "sound"sv,
      "of"sv,         "they"sv,     "he"sv,    "she"sv,    "it"sv,    "are"sv,    "is"sv,      "what"sv,
      "that"sv,       "saying"sv,   "say"sv,   "says"sv,   "on"sv,    "the"sv,    "this"sv,    "tv"sv,
      "telly"sv,      "man"sv,      "woman"sv, "film"sv,   "movie"sv, "show"sv,   "news"sv,    "match"sv,
      "television"sv, "anything"sv, "at"sv,    "all"sv,    "from"sv,  "here"sv,   "over"sv,    "there"sv,
      "talking"sv,    "about"sv,    "being"sv, "said"sv,   "guy"sv,   "people"sv, "program"sv, "programme"sv,
      "in"sv,         "game"sv};
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    if (!spans.begins(i) && !spans.is_one(i - 1, {"and", "but", "because"})) continue;
    std::size_t k = spans.phrase(
        i, {"i", "we", "you", "nobody", "no one", "nobody here", "nobody back here", "nobody over here"});
    if (k == i) k = somebody(words, language, i);  // "my wife", "grandpa"
    k = spans.phrase(k, {"really", "just", "still"});
    const bool nobody = spans.is_one(i, {"nobody", "no"});
    std::size_t verb = spans.phrase(k, {"cant", "can not", "cannot", "can hardly", "can barely",
                                        "can scarcely", "could not", "couldnt", "cant even", "can not even"});
    if (nobody) verb = spans.phrase(k, {"can", "could"});
    const std::size_t done = spans.phrase(verb, {"hear", "make out", "understand", "follow", "catch"});
    if (verb == k || done == verb || spans.ends(done)) continue;
    const std::size_t end = spans.part_end(done);
    bool told = true;
    for (std::size_t w = done; w < end; ++w) told = told && one_of(words[w], kTold);
    if (told && end > done + 1) replace(words, i, end, {"raise", "the", "volume"});
  }
}

// "the microwave door is open and I keep bumping my head on it": somebody shall see to it
void mend_what_annoys(Sentence& words, const Language& language) {
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    if (!spans.is_one(i, {"and", ","})) continue;
    const std::size_t who = spans.is(i + 1, "and") ? i + 2 : i + 1;
    const std::size_t keep =
        std::max(somebody(words, language, who), spans.phrase(who, {"everyone", "everybody"}));
    const std::size_t doing = spans.phrase(keep, {"keep", "keeps", "kept"});
    if (keep == who || doing == keep || spans.ends(doing) || !words[doing].ends_with("ing")) continue;
    const std::size_t begin = spans.part_begin(i - 1), thing = spans.thing(spans.skip_small(begin));
    const bool state = thing < i && spans.is_one(thing, {"is", "are"}) &&
                       std::any_of(words.begin() + static_cast<long>(thing),
                                   words.begin() + static_cast<long>(i), [&](const std::string& word) {
                                     return language.wanted_by_state(word) != Frame::kNone ||
                                            language.complaint(word) != Frame::kNone;
                                   });
    if (!state || spans.part_end(doing) + 1 < words.size()) continue;
    replace(words, i, spans.part_end(doing), {",", "see", "to", "it"});
  }
}

// "I'd love to see the weather, ..., and the tv isn't even on"
void turn_on_what_is_to_be_seen(Sentence& words, const Language& language) {
  const auto sees = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word == "see" || word == "watch" || word == "watching" || word == "seeing";
  });
  if (sees == words.end()) return;
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    const std::size_t tv = spans.phrase(i, {"the tv", "the telly", "the television", "my tv"});
    const std::size_t off =
        spans.phrase(tv, {"is not on", "isnt on", "is not even on", "isnt even on", "is not on yet",
                          "isnt on yet", "is still off", "is off", "is not running"});
    if (tv == i || off == tv || !spans.ends(off)) continue;
    const bool joined = spans.is_one(i - 1, {"and", "but"});
    const bool pause = spans.ends(i - (joined ? 2 : 1));
    Sentence order = {"turn", "on", "the", "tv"};
    if (!pause) order.insert(order.begin(), ",");
    replace(words, joined ? i - 1 : i, off, order);
  }
}

// "I can't get up and the remote is way over there on the shelf, so, pretty please?"
void wish_what_is_far(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  std::size_t end = words.size();
  bool asked = false;
  while (end > 0 && (spans.ends(end - 1) || spans.is_one(end - 1, {"please", "pretty", "so", "pleeease",
                                                                   "then", "would", "you", "mind"}))) {
    asked = asked || words[end - 1] == "please" || words[end - 1] == "mind";
    --end;
  }
  if (!asked || end == 0 || end == words.size() || spans.orders(0, end)) return;
  const std::size_t begin = spans.part_begin(end - 1);
  for (std::size_t i = begin; i + 3 < end; ++i) {
    if (i > begin && words[i - 1] != "and" && words[i - 1] != "but") continue;
    const std::size_t first = spans.skip_small(i), done = spans.things(first);
    if (done == first || !one_of(words[first], kArticles) ||
        !spans.is_one(done, {"is", "are", "stands", "lies"}))
      continue;
    std::size_t place = done + 1;
    while (place < end &&
           spans.is_one(place, {"all", "the", "way", "still", "over", "up", "there", "right", "far", "on"}) &&
           spans.place(place) == place)
      ++place;
    if (spans.place(place) != end) continue;
    replace(words, done, place, {});
    words.insert(words.begin() + static_cast<long>(first), "wish");
    return;
  }
}

// "there is no fork on my plate , do_that"
void supply_what_lacks(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  const auto asked = std::find_if(words.begin(), words.end(), [&](const std::string& word) {
    const std::size_t at = static_cast<std::size_t>(&word - words.data());
    const std::size_t in =
        spans.phrase(at, {"put it in", "put it on", "put it there", "put some in", "add it", "add some",
                          "put one in", "put one on", "put one there"});
    return word == "do_that" || (in != at && at > 0 && spans.ends(at - 1) && spans.ends(in));
  });
  if (asked == words.end()) return;
  for (std::size_t i = 0; i + 3 < words.size(); ++i) {
    const std::size_t no = spans.phrase(
        i, {"there is no", "there are no", "there is not a", "there is not any", "there are not any",
            "there isnt a", "there isnt any", "there is not one", "there is not a single"});
    if (no == i || (i > 0 && !spans.ends(i - 1) && spans.is_one(i - 1, {"if", "case", "when", "that"})))
      continue;
    const std::size_t thing = spans.thing(no), place = spans.place(thing);
    if (thing == no || place == thing || !spans.ends(place) ||
        (*asked == "do_that" &&
         (language.content(words[no]) == symbol::kWater || language.content(words[no]) == symbol::kCoffee)))
      continue;
    const std::size_t at = static_cast<std::size_t>(asked - words.begin());
    replace(words, at, *asked == "do_that" ? at + 1 : spans.part_end(at), {"please"});
    replace(words, i, no, {"put"});
    return;
  }
}

}  // namespace goalnet::inference
