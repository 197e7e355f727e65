// What is told in another order than usual: "is too loud the tv", "all she drinks is coke", "the coffee has
// to go down the drain", "is the tv on? it shouldn't be".
#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

void uncleave(Sentence& words, const Language& language) {
  for (std::size_t at = 2; at + 4 < words.size(); ++at) {  // "a coke, that's what I need"
    const WordSpans spans(words, language);
    if (words[at - 1] != ",") continue;
    const std::size_t wish =
        spans.phrase(at, {"that is what i want", "that is what i need", "that is what i would like",
                          "that is all i need", "that is all i want", "this is what i want",
                          "that is what we need", "that is what i really want"});
    const std::size_t begin = spans.skip_small(spans.part_begin(at - 2));
    if (wish == at || !spans.ends(wish) || spans.thing(begin) == begin) continue;
    if (const std::size_t done = spans.place(spans.thing(begin)); done != at - 1) continue;
    replace(words, at - 1, wish, {});
    words.insert(words.begin() + static_cast<long>(begin), {"i", "want"});
  }
  for (std::size_t begin = 0; begin + 4 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) && words[begin - 1] != "and" && words[begin - 1] != "so") continue;
    const std::size_t who = spans.phrase(begin, {"all", "all that", "the only thing", "the only things",
                                                 "the one thing", "the only thing that"});
    if (who == begin || !spans.is_one(who, {"i", "he", "she", "we", "they", "you"})) continue;
    std::size_t is = who + 1;
    while (is < words.size() && is < who + 4 && !spans.is_one(is, {"is", "are", "was"}) && !spans.ends(is))
      ++is;
    if (is == who + 1 || !spans.is_one(is, {"is", "are", "was"}) || spans.thing(is + 1) == is + 1 ||
        (spans.is(is + 1, "that") && is + 2 < words.size() && one_of(words[is + 2], kArticles)))
      continue;  // "all I am asking is that the chips ..."
    replace(words, is, is + 1, {});
    replace(words, begin, who, {});
  }
}

void let_it_go(Sentence& words, const Language& language) {
  for (std::size_t at = 2; at + 2 < words.size(); ++at) {  // "there is still coffee in the mug, away with it"
    const WordSpans spans(words, language);
    const std::size_t away =
        spans.phrase(at, {"away with it", "away with that", "out with it", "out with that"});
    if (away == at || !spans.ends(away) || words[at - 1] != ",") continue;
    bool content = false;
    for (std::size_t i = spans.part_begin(at - 2); i + 1 < at; ++i)
      content = content || language.content(words[i]) == symbol::kCoffee ||
                language.content(words[i]) == symbol::kWater;
    if (content) replace(words, at, away, {"pour", "it", "away"});
  }
  for (std::size_t go = 2; go < words.size(); ++go) {
    const WordSpans spans(words, language);
    if (words[go] != "go") continue;
    const std::size_t drain =
        spans.phrase(go + 1, {"down the drain", "down the sink", "in the drain", "down the plughole"});
    std::size_t has = go;
    while (has > 0 && spans.is_one(has - 1, {"has", "have", "needs", "need", "must", "should", "to", "can",
                                             "really", "just", "ought"}))
      --has;
    if (has == go || !spans.ends(spans.skip_small(std::max(drain, go + 1)))) continue;
    std::size_t begin = spans.part_begin(go);
    while (begin < has && (spans.thing(begin) == begin || spans.place(spans.thing(begin)) != has)) ++begin;
    if (begin >= has ||
        !(one_of(words[begin], kArticles) || one_of(words[begin], kPointers) || spans.name(begin) > 0))
      continue;
    const std::size_t thing = spans.thing(begin);
    const Symbol content = language.content(words[thing - 1]);
    if (content != symbol::kWater && content != symbol::kCoffee && drain == go + 1) continue;
    if (content == symbol::kNone) continue;
    Sentence order = {"empty"};  // "the water in the glass": the glass
    const bool in_vessel = thing < has && language.holds_things(words[has - 1]);
    const Sentence what = in_vessel ? cut(words, thing + 1, has) : cut(words, begin, thing);
    order.insert(order.end(), what.begin(), what.end());
    if (begin > 0 && words[begin - 1] == "so") order.insert(order.begin(), ",");
    replace(words, begin, std::max(drain, go + 1), order);
  }
}

// "is the tv on? it shouldn't be" -> "the tv should not be on"
void answer_what_should_be(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 5 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) || !spans.is_one(begin, {"is", "are"})) continue;
    const std::size_t thing = spans.thing(begin + 1);
    const std::size_t state = spans.phrase(thing, {"still", "really", "already"});
    if (thing == begin + 1 || state + 2 >= words.size() || !spans.ends(state + 1) ||
        language.wanted_by_state(words[state]) == Frame::kNone)
      continue;
    const std::size_t it = spans.phrase(state + 2, {"it", "they", "that"});
    const std::size_t should = spans.phrase(it, {"should be", "must be", "ought to be"});
    const std::size_t should_not =
        spans.phrase(it, {"should not be", "shouldnt be", "must not be", "mustnt be", "should not"});
    const std::size_t end = std::max(should, should_not);
    if (it == state + 2 || end == it || !spans.ends(end)) continue;
    Sentence said = cut(words, begin + 1, thing);
    said.insert(said.end(), {"should", "be", words[state]});
    if (should_not != it) said.insert(said.end() - 2, "not");
    replace(words, begin, end, said);
  }
}

// "is too loud the television" -> "the television is too loud"
void subjects_first(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 3 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) || !spans.is_one(begin, {"is", "are"})) continue;
    std::size_t state = begin + 1;
    while (spans.is_one(state, {"too", "so", "very", "much", "really", "all", "still", "already"})) ++state;
    if (state >= words.size() || (language.complaint(words[state]) == Frame::kNone &&
                                  language.wanted_by_state(words[state]) == Frame::kNone))
      continue;
    const std::size_t subject = state + 1;
    if (subject >= words.size() || !one_of(words[subject], kArticles)) continue;
    const std::size_t done = spans.thing(subject), end = spans.place(done);
    if (done == subject || !spans.ends(end)) continue;
    Sentence said = cut(words, subject, end);
    Sentence told = cut(words, begin, state + 1);
    std::erase(told, "much");
    said.insert(said.end(), told.begin(), told.end());
    replace(words, begin, end, said);
  }
}

}  // namespace goalnet::inference
