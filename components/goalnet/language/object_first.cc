// Things and places before the verb: "in the sink the bowl you must put", "the chips I would like".
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

// Things and places one behind the other.
struct Fronted {
  Sentence things, places;
  std::size_t end = 0;
};

Fronted fronted(const Sentence& words, const WordSpans& spans, std::size_t at) {
  Fronted front;
  std::size_t i = at;
  for (;;) {
    const std::size_t place =
        spans.is(i, "with") && spans.thing(i + 1) != i + 1 ? spans.thing(i + 1) : spans.place(i);
    const std::size_t done = place != i ? place : front.things.empty() ? spans.things(i) : i;
    if (done == i) break;
    Sentence& to = place != i ? front.places : front.things;
    to.insert(to.end(), words.begin() + static_cast<long>(i), words.begin() + static_cast<long>(done));
    i = done;
  }
  front.end = i;
  return front;
}

// Behind "you (must)" and "please to": what stands between the things and their verb.
std::size_t you_must(const WordSpans& spans, std::size_t at) {
  const std::size_t to = spans.phrase(at, {"please to"});
  if (to != at) return to;
  return spans.phrase(at, {"you", "you must", "you should", "you can", "you could", "you may", "you will",
                           "you have to", "you need to", "please you", "you please", "can you", "could you"});
}

// "on burner three the kettle must stand", "into the bin it goes": the place is [at, place).
bool put_where_it_must_be(Sentence& words, const WordSpans& spans, std::size_t at, std::size_t place) {
  const std::size_t subject = spans.is_one(place, {"it", "they", "that"}) ? place + 1 : spans.things(place);
  const std::size_t must =
      spans.phrase(subject, {"must", "must go", "must stand", "must be", "must lie", "must come", "has to go",
                             "have to go", "has to be", "has to stand", "should go", "should stand",
                             "should be", "goes", "go", "belongs", "belong", "shall go"});
  if (subject == place || must == subject || !spans.ends(spans.skip_small(must))) return false;
  Sentence said = cut(words, place, subject);
  if (said.front() == "they") said.front() = "them";
  said.insert(said.begin(), "put");
  const Sentence where = cut(words, at, place);
  said.insert(said.end(), where.begin(), where.end());
  replace(words, at, must, said);
  return true;
}

}  // namespace

void verbs_first(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 2 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) && words[begin - 1] != "and" && words[begin - 1] != "then") continue;
    const std::size_t at = spans.skip_small(begin);
    Fronted front = fronted(words, spans, at);
    const std::size_t verb = you_must(spans, front.end);
    if (front.end == at || verb == front.end || verb >= words.size() ||
        language.verb(words[verb]) == Frame::kNone || language.verb_base(words[verb]) != words[verb] ||
        words[verb] == "have" || words[verb] == "get")
      continue;
    std::size_t end = verb + 1;  // "turn on"
    while (end < words.size() && one_of(words[end], kParticles) && spans.place(end) == end) ++end;
    Sentence order = cut(words, verb, end);
    if (const std::size_t burns = spans.phrase(verb, {"make it burn", "make it light", "make it go",
                                                      "make it work", "make it hot", "make it run"});
        burns != verb)
      order = {"turn", "on"}, end = burns;
    while (spans.is_one(end, {"me", "us"})) order.push_back(words[end++]);
    while (spans.is_one(end, {"it", "them"})) ++end;  // the same again
    if (spans.thing(end) != end) continue;            // "on the shelf you find the book"
    if (front.things.empty()) {
      if (begin == 0) continue;
      front.things = {"it"};
    }
    order.insert(order.end(), front.things.begin(), front.things.end());
    order.insert(order.end(), front.places.begin(), front.places.end());
    replace(words, at, end, order);
  }
  // "please to bring me the book"
  for (std::size_t i = 0; i + 2 < words.size(); ++i)
    if (words[i] == "please" && words[i + 1] == "to" && language.verb(words[i + 2]) != Frame::kNone)
      replace(words, i + 1, i + 2, {});
}

// "in the bin the chips" -> "the chips in the bin"; "on the counter I want it" -> "i want it on the counter"
void places_last(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 3 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) && words[begin - 1] != "and") continue;
    const std::size_t at = spans.skip_small(begin);
    std::size_t place = spans.place(at);
    if (place == at || spans.ends(place)) continue;
    if (words[place] == "please") words.erase(words.begin() + static_cast<long>(place));
    if (spans.ends(place)) continue;
    const std::size_t wish = spans.phrase(place, {"i want", "i need", "i would like", "we want"});
    std::size_t thing = wish;
    if (put_where_it_must_be(words, spans, at, place)) continue;
    if (wish == place &&
        (!(one_of(words[place], kArticles) || spans.is_one(place, {"all", "both"})) || words[at] == "at"))
      continue;
    thing = spans.is_one(wish, {"it", "them", "that"}) ? wish + 1 : spans.things(wish);
    const std::size_t end = spans.place(thing);
    if (thing == wish || !spans.ends(spans.skip_small(end)) || (end != thing && words[at] != "from"))
      continue;
    Sentence said = cut(words, place, thing);
    if (wish == place && words[at] == "from" && end == thing) continue;
    if (wish == place) said.insert(said.begin(), "put");
    const Sentence first = cut(words, at, place), second = cut(words, thing, end);
    said.insert(said.end(), first.begin(), first.end());
    said.insert(said.end(), second.begin(), second.end());
    replace(words, at, end, said);
  }
}

// "the chips I would like", "the fork, that one I need"
void wished_things_last(Sentence& words, const Language& language) {
  for (std::size_t begin = 0; begin + 2 < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin)) continue;
    const std::size_t at = spans.skip_small(begin);
    const Fronted front = fronted(words, spans, at);
    if (front.things.empty()) continue;
    std::size_t i = spans.phrase(front.end, {","});
    const bool again = i != front.end;
    i = spans.phrase(i,
                     {"that one", "that", "those", "those ones", "it", "them", "this", "this one", "these"});
    const bool named_again = !again || i != front.end + 1;
    const std::size_t wish =
        spans.phrase(i, {"i would like", "i want", "i need", "we want", "we need", "i would like to have",
                         "i want to have", "we would like", "i would love", "i would love to have",
                         "i like to have", "i should like", "i could use", "i would like to read",
                         "i want to read", "i would like to drink", "i would like to eat"});
    if (wish == i || (!named_again && spans.place(wish) == wish)) continue;
    std::size_t end = wish;
    Sentence places = front.places;
    if (const std::size_t place = spans.place(end); place != end) {  // "I want on the couch"
      places.insert(places.end(), words.begin() + static_cast<long>(end),
                    words.begin() + static_cast<long>(place));
      end = place;
    }
    if (!spans.ends(spans.skip_small(end))) continue;
    Sentence said = {"i", "want"};
    said.insert(said.end(), front.things.begin(), front.things.end());
    said.insert(said.end(), places.begin(), places.end());
    replace(words, at, end, said);
  }
}

}  // namespace goalnet::inference
