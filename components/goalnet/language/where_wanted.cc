// "the bowl, that's where I want the egg", "the sink is where the plates belong"; "somewhere else, the
// counter is fine".
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

struct Wanted {
  std::size_t thing = 0, thing_end = 0, end = 0;  // `end` 0: none
};

// "where I want the egg", "where the plates belong" at `at`.
Wanted wanted(const WordSpans& spans, std::size_t at) {
  if (!spans.is(at, "where")) return {};
  const std::size_t wish =
      spans.phrase(at + 1, {"i want", "we want", "i need", "we need", "i wanted", "i would like",
                            "we would like", "i like", "i keep", "we keep", "i would like to have",
                            "i want to have", "you should put", "you can put", "you put", "i would put"});
  if (wish != at + 1) {
    const std::size_t done = spans.things(wish);
    return done == wish ? Wanted{} : Wanted{wish, done, done};
  }
  const std::size_t done = spans.things(at + 1);
  const std::size_t belongs = spans.phrase(done, {"belongs",
                                                  "belong",
                                                  "goes",
                                                  "go",
                                                  "should be",
                                                  "should go",
                                                  "must go",
                                                  "must be",
                                                  "lives",
                                                  "live",
                                                  "is supposed to be",
                                                  "is supposed to go",
                                                  "are supposed to be",
                                                  "ought to be",
                                                  "needs to be",
                                                  "need to be",
                                                  "needs to go",
                                                  "need to go",
                                                  "has to be",
                                                  "has to go",
                                                  "have to be",
                                                  "have to go",
                                                  "should stand",
                                                  "stands"});
  return done == at + 1 || belongs == done ? Wanted{} : Wanted{at + 1, done, belongs};
}

Sentence put(const Sentence& words, const Wanted& what, std::size_t place, std::size_t place_end) {
  Sentence order = {"put"};
  order.insert(order.end(), words.begin() + static_cast<long>(what.thing),
               words.begin() + static_cast<long>(what.thing_end));
  if (!place_preposition(words[place])) order.emplace_back("to");
  order.insert(order.end(), words.begin() + static_cast<long>(place),
               words.begin() + static_cast<long>(place_end));
  return order;
}

// "take the bowl off the couch, (the coffee table is fine)": whether at the pause nothing tells where to.
bool taken_from_somewhere(const WordSpans& spans, std::size_t pause) {
  if (!spans.is(pause, ",") || pause == 0) return false;
  const std::size_t begin = spans.part_begin(pause - 1);
  bool off = false;
  for (std::size_t k = begin; k < pause; ++k) off = off || spans.is_one(k, {"off", "from"});
  return off && spans.orders(begin, pause);
}

// "somewhere else (,) the counter is fine" -> "to the counter"
bool suggested(Sentence& words, const Language& language, std::size_t at) {
  const WordSpans spans(words, language);
  std::size_t some = spans.phrase(at, {"somewhere else", "someplace else", "somewhere", "someplace",
                                       "anywhere else", "elsewhere", "away"});
  const bool only_taken = some == at && taken_from_somewhere(spans, at);
  if (only_taken) some = at + 1;
  if (some == at) return false;
  std::size_t next = spans.ends(some) ? some + 1 : some;
  next = spans.phrase(next, {"maybe", "perhaps", "say", "anywhere", "i think", "so"});
  const std::size_t place = spans.somewhere(next);
  const std::size_t fine = spans.phrase(
      place, {"is fine", "is ok", "is okay", "is good", "is great", "is best", "is perfect", "is free",
              "is alright", "would be fine", "would be ok", "would be good", "would be great",
              "would be best", "would do", "will do", "works", "will be fine"});
  if (place == next || fine == place || !spans.ends(fine)) return false;
  Sentence to = cut(words, next, place);
  if (!place_preposition(to.front())) to.insert(to.begin(), "to");
  if (only_taken) to.insert(to.begin(), {",", "put", "it"});
  replace(words, at, fine, to);
  return true;
}

// "where the plate is, there put the bowl" -> "put the bowl where the plate is"
void where_that_stands(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 5 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at) || words[at] != "where") continue;
    const std::size_t thing = spans.thing(at + 1);
    const std::size_t is = spans.phrase(thing, {"is", "are", "stands", "is standing", "lies", "is lying"});
    if (thing == at + 1 || is == thing || !spans.is(is, ",")) continue;
    const std::size_t verb = spans.phrase(is + 1, {"there", "please", "there please", "that is where"});
    if (!spans.order(verb)) continue;
    const Sentence where = cut(words, at, is);
    const std::size_t end = spans.part_end(verb);
    Sentence order = cut(words, verb, end);
    std::erase(order, "also");
    std::erase(order, "there");
    order.insert(order.end(), where.begin(), where.end());
    replace(words, at, end, order);
  }
}

}  // namespace

void put_where_wanted(Sentence& words, const Language& language) {
  where_that_stands(words, language);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (suggested(words, language, i)) continue;
    const WordSpans spans(words, language);
    const Wanted what = wanted(spans, i);
    if (what.end == 0) continue;
    if (const std::size_t is = spans.phrase(what.end, {"is", "are"});
        is != what.end) {  // "where I want it is ..."
      const std::size_t done = spans.somewhere(is);
      if (spans.begins(i) && done != is && spans.ends(done))
        replace(words, i, done, put(words, what, is, done));
      continue;
    }
    // "PLACE(, that) is where ..."
    if (i < 2 || words[i - 1] != "is" || !spans.ends(what.end)) continue;
    std::size_t place_end = i - 1;
    if (spans.is_one(place_end - 1, {"that", "this", "it", "there"}) && place_end > 1 &&
        spans.ends(place_end - 2))
      place_end -= 2;
    const std::size_t begin = spans.part_begin(place_end - 1), place = spans.skip_small(begin);
    if (spans.somewhere(place) != place_end) continue;
    const Sentence order = put(words, what, place, place_end);
    replace(words, place, what.end, order);
    i = place + order.size();
  }
}

}  // namespace goalnet::inference
