// Words that somebody began with and left: "turn on the, what's it called, the tv"; what is said over and
// over.
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

constexpr std::size_t kMostParts = 3;  // that somebody hesitates for

// Words for what somebody cannot name: "the big screen thingy".
constexpr std::array kNameless = {
    "thing"sv,   "thingy"sv, "thingie"sv, "thingamajig"sv,     "thingamabob"sv, "thingummy"sv, "whatsit"sv,
    "whatnot"sv, "doodah"sv, "gizmo"sv,   "whatchamacallit"sv, "contraption"sv, "doohickey"sv, "gadget"sv};

// Where the sentence goes on behind the article at `at` with which it broke off; `at` where it does not.
std::size_t goes_on(const WordSpans& spans, std::size_t at) {
  std::size_t i = at + 1;
  for (std::size_t parts = 0; parts < kMostParts && spans.is(i, ","); ++parts) {
    ++i;
    const std::size_t next = spans.skip_small(i);
    if (spans.thing(next) != next || spans.place(next) != next ||
        spans.is_one(next, {"anywhere", "somewhere", "any"}))
      return next;
    i = spans.part_end(i);
    if (spans.names(next, i)) return at;
  }
  return at;
}

}  // namespace

void drop_false_starts(Sentence& words, const Language& language) {
  for (std::size_t at = 1; at + 2 < words.size(); ++at) {
    if (!one_of(words[at], kArticles) || words[at + 1] != ",") continue;
    const WordSpans spans(words, language);
    const std::size_t next = goes_on(spans, at);
    if (next == at) continue;
    const bool place_again = spans.place(next) != next || spans.is_one(next, {"anywhere", "somewhere"});
    const std::size_t from = place_again && place_preposition(words[at - 1]) ? at - 1 : at;
    replace(words, from, next, {});
  }
  // "the big screen thingy, the tv": the name is found at last
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    if (!one_of(words[i], kNameless)) continue;
    const WordSpans spans(words, language);
    std::size_t begin = i;
    while (begin > 0 && !spans.ends(begin - 1) && !one_of(words[begin], kArticles) &&
           !one_of(words[begin], kPointers))
      --begin;
    const std::size_t end = spans.part_end(i), next = end + 1;
    if (!(one_of(words[begin], kArticles) || one_of(words[begin], kPointers)) || !spans.is(end, ",") ||
        next >= words.size() || !one_of(words[next], kArticles))
      continue;
    const std::size_t done = spans.thing(next);
    const bool one = words[done - 1] == "one";  // "the cup thing, the tall one" tells more of it
    if (done != next && spans.ends(done) && !one) replace(words, begin, next, {});
  }
}

// "the controller thing"; "salt, the thing in the white packet"
void drop_nameless(Sentence& words, const Language& language) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    const WordSpans spans(words, language);
    if (!one_of(words[i], kNameless)) continue;
    const std::size_t end = spans.part_end(i);
    if (spans.name(i - 1) > 0 && language.content(words[i - 1]) == symbol::kNone &&
        (spans.ends(spans.skip_small(i + 1)) || place_preposition(words[i + 1])))
      replace(words, i, i + 1, {});
    else if (words[i - 1] == "the" && i > 2 && words[i - 2] == "," && spans.names(0, i - 2) &&
             !spans.names(i, end) && end > i + 1)
      replace(words, i - 2, end, {});
  }
}

void drop_repetitions(Sentence& words, const Language& language) {
  const auto may_be_repeated = [&](const std::string& word) {
    return language.names_something(word) || word == "please" || word == "now" || word == "stop" ||
           word == "quick";
  };
  for (std::size_t i = 0; i + 1 < words.size();) {
    const WordSpans spans(words, language);
    // "coke coke coke", "coke, coke, coke": no list holds the same thing twice
    const std::size_t next =
        words[i + 1] == "," && spans.begins(i) && spans.ends(i + 3 > words.size() ? i + 2 : i + 3) ? i + 2
                                                                                                   : i + 1;
    if (next < words.size() && words[i] == words[next] && may_be_repeated(words[i]) &&
        number_word(words[i]) == 0)
      replace(words, i, next, {});
    else
      ++i;
  }
  // "stop the tap stop it is flooding the sink"
  for (std::size_t begin = 0; begin < words.size(); ++begin) {
    const WordSpans spans(words, language);
    if (!spans.begins(begin) || language.verb(words[begin]) == Frame::kNone) continue;
    const std::size_t done = spans.thing(begin + 1);
    if (done == begin + 1 || done >= words.size() || words[done] != words[begin]) continue;
    const std::size_t pronoun =
        done + 1 < words.size() && is_pronoun(words[done + 1]) && spans.is_one(done + 2, {"is", "are"});
    if (spans.ends(done + 1))
      replace(words, done, done + 1, {});
    else if (pronoun)
      words[done] = ",";
  }
}

// "chips, bring me the chips", "salt, I forgot the salt"
void drop_topics_named_again(Sentence& words, const Language& language) {
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    const std::size_t name = words[i] == "the" ? i + 1 : i, end = name + 1;
    if (!spans.begins(i) || !spans.ends(end) || spans.ends(name) || end + 1 >= words.size() ||
        !language.names_something(words[name]) || language.verb(words[name]) != Frame::kNone)
      continue;
    const std::size_t stop = spans.part_end(end + 1);
    const auto to = words.begin() + static_cast<long>(stop);
    const bool again = std::find(words.begin() + static_cast<long>(end) + 1, to, words[name]) != to;
    if (again && stop > end + (name > i ? 2 : 3)) replace(words, i, end + 1, {});
  }
}

}  // namespace goalnet::inference
