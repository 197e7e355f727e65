// What belongs into a phrase and is said behind it: its number, how many, what tells it apart.
#include <algorithm>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

// "on the fire place of the stove, the number three" -> "on the fire place three of the stove"
void numbers_said_after(Sentence& words, const Language& language) {
  for (std::size_t at = 2; at + 1 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (words[at - 1] != ",") continue;
    const std::size_t said_so = spans.phrase(at, {"specifically", "namely", "that is", "to be precise"});
    const std::size_t number = spans.phrase(said_so, {"number", "the number", "nr", "no"});
    if (number == said_so || number >= words.size() || number_word(words[number]) == 0 ||
        number_word(words[number]) > 6 || !spans.ends(spans.skip_small(number + 1)))
      continue;
    const std::size_t begin = spans.part_begin(at - 2);
    std::size_t name_end = begin;
    for (std::size_t i = begin; i + 1 < at; ++i) {
      const std::size_t length = spans.name(i);
      if (length == 0 || (i > begin && i > 1 && (words[i - 1] == "of" || words[i - 2] == "of"))) continue;
      name_end = i + length;
      i += length - 1;
    }
    if (name_end == begin || number_word(words[name_end]) > 0) continue;
    const std::string said = words[number];
    replace(words, at - 1, number + 1, {});
    words.insert(words.begin() + static_cast<long>(name_end), said);
    if (name_end > 1 && words[name_end - 2] == "one")  // "one burner, number three"
      words.erase(words.begin() + static_cast<long>(name_end) - 2);
  }
}

// "the discs both of them i want them on the desk" -> "both the discs , i want them on the desk"
void counts_said_after(Sentence& words, const Language& language) {
  for (std::size_t at = 1; at + 2 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.is_one(at, {"both", "all"})) continue;
    std::size_t of = at + 1;
    const bool counted = of < words.size() && number_word(words[of]) > 0;
    if (counted) ++of;
    const std::size_t done = spans.phrase(of, {"of them", "of those", "of these"});
    if (done == of) continue;
    const std::size_t thing_end = spans.ends(at - 1) ? at - 1 : at, begin = spans.part_begin(thing_end - 1);
    const std::size_t thing = spans.skip_small(begin);
    if (spans.things(thing) == thing_end && spans.thing(thing) != thing_end && !spans.ends(at - 1)) {
      replace(words, at, done, {});  // "the plate and the bowl both of them"
      continue;
    }
    if (thing_end == 0 || !one_of(words[thing], kArticles) || spans.thing(thing) != thing_end) continue;
    Sentence said = {words[at]};
    const Sentence named = cut(words, thing, thing_end);
    said.insert(said.end(), named.begin(), named.end());
    if (!spans.ends(done)) said.emplace_back(",");
    replace(words, thing, done, said);
  }
}

// "take the salt off the stove, and the coke too, and ..." -> "take the salt and the coke off the stove, and
// ..."
void things_said_after(Sentence& words, const Language& language) {
  for (std::size_t at = 4; at + 2 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (words[at] != "and" || !one_of(words[at + 1], kArticles)) continue;
    const std::size_t other = spans.thing(at + 1), too = spans.phrase(other, {"too", "also", "as well"});
    if (other == at + 1 || too == other || !(spans.ends(too) || spans.is(too, "and")) ||
        language.names_place(words[other - 1]))
      continue;
    const std::size_t place_end = spans.ends(at - 1) ? at - 1 : at;
    std::size_t from = place_end - 1;
    while (from > 1 && !spans.ends(from) && !spans.is_one(from, {"off", "from"})) --from;
    if (!spans.is_one(from, {"off", "from"}) || spans.thing(from + 1) != place_end) continue;
    const std::size_t end = spans.is(from - 1, "away") ? from - 1 : from;
    std::size_t thing = end - 1;
    while (thing > 0 && !spans.ends(thing) && !one_of(words[thing], kArticles)) --thing;
    if (!one_of(words[thing], kArticles) || thing == 0 || spans.thing(thing) != end) continue;
    const Sentence said = cut(words, at, other);
    replace(words, place_end, too, {});
    words.insert(words.begin() + static_cast<long>(end), said.begin(), said.end());
  }
}

// "on the stove, the second burner" -> "on the second burner"; "on the table, the coffee one"
void places_said_after(Sentence& words, const Language& language) {
  for (std::size_t at = 3; at + 1 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (words[at - 1] != "," || words[at] != "the" || spans.ends(at + 1)) continue;
    std::size_t place = at - 2;
    while (place > 0 && !spans.ends(place) && spans.place(place) != at - 1) --place;
    const std::size_t done = spans.thing(at);
    if (spans.place(place) != at - 1) continue;
    const bool other_name = words[at + 2 < words.size() ? at + 2 : at] == "one" &&
                            language.names_place(words[at + 1] + " " + words[at - 2]);
    if (other_name && spans.ends(spans.skip_small(at + 3))) {
      words[at + 2] = words[at - 2];
      replace(words, place + 1, at, {});
      continue;
    }
    const bool burner = spans.is_one(at - 2, {"stove", "cooker", "hob"}) && done > at &&
                        spans.is_one(done - 1, {"burner", "flame", "ring", "hotplate", "fire"});
    if (burner && spans.ends(spans.skip_small(done))) replace(words, place + 1, at, {});
  }
}

// "her armchair, it is the only one without a pillow" -> "her armchair without a pillow"
void descriptions_said_after(Sentence& words, const Language& language) {
  for (std::size_t at = 2; at + 3 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (words[at - 1] != ",") continue;
    const std::size_t one = spans.phrase(
        at, {"it is the one", "it is the only one", "that is the one", "that is the only one",
             "the one i left", "the one that i left", "the one i put", "the one i saw", "the one i had"});
    if (one == at || spans.ends(one)) continue;
    std::size_t noun = at - 2;
    while (noun > 0 && !spans.ends(noun - 1) && spans.thing(noun - 1) == at - 1) --noun;
    const bool told =
        spans.thing(noun) == at - 1 && (one_of(words[noun], kArticles) || one_of(words[noun], kPointers));
    const std::size_t from = spans.phrase(one, {"that is", "which is", "that has", "which has"});
    const std::size_t place =
        spans.is_one(from, {"without", "with"}) ? spans.thing(from + 1) : spans.place(from);
    if (!told || place == from) continue;
    const bool left = words[at] == "the";  // "the one I left on the table yesterday"
    if (left)
      while (spans.is_one(
          place, {"yesterday", "earlier", "before", "there", "last", "night", "this", "morning", "today"}))
        words.erase(words.begin() + static_cast<long>(place));
    replace(words, at - 1, from, left ? Sentence{"that", "is"} : Sentence{});
  }
}

// "Book. Any book.", "a plate any plate": one of them is asked for
void ask_for_any(Sentence& words, const Language& language) {
  for (std::size_t at = 1; at + 1 < words.size(); ++at) {
    const WordSpans spans(words, language);
    const std::size_t any = spans.phrase(at, {"any", "either", "whichever", "any of the", "either of the"});
    if (any == at || spans.name(any) == 0) continue;
    const std::size_t end = any + spans.name(any);
    if (!spans.ends(spans.skip_small(end))) continue;
    const std::size_t before = spans.ends(at - 1) ? at - 1 : at;
    if (before == 0) continue;
    std::size_t name = before - 1;
    while (name > 0 && !spans.ends(name - 1) && spans.name(name - 1) == before - (name - 1)) --name;
    const bool same = singular(words[before - 1]) == singular(words[end - 1]) && spans.name(name) > 0;
    const bool stove =
        spans.is_one(before - 1, {"stove", "cooker", "hob"}) && singular(words[any]) == "burner";
    if (!same && !stove) continue;
    std::size_t from = name;
    while (from > 0 && !spans.ends(from - 1) &&
           (one_of(words[from - 1], kArticles) || spans.is_one(from - 1, {"some", "one", "either", "any"})))
      --from;
    if (words[at - 1] == "," && spans.is_one(from, {"a", "an", "some"})) continue;  // "a book, any book, ..."
    const Sentence said = {"any", singular(words[end - 1])};
    replace(words, from, end, said);
  }
  const WordSpans spans(words, language);
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {  // "there is none, so a coke"
    const std::size_t so = spans.phrase(i, {"so", "so just", "so maybe", "then", "so at least"});
    const std::size_t end = spans.thing(so);
    if (!spans.begins(i) || so == i || end == so || !spans.is_one(so, {"a", "an", "some", "one"}) ||
        spans.orders(0, words.size()))
      continue;
    const std::size_t least = spans.phrase(end, {"at least", "then", "please", "instead"});
    if (!spans.ends(least) || least + 1 < words.size()) continue;
    replace(words, i, so, {"wish"});
    return;
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (spans.begins(i) && words[i] == "any" && spans.name(i + 1) > 0 &&
        spans.ends(spans.skip_small(i + 1 + spans.name(i + 1))) && !spans.names(0, i) &&
        !spans.orders(0, words.size())) {
      words.insert(words.begin() + static_cast<long>(i), "wish");
      return;
    }
}

}  // namespace goalnet::inference
