// Notes step by step: "kettle, fill with water, then onto burner one, then fire on"; "coke, glass, pour it".
#include <algorithm>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// Whether the part [at, end) is one thing and nothing else.
bool thing_alone(const WordSpans& spans, std::size_t at, std::size_t end) {
  return at < end && spans.thing(at) == end;
}

// "kettle, water in, heat it" -> "kettle, fill with water, heat it"
void fill_in_steps(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  const std::size_t begin = spans.skip_small(0), end = spans.part_end(begin);
  if (!thing_alone(spans, begin, end) || end >= words.size() || words[end] != ",") return;
  const std::size_t what = spans.skip_small(end + 1), in = what + spans.name(what);
  const std::size_t done = spans.phrase(in, {"in", "inside", "in it", "into it"});
  std::string content;
  for (std::size_t i = what; i < in; ++i) content += (i > what ? " " : "") + words[i];
  if (done == in || !spans.ends(done) || language.content(content) == symbol::kNone) return;
  Sentence said = {"fill", "with"};
  const Sentence named = cut(words, what, in);
  said.insert(said.end(), named.begin(), named.end());
  replace(words, what, done, said);
}

}  // namespace

void spell_out_steps(Sentence& words, const Language& language) {
  fill_in_steps(words, language);
  const WordSpans spans(words, language);
  const std::size_t begin = spans.skip_small(0), end = spans.part_end(begin);
  if (end + 2 >= words.size() || words[end] != "," || !thing_alone(spans, begin, end) ||
      spans.name(begin) == 0)
    return;
  const std::size_t verb = spans.skip_small(end + 1), verb_end = spans.part_end(verb);
  if (!spans.order(verb) || spans.names(verb + 1, std::min(verb_end, verb + 2))) return;
  for (std::size_t i = verb + 1; i < verb_end; ++i)
    if (is_pronoun(words[i]) ||
        (spans.thing(i) != i && words[i - 1] != "with" && spans.place(i - 1) == i - 1))
      return;
  Sentence said = {words[verb]};
  const Sentence thing = cut(words, begin, end);
  said.insert(said.end(), thing.begin(), thing.end());
  const Sentence with = cut(words, verb + 1, verb_end);
  said.insert(said.end(), with.begin(), with.end());
  for (std::size_t at = verb_end; at < words.size();) {
    if (spans.ends(at)) {
      said.push_back(words[at++]);
      continue;
    }
    const std::size_t head = spans.skip_small(at), stop = spans.part_end(at);
    const Sentence small = cut(words, at, head);
    said.insert(said.end(), small.begin(), small.end());
    if (spans.somewhere(head) == stop && stop > head) {
      said.insert(said.end(), {"put", "it"});
      if (!place_preposition(words[head])) said.emplace_back("to");
    } else if (spans.is(head, "here")) {
      said.insert(said.end(), {"bring", "it"});
    }
    const Sentence rest = cut(words, head, stop);
    said.insert(said.end(), rest.begin(), rest.end());
    at = stop;
  }
  words = std::move(said);
}

// "coke, glass, you know the drill, pour it" -> "pour coke into glass"
void join_thing_and_place(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  const std::size_t thing = spans.skip_small(0), thing_end = spans.part_end(thing);
  const std::size_t place = std::min(thing_end + 1, words.size()), place_end = spans.part_end(place);
  if (place_end >= words.size() || !thing_alone(spans, thing, thing_end) ||
      spans.somewhere(place) != place_end || place == place_end || words[place - 1] != ",")
    return;
  std::size_t verb = place_end + 1;
  for (; verb < words.size() && !spans.order(spans.skip_small(verb)); verb = spans.part_end(verb) + 1)
    if (spans.names(verb, spans.part_end(verb))) return;
  verb = spans.skip_small(verb);
  if (verb >= words.size()) return;
  const Frame frame = language.verb(words[verb]);
  const std::size_t it = spans.phrase(verb + 1, {"it", "them"});
  const std::size_t done =
      spans.phrase(it, {"in", "into it", "in it", "in there", "there", "on", "on it", "over"});
  if ((frame != Frame::kPour && frame != Frame::kPlace && frame != Frame::kAdd && frame != Frame::kInsert) ||
      it == verb + 1 || !spans.ends(spans.skip_small(done)))
    return;
  Sentence order = {words[verb]};
  const Sentence what = cut(words, thing, thing_end), where = cut(words, place, place_end);
  order.insert(order.end(), what.begin(), what.end());
  if (!place_preposition(where.front())) order.emplace_back(frame == Frame::kPour ? "into" : "to");
  order.insert(order.end(), where.begin(), where.end());
  replace(words, thing, done, order);
}

// "is that the coke? fridge with it"; "do not put it on the shelf, counter instead"
void short_places(Sentence& words, const Language& language) {
  for (std::size_t at = 1; at + 1 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at)) continue;
    const std::size_t begin = spans.skip_small(at), place = spans.somewhere(begin);
    if (place == begin || spans.place(begin) == place) continue;
    const bool known_place =
        language.names_place(words[place - 1]) ||
        (place - begin > 1 && language.names_place(words[place - 2] + " " + words[place - 1]));
    const std::size_t with_it = spans.phrase(place, {"with it", "with them", "with that", "with those"});
    const std::size_t instead = spans.phrase(place, {"instead", "rather"});
    const std::size_t end = std::max(with_it, instead);
    if (!known_place || end == place || !spans.ends(spans.skip_small(end))) continue;
    const bool forbids = spans.is_one(0, {"not", "dont", "do", "never", "please"});
    if (instead != place && !forbids) continue;
    Sentence order = {"put", with_it != place ? words[with_it - 1] : "it", "to"};
    const Sentence where = cut(words, begin, place);
    order.insert(order.end(), where.begin(), where.end());
    replace(words, begin, end, order);
  }
  // "coffee cold again. microwave."
  for (std::size_t at = 2; at < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at) || words[at] != "microwave" || !spans.ends(spans.skip_small(at + 1))) continue;
    for (std::size_t i = 0; i < at; ++i)
      if (spans.is_one(i, {"cold", "lukewarm", "tepid"})) {
        words.insert(words.begin() + static_cast<long>(at) + 1, "it");
        return;
      }
  }
}

// "I found the coke, it is warm, so fridge" -> "..., so put it to fridge"
void put_it_there(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  std::size_t end = words.size();
  while (end > 0 && (spans.ends(end - 1) || words[end - 1] == "please" || words[end - 1] == "then")) --end;
  if (end < 4) return;
  const std::size_t begin = spans.part_begin(end - 1);
  const std::size_t place = spans.phrase(begin, {"so", "so to", "so back", "hence", "therefore", "so off"});
  if (begin == 0 || place == begin || place >= end) return;  // "..., so" says no place
  if (spans.somewhere(place) != end || spans.orders(0, begin)) return;
  const bool known_place =
      place_preposition(words[place]) || language.names_place(words[end - 1]) ||
      language.names_place(end - place > 1 ? words[end - 2] + " " + words[end - 1] : words[end - 1]);
  if (!known_place || !spans.names(0, begin)) return;
  bool many = false;
  for (std::size_t i = 0; i < begin; ++i)
    many = many || (spans.is(i, "are") && i > 0 && spans.name(i - 1) > 0);
  Sentence order = {"put", many ? "them" : "it"};
  if (!place_preposition(words[place])) order.emplace_back("to");
  words.insert(words.begin() + static_cast<long>(place), order.begin(), order.end());
}

}  // namespace goalnet::inference
