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
