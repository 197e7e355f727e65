// What is said in one breath: pauses where the grammar needs them.
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

// Behind these a clause hangs on what stands before it.
constexpr std::array kHangsOn = {
    "that"sv,  "which"sv,  "who"sv,     "where"sv,  "when"sv,    "if"sv,       "because"sv,
    "while"sv, "until"sv,  "till"sv,    "before"sv, "after"sv,   "once"sv,     "unless"sv,
    "so"sv,    "and"sv,    "but"sv,     "or"sv,     "how"sv,     "what"sv,     "why"sv,
    "say"sv,   "says"sv,   "said"sv,    "think"sv,  "sure"sv,    "know"sv,     "hope"sv,
    "see"sv,   "hear"sv,   "whether"sv, "as"sv,     "than"sv,    "since"sv,    "though"sv,
    "like"sv,  "tell"sv,   "wish"sv,    "guess"sv,  "believe"sv, "whenever"sv, "wherever"sv,
    "not"sv,   "ensure"sv, "check"sv,   "is"sv,     "are"sv,     "was"sv,      "for"sv};
constexpr std::array kBe = {"is"sv,   "are"sv, "was"sv,   "were"sv, "has"sv,
                            "have"sv, "am"sv,  "hurts"sv, "hurt"sv, "aches"sv};

bool hangs_at(const Sentence& words, std::size_t at) { return one_of(words[at], kHangsOn); }

bool hangs(const Sentence& words, std::size_t from, std::size_t at) {
  for (std::size_t i = from; i < at; ++i)
    if (hangs_at(words, i)) return true;
  return false;
}

// "can you put ...", "could you please bring ..." in the middle of a part.
bool asks_anew(const Sentence& words, const WordSpans& spans, const Language& language, std::size_t at) {
  if (!spans.is_one(at, {"can", "could", "would", "will"}) || !spans.is(at + 1, "you") ||
      spans.is_one(at - 1, {"please", "just", "maybe", "hey", "hi", "hello", "robot", "then", "also"}))
    return false;
  const std::size_t verb = spans.skip_small(at + 2);
  return verb < words.size() && language.verb(words[verb]) != Frame::kNone;
}

// Whether a clause that only tells something begins at `at`, inside a part that asks: "it is melting", "my
// show is starting".
bool tells_from(const Sentence& words, const WordSpans& spans, std::size_t at, bool behind_name) {
  if (at + 1 >= words.size() || spans.ends(at + 1)) return false;
  // "the coke i am starving": nothing that anybody does with the coke
  const std::size_t am = spans.phrase(at, {"im", "i am", "we are"});
  if (am != at && spans.is_one(am, {"starving", "dying", "freezing", "sleeping", "leaving", "working"}) &&
      spans.ends(am + 1))
    return true;
  if (at + 2 >= words.size()) return false;
  const bool being = spans.is_one(at + 1, {"is", "are", "has", "was", "were"});
  if (spans.is_one(at, {"it", "they", "he", "she"})) return being;
  if (spans.is_one(at, {"i", "we"}) && spans.name(spans.part_begin(at)) == at - spans.part_begin(at))
    return spans.is_one(at + 1,
                        {"forgot", "need", "want", "have", "lost", "am", "are"});  // "salt i forgot the salt"
  if (spans.is_one(at, {"i", "we"}))
    return spans.is_one(at + 1, {"am", "are"}) && !(behind_name && words[at + 2].ends_with("ing"));
  if (behind_name || !spans.is_one(at, {"my", "our", "the", "his", "her"})) return false;
  // "on the shelf is ..." goes on
  if (spans.is_one(at - 1, {"on", "off", "up", "down", "back", "away"})) return false;
  return (at + 2 < words.size() && one_of(words[at + 2], kBe)) ||
         (at + 3 < words.size() && !spans.ends(at + 2) && one_of(words[at + 3], kBe));
}

// A name, or a small word with which a short request ends: "fridge it is ...", "spoon quick the soup is ...".
bool request_may_end(const WordSpans& spans, std::size_t last) {
  return spans.is_one(last, {"please", "now", "quick", "quickly", "fast", "off", "on", "back", "up", "down",
                             "here", "away", "again", "asap", "immediately"});
}

// "burner two and no other burner"
void drop_no_other(Sentence& words, const Language& language) {
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    const std::size_t no = spans.phrase(i, {"and no other", "but no other", "and no others", ", no other"});
    const std::size_t end =
        no == i ? i : no + std::max(spans.name(no), std::size_t{spans.is_one(no, {"one", "ones"})});
    if (no == i || !spans.ends(end)) continue;
    // ", and no other book, to the shelf": the place belongs to what stands before
    const bool between = words[i - 1] == "," && spans.is(end, ",") && end + 1 < words.size() &&
                         place_preposition(words[end + 1]);
    replace(words, between ? i - 1 : i, between ? end + 1 : end, {});
  }
}

// "that pillow over there on armchair two"
void drop_pointing(Sentence& words, const Language& language) {
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    const WordSpans spans(words, language);
    const std::size_t there =
        spans.phrase(i, {"there", "over there", "up there", "down there", "lying there", "standing there"});
    if (there != i && !spans.ends(i - 1) && spans.name(i - 1) > 0 && spans.place(there) != there &&
        !spans.orders(spans.part_begin(i), i))
      replace(words, i, there, {});
  }
}

// "in the sink no in the fridge", "burner one no burner two": whether what stands behind "no" is said
// instead.
bool instead_of_before(const Sentence& words, const WordSpans& spans, std::size_t begin, std::size_t no) {
  const auto from = words.begin() + static_cast<long>(begin), to = words.begin() + static_cast<long>(no);
  return words[no] == "no" && (one_of(words[no + 1], kArticles) || spans.place(no + 1) != no + 1 ||
                               std::find(from, to, words[no + 1]) != to);
}

// "ramen in the bowl water in it": whether at `at` the next thing and its place begin.
bool next_thing_and_place(const Sentence& words, const WordSpans& spans, std::size_t begin, std::size_t at) {
  const std::size_t first = spans.skip_small(begin), thing = spans.thing(first), place = spans.place(thing);
  const std::size_t second = at + spans.name(at);
  return thing != first && place == at && place != thing && second != at && second < words.size() &&
         place_preposition(words[second]) && !spans.ends(second + 1);
}

// "that is slow so ramen in the bowl"
bool so_request(const WordSpans& spans, std::size_t at) {
  const std::size_t thing = spans.thing(at + 1), place = spans.place(thing);
  return spans.is(at, "so") && thing != at + 1 && place != thing &&
         !spans.is_one(place, {"is", "are", "has", "have", "can", "stays", "should"});
}

// "put the chips on the table open it if it is closed": the condition is only about what begins at `at`.
bool only_this_under_if(const Sentence& words, const WordSpans& spans, std::size_t at) {
  const std::size_t begin = spans.part_begin(at);
  if (spans.name(at - 1) == 0 || !spans.order(at) || !spans.orders(begin, at) || hangs(words, begin, at) ||
      !spans.is_one(at + 1, {"it", "them", "the", "my"}))
    return false;
  for (std::size_t k = at + 2; !spans.ends(k); ++k)
    if (spans.order(k) || spans.is_one(k, {"and", "then"}))
      return false;
    else if (spans.is_one(k, {"if", "unless"}))
      return true;
  return false;
}

// "I want to sit there so take the pillow off it", "forget the coffee just pour it away"
bool so_order(const WordSpans& spans, std::size_t at) {
  return spans.is_one(at, {"so", "just"}) && spans.name(at - 1) > 0 && spans.order(at + 1) &&
         spans.is_one(at + 2, {"it", "them", "the", "my"});
}

// "pillow three is mine put it on my armchair", "wash the plate put the mug in the sink": the next order
// behind what nobody goes on with so.
bool next_order(const Sentence& words, const WordSpans& spans, std::size_t begin, std::size_t at) {
  const bool behind = spans.name(at - 1) > 0 || spans.is_one(at - 1, {"mine", "yours", "there", "here"});
  const std::size_t first = spans.skip_small(begin);
  if (!behind || !spans.order(at) || spans.ends(at + 1) || spans.ends(at + 2) ||
      spans.is(at - 1, "can") ||                                    // "I can reach them"
      spans.is_one(first, {"make", "let", "have", "get", "help"}))  // "make the microwave heat the mug"
    return false;
  if (spans.is_one(at + 1, {"it", "them"})) return true;
  return spans.is_one(at + 1, {"the", "my"}) && spans.order(first) && !hangs(words, begin, at);
}

}  // namespace

void drop_tags(Sentence& words, const Language& language) {
  static constexpr std::array kNot = {"isnt"sv,  "arent"sv,   "wasnt"sv,  "doesnt"sv,  "dont"sv,
                                      "didnt"sv, "hasnt"sv,   "havent"sv, "cant"sv,    "couldnt"sv,
                                      "wont"sv,  "wouldnt"sv, "aint"sv,   "shouldnt"sv};
  static constexpr std::array kWho = {"it"sv, "they"sv, "he"sv, "she"sv, "you"sv, "we"sv, "i"sv, "there"sv};
  for (std::size_t i = 1; i + 1 < words.size();) {
    const WordSpans spans(words, language);
    const std::size_t joke = spans.phrase(i, {"get it", "got it", "geddit", "get the joke"});
    if (joke != i && spans.ends(joke) && i > 1 && words[i - 1] == "," &&
        spans.is_one(i - 2, {"ha", "haha", "hehe", "lol", "hah"})) {
      replace(words, i - 1, joke, {});
      continue;
    }
    // "one of those, I don't care which, on my couch"
    const std::size_t any = spans.phrase(
        i, {"i dont care which", "i dont care which one", "i do not care which one", "dont care which",
            "doesnt matter which", "it doesnt matter which one", "doesnt matter which one",
            "it doesnt matter which", "no matter which", "whichever", "you choose", "your choice",
            "i dont mind which", "i dont mind which one", "whichever one"});
    if (any != i && words[i - 1] == "," && any + 1 < words.size() && words[any] == "," &&
        spans.place(any + 1) != any + 1) {
      replace(words, i - 1, any + 1, {});
      continue;
    }
    const bool tag =
        spans.ends(i - 1) && one_of(words[i], kNot) && one_of(words[i + 1], kWho) && spans.ends(i + 2);
    // "the tv is on channel three, isn't it?" only asks
    const bool only_asks = tag && spans.is_one(i, {"isnt", "arent", "wasnt"}) && i + 3 >= words.size() &&
                           !spans.orders(0, i - 1);
    if (tag && !only_asks)
      replace(words, i - 1, i + 2, {});
    else
      ++i;
  }
}

void part_run_ons(Sentence& words, const Language& language) {
  drop_no_other(words, language);
  drop_pointing(words, language);
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    const WordSpans spans(words, language);
    if (spans.ends(i) || spans.ends(i - 1)) continue;
    std::size_t begin = spans.part_begin(i);
    for (std::size_t k = begin; k + 1 < i; ++k)
      if (spans.is_one(k, {"so", "but", "and"})) begin = k + 1;
    // "I forgot the salt can you put some in the bowl"
    bool pause = (asks_anew(words, spans, language, i) && !hangs_at(words, i - 1)) || so_request(spans, i) ||
                 only_this_under_if(words, spans, i) || so_order(spans, i) ||
                 next_order(words, spans, begin, i);
    const bool name_before = spans.name(i - 1) > 0 || number_word(words[i - 1]) > 0;
    if (!pause && (name_before || request_may_end(spans, i - 1))) {
      pause = tells_from(words, spans, i, name_before) && !hangs(words, begin, i);
      if (name_before && !hangs(words, begin, i) && instead_of_before(words, spans, begin, i)) {
        replace(words, i, i + 1, {",", "no", ","});
        continue;
      }
      pause = pause || (name_before && next_thing_and_place(words, spans, begin, i));
    }
    if (pause) words.insert(words.begin() + static_cast<long>(i), ",");
  }
}

}  // namespace goalnet::inference
