// Things and places before the verb: "in the sink the bowl you must put", "the chips I would like"; what is
// told of before its subject: "is too loud the tv".
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
    // "on burner three the kettle must stand", "into the bin it goes"
    const std::size_t subject = spans.is_one(place, {"it", "they", "that"}) ? place + 1 : spans.things(place);
    const std::size_t must =
        spans.phrase(subject, {"must", "must go", "must stand", "must be", "must lie", "must come",
                               "has to go", "have to go", "has to be", "has to stand", "should go",
                               "should stand", "should be", "goes", "go", "belongs", "belong", "shall go"});
    if (subject != place && must != subject && spans.ends(spans.skip_small(must))) {
      Sentence said = cut(words, place, subject);
      if (said.front() == "they") said.front() = "them";
      said.insert(said.begin(), "put");
      const Sentence where = cut(words, at, place);
      said.insert(said.end(), where.begin(), where.end());
      replace(words, at, must, said);
      continue;
    }
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
