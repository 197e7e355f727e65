// What people begin with before they ask: "you know what would be nice right now, ...", "had a terrible
// night".
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// "you know what would be nice right now": where the thing is wished for that comes next.
bool announces(const WordSpans& spans, std::size_t at, std::size_t end) {
  std::size_t i = spans.phrase(at, {"you know", "do you know", "know", "guess", "i know", "i tell you"});
  std::size_t to = i;  // "... with this film"
  while (to < end && !spans.is_one(to, {"with", "for", "in", "on"})) ++to;
  if (!spans.is(i, "what") || spans.names(i + 1, to)) return false;
  i = spans.phrase(i + 1, {"i", "we", "really"});
  return spans.phrase(i, {"would", "could do with", "really would", "need", "want", "fancy", "could use",
                          "would like", "could really", "could go for", "could", "miss", "crave"}) != i &&
         end > i;
}

// "been a long day", "had a terrible night": tells what was, without saying who.
bool tells_what_was(const Sentence& words, const WordSpans& spans, std::size_t at, std::size_t end) {
  return one_of(words[at], kPastForms) && !spans.names(at, end) && end > at + 1;
}

// "friends come at eight", "my sister comes tomorrow"
bool somebody_comes(const Sentence& words, const WordSpans& spans, const Language& language, std::size_t at,
                    std::size_t end) {
  std::size_t i = at;
  while (i < end && (one_of(words[i], kArticles) || words[i] == "some")) ++i;
  if (i >= end || !(language.person(words[i]) || language.person(singular(words[i])) ||
                    spans.is_one(i, {"friends", "friend", "guests", "guest", "visitors", "people", "company",
                                     "everybody", "everyone", "they"})))
    return false;
  const std::size_t comes =
      spans.phrase(i + 1, {"come", "comes", "arrive", "arrives", "visit", "visits", "come over", "comes over",
                           "come round", "comes round", "come home", "comes home", "get here", "gets here",
                           "are coming", "is coming", "are arriving"});
  return comes != i + 1 && comes < end &&
         spans.is_one(comes, {"at", "tomorrow", "tonight", "later", "soon", "today", "in", "on", "this"});
}

// "I would put it in the freezer if I were you"
void advise(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 4 <= words.size(); ++at) {
    const WordSpans spans(words, language);
    const std::size_t end =
        spans.phrase(at, {"if i were you", "if i was you", "if it were me", "if it was me"});
    if (end == at || at == 0 || !spans.ends(end)) continue;
    std::size_t would = at;
    while (would > 0 && words[would] != "." && !(words[would - 1] == "i" && words[would] == "would")) --would;
    if (would == 0 || !spans.order(would + 1)) continue;
    replace(words, at, end, {});
    replace(words, would - 1, would + 1, {"please"});
  }
}

// "hello, can you hear me ok, ..."
void drop_calls(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 4 <= words.size(); ++at) {
    const WordSpans spans(words, language);
    const std::size_t done =
        spans.phrase(at, {"can you hear me", "do you hear me", "can you hear me ok", "can you hear me okay",
                          "can you hear me now", "are you listening", "are you there", "are you awake"});
    if (done != at) replace(words, at, done, {","});
  }
}

// "to boil the water you must put ..." -> "put ..."; "I can reach them if you put them there" -> "please put
// ..."
void drop_purposes(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 4 < words.size(); ++at) {
    const WordSpans spans(words, language);
    if (!spans.begins(at)) continue;
    const std::size_t end = spans.part_end(at);
    const bool purpose = words[at] == "to" && spans.order(at + 1);
    const bool could = spans.phrase(at, {"i can", "i could", "we can", "we could", "i will"}) != at;
    for (std::size_t i = at + 2; (purpose || could) && i + 2 < end; ++i) {
      const std::size_t you = purpose ? spans.phrase(i, {"you must", "you have to", "you need to",
                                                         "you should", "you can", "you will have to"})
                                      : spans.phrase(i, {"if you", "if you would", "if you could"});
      if (you == i || !spans.order(you)) continue;
      replace(words, at, you, {"please"});
      break;
    }
  }
}

// "if I had a glass of water I'd be happy" -> "wish a glass of water"
void wish_what_if(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at + 4 < words.size(); ++at) {
    const WordSpans spans(words, language);
    const std::size_t had = spans.phrase(at, {"if i had", "if only i had", "if i only had", "if we had"});
    const std::size_t thing = spans.thing(had);
    const std::size_t would =
        spans.phrase(spans.is(thing, ",") ? thing + 1 : thing, {"i would be", "we would be", "i would feel"});
    if (had == at || thing == had || !spans.begins(at) ||
        !(spans.is_one(would, {"happy", "glad", "fine", "better", "content", "happier", "grateful", "good",
                               "so", "very"})))
      continue;
    const Sentence named = cut(words, had, thing);
    replace(words, at, spans.part_end(would), {"wish"});
    words.insert(words.begin() + static_cast<long>(at) + 1, named.begin(), named.end());
  }
}

}  // namespace

void drop_lead_ins(Sentence& words, const Language& language) {
  advise(words, language);
  drop_purposes(words, language);
  wish_what_if(words, language);
  drop_calls(words, language);
  for (std::size_t at = 0; at < words.size();) {
    const WordSpans spans(words, language);
    const std::size_t begin = spans.skip_small(at), end = spans.part_end(at);
    if (!spans.begins(at) || begin >= end) {
      ++at;
      continue;
    }
    const bool more = at > 0 || end + 1 < words.size();
    if (const std::size_t next = end + 1; next < words.size() && announces(spans, begin, end) &&
                                          spans.thing(next) != next &&
                                          !spans.is_one(spans.thing(next), {"is", "are", "on", "in"})) {
      replace(words, begin, next, {"wish"});
    } else if (more && (somebody_comes(words, spans, language, begin, end) ||
                        (at == 0 && tells_what_was(words, spans, begin, end)))) {
      // a sentence that begins so only tells; what follows of it does too, where it names nothing
      std::size_t stop = end;
      while (at == 0 && stop < words.size() && words[stop] == "," &&
             !spans.names(stop + 1, spans.part_end(stop + 1)) && spans.part_end(stop + 1) > stop + 1)
        stop = spans.part_end(stop + 1);
      replace(words, at, std::min(stop + 1, words.size()), {});
      continue;
    }
    ++at;
  }
}

}  // namespace goalnet::inference
