// "put it in the fridge once you have emptied it, the mug": what "it" is, is said at the end.
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

void say_whose_it_is(Sentence& words, const Language& language) {
  for (std::size_t at = 2; at + 1 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (words[at] != "its" || spans.name(at + 1) == 0) continue;
    const std::size_t order = spans.part_begin(at);
    if (order < 2 || words[order - 1] != "," || !spans.order(spans.skip_small(order))) continue;
    const std::size_t begin = spans.part_begin(order - 2), place = spans.skip_small(begin);
    if (spans.thing(place) != order - 1 || !language.names_place(singular(words[order - 2]))) continue;
    Sentence where = cut(words, place, order - 1);
    where.insert(where.begin(), {"that", "is", "on"});
    words[at] = "the";
    words.insert(words.begin() + static_cast<long>(at + 1 + spans.name(at + 1)), where.begin(), where.end());
  }
}

void name_what_comes_last(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  std::size_t end = words.size();
  while (end > 0 && (words[end - 1] == "." || words[end - 1] == "please")) --end;
  if (end < 4) return;
  if (spans.is_one(end - 1, {"does", "do", "is", "are", "must", "should"}))
    --end;  // "it belongs there, the coke does"
  const std::size_t begin = spans.part_begin(end - 1);
  if (begin < 3 || words[begin - 1] != "," ||
      (spans.things(begin) != end && spans.place(spans.things(begin)) != end) || words[end - 1] == "one" ||
      words[end - 1] == "ones" ||
      !(one_of(words[begin], kArticles) || one_of(words[begin], kPointers) || words[begin] == "both"))
    return;
  for (std::size_t i = 0; i < begin; ++i) {
    // what is named before is meant by "it"; a place may be named before, where this is none
    if (spans.name(i) > 0 && !language.names_place(words[i]) && !language.names_place(singular(words[i])))
      return;
    if (language.names_place(words[i]) && language.names_place(words[end - 1])) return;
    if (words[i] != "it" && words[i] != "them" && words[i] != "they") continue;
    if (i + 1 < begin && words[i] == "it" && spans.is_one(i + 1, {"is", "was"}))
      return;  // "it is me, the mug"
    Sentence named = cut(words, begin, end);
    if (const std::size_t thing = spans.things(begin); thing != end)  // "the beer on the shelf"
      named.insert(named.begin() + static_cast<long>(thing - begin), {"that", "is"});
    replace(words, begin - 1, end, {});
    replace(words, i, i + 1, named);
    return;
  }
}

}  // namespace goalnet::inference
