// What is taken back as a whole: "turn on the stove, never mind that, turn on the microwave".
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {
namespace {

// Behind what takes back, between pauses: "(oh) never mind (that)"; `at` where it is not that.
std::size_t taken_back(const WordSpans& spans, std::size_t at) {
  std::size_t i = spans.skip_small(at);
  while (spans.is_one(i, {"wait", "sorry", "nah", "nope", "no", "hmm", "er", "actually"}))
    i = spans.skip_small(i + 1);
  const std::size_t done = spans.phrase(i, {"never mind",
                                            "never mind that",
                                            "never mind it",
                                            "never mind about that",
                                            "nevermind",
                                            "nevermind that",
                                            "forget it",
                                            "forget that",
                                            "forget about it",
                                            "forget about that",
                                            "forget i said that",
                                            "scrap that",
                                            "scrap it",
                                            "scratch that",
                                            "cancel that",
                                            "cancel it",
                                            "ignore that",
                                            "drop that",
                                            "strike that",
                                            "skip that",
                                            "skip it",
                                            "leave it",
                                            "leave that",
                                            "do not bother",
                                            "dont bother",
                                            "what am i saying",
                                            "what am i doing",
                                            "what am i thinking",
                                            "what am i on about",
                                            "what am i talking about",
                                            "do not",
                                            "dont"});
  return done != i && spans.ends(done) ? done : at;
}

// Behind "well not throw", where that is the verb of an order before; `at` where it is not that.
std::size_t verb_denied(const Sentence& words, const WordSpans& spans, std::size_t at) {
  const std::size_t no = spans.skip_small(at), verb = spans.phrase(no, {"not", "dont", "do not"});
  if (verb == no || !spans.order(verb) || !spans.ends(verb + 1)) return at;
  for (std::size_t i = 0; i + 1 < at; ++i)
    if (words[i] == words[verb]) return verb + 1;
  return at;
}

// Behind "that's got coffee in it", said between what is taken back and what is asked instead; `at` where it
// is not that.
std::size_t reason(const WordSpans& spans, std::size_t at) {
  if (!spans.is_one(at, {"that", "it", "this", "they", "those", "there", "i", "we", "he", "she", "the"}) ||
      spans.orders(at, spans.part_end(at)))
    return at;
  std::size_t next = spans.part_end(at);
  const std::size_t told = next;
  while (spans.is_one(next, {",", "."})) ++next;
  return next > told && spans.orders(next, spans.part_end(next)) ? next : at;
}

// "forget the beer. Coke."
void take_the_second(Sentence& words, const Language& language) {
  const WordSpans spans(words, language);
  const std::size_t head = spans.skip_small(0);
  const std::size_t what = spans.phrase(head, {"forget", "skip", "never mind", "forget about"});
  const std::size_t end = spans.thing(what), next = spans.skip_small(end + 1);
  if (what != head && end != what && end < words.size() && spans.ends(end) && next < words.size() &&
      spans.thing(next) != next && spans.ends(spans.skip_small(spans.thing(next))))
    replace(words, head, next, {"wish"});
}

}  // namespace

void mark_retractions(Sentence& words, const Language& language) {
  take_the_second(words, language);
  for (std::size_t at = 1; at < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at)) continue;
    const std::size_t denied = verb_denied(words, spans, at);
    const std::size_t done = denied != at ? denied : taken_back(spans, at);
    if (done == at || !spans.orders(0, at - 1)) continue;
    std::size_t next = done;
    while (next < words.size() && spans.ends(next)) ++next;
    // "..., I'll get it myself"
    if (spans.phrase(next, {"i will", "ill", "i can", "we will"}) != next && !spans.names(next, words.size()))
      next = words.size();
    next = reason(spans, next);
    const bool leave = words[done - 2] == "leave";  // "take the book, leave it, ..." may speak of the book
    const std::size_t end = spans.part_end(next);
    bool anew = spans.orders(next, end);
    if (leave) anew = anew && (spans.is_one(next, {"just", "rather"}) || spans.is(end - 1, "instead"));
    if (anew) {
      replace(words, at, next, {"correction", ","});
    } else if (next >= words.size() && !leave) {
      // nothing is left of it
      std::size_t order = 0;
      while (order < at && !spans.order(order)) ++order;
      words = cut(words, order, at - 1);
      words.insert(words.begin(), "not");
      return;
    }
  }
}

}  // namespace goalnet::inference
