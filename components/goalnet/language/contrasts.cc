// "not the books on the shelf, leave those, but the one on the couch": only what is behind "but" is wanted.
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::size_t kLongest = 16;  // words that are not wanted

}  // namespace

// "it is not the spoon I want, it is the fork" -> "i want the fork"; "it was channel four I wanted, not five"
void want_what_it_is(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 4 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at)) continue;
    const std::size_t no = spans.phrase(at, {"it is not", "it isnt", "it was not", "it wasnt"});
    const std::size_t is = spans.phrase(at, {"it was", "it is"});
    const std::size_t thing = spans.things(no != at ? no : is);
    const std::size_t wish =
        spans.phrase(thing, {"i want", "i wanted", "i need", "i needed", "i meant", "i asked for",
                             "that i want", "that i wanted", "that i need", "that i meant", "i am after"});
    if ((no == at && is == at) || thing == std::max(no, is) || wish == thing) continue;
    if (no == at) {
      const Sentence named = cut(words, is, thing);
      replace(words, at, wish, {"i", "want"});
      words.insert(words.begin() + static_cast<long>(at) + 2, named.begin(), named.end());
      return;
    }
    std::size_t next = wish;
    while (next < words.size() && (spans.ends(next) || words[next] == "but")) ++next;
    const std::size_t other = spans.phrase(next, {"it is", "it was", "i want", "i need", "i meant"});
    if (next == wish || other == next || spans.thing(other) == other) continue;
    replace(words, at, other, {"i", "want"});
    return;
  }
}

void keep_the_contrast(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  std::size_t at = spans.skip_small(0);
  while (spans.is(at, ",")) ++at;
  if (!spans.is(at, "not") || at + 3 >= words.size() || spans.thing(at + 1) == at + 1 ||
      !(one_of(words[at + 1], kArticles) || one_of(words[at + 1], kPointers)))
    return;
  std::size_t noun = at + 2;
  while (noun < words.size() && spans.name(noun) == 0) ++noun;
  // the part, or what it says to leave, ends before "but"
  std::size_t but = at + 2;
  while (but < words.size() && but < at + kLongest && words[but] != "." && words[but] != "but") ++but;
  if (but >= words.size() || words[but] != "but" || noun >= but) return;
  for (std::size_t i = at + 2; i < but; ++i)
    if (spans.begins(i) && !spans.is_one(i, {"leave", "keep", "those", "they", "forget", "not", "never"}))
      return;
  const std::size_t wanted = spans.skip_small(but);
  if (wanted >= words.size() || spans.thing(wanted) == wanted) return;
  Sentence one = cut(words, noun, noun + spans.name(noun));
  one.back() = singular(one.back());
  if (const std::size_t last = spans.thing(wanted) - 1; words[last] == "one")
    replace(words, last, last + 1, one);
  replace(words, at, wanted, {});
  const WordSpans left(words, language);
  const std::size_t end = left.part_end(at);
  bool asks = false;
  for (std::size_t i = at; i < words.size(); ++i)
    asks = asks || left.is_one(i, {"want", "need", "like", "love", "wish"}) || left.order(i);
  if (!asks && left.place(left.thing(at)) == end) words.insert(words.begin() + static_cast<long>(at), "wish");
}

}  // namespace goalnet::inference
