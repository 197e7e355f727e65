#include "components/goalnet/language/slips.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace word_group;
using Sentence = std::vector<std::string>;

constexpr std::size_t kLongestThing = 6;

// What people say when they notice that something was wrong; `at` where it is not that. Some of it is said
// elsewhere too and counts only with a pause behind it ("wait by the tv", "no syrup").
std::size_t interjection(const Sentence& words, std::size_t at, bool& sure) {
  static constexpr std::array kAlways = {"sorry"sv, "oops"sv, "whoops"sv, "pardon"sv,   "hmm"sv, "hm"sv,
                                         "er"sv,    "erm"sv,  "uh"sv,     "um"sv,       "eh"sv,  "err"sv,
                                         "ehm"sv,   "uhm"sv,  "uhh"sv,    "actually"sv, "nope"sv};
  static constexpr std::array kBeforeAPause = {"no"sv, "wait"sv, "nah"sv, "damn"sv};
  static constexpr std::array kUnsure = {"oh"sv, "ah"sv, "well"sv, "ok"sv, "okay"sv};
  static constexpr std::array<std::array<std::string_view, 2>, 9> kPairs = {{{"my", "bad"},
                                                                             {"i", "mean"},
                                                                             {"i", "meant"},
                                                                             {"my", "mistake"},
                                                                             {"my", "apologies"},
                                                                             {"excuse", "me"},
                                                                             {"hang", "on"},
                                                                             {"hold", "on"},
                                                                             {"oh", "no"}}};
  if (at >= words.size()) return at;
  for (const auto& pair : kPairs)
    if (at + 1 < words.size() && words[at] == pair[0] && words[at + 1] == pair[1]) return sure = true, at + 2;
  if (one_of(words[at], kAlways)) return sure = true, at + 1;
  if (one_of(words[at], kBeforeAPause)) {
    bool more = false;
    const bool fits = ends_part(words, at + 1) || interjection(words, at + 1, more) != at + 1 ||
                      words[at + 1] == "not" || (words[at] == "no" && one_of(words[at + 1], kArticles));
    if (fits) return sure = true, at + 1;
  }
  return one_of(words[at], kUnsure) ? at + 1 : at;
}

// "(hmm,) all three", "just one", "make it both": how many; `at` where it is none.
std::size_t quantity(const Sentence& words, std::size_t at, std::string& many) {
  if (at + 1 < words.size() && words[at] == "make" && (words[at + 1] == "it" || words[at + 1] == "that"))
    at += 2;
  std::size_t i = at;
  if (i < words.size() && (words[i] == "just" || words[i] == "only")) ++i;
  if (i >= words.size()) return at;
  const bool all = words[i] == "all" || words[i] == "both";
  if (!all && number_word(words[i]) == 0) return at;
  many = words[i++];
  if (all && i < words.size() && number_word(words[i]) > 0) ++i;
  if (i + 1 < words.size() && words[i] == "of" && words[i + 1] == "them") i += 2;
  return i;
}

class SlipMarker {
 public:
  SlipMarker(const Sentence& words, const Language& language) : words_(words), language_(language) {}

  Sentence mark() {
    Sentence marked;
    for (std::size_t at = 0; at < words_.size();) {
      const std::size_t next = slip(at, marked);
      if (next == at)
        marked.push_back(words_[at++]);
      else
        at = next;
    }
    return marked;
  }

 private:
  // Reads a slip behind the pause at `at`, writes what is meant; `at` where it is none.
  std::size_t slip(std::size_t at, Sentence& marked) const {
    if (at == 0 || !named_before(at)) return at;
    if (!ends_part(words_, at) && !(thing_begin(at) != at && hesitates(words_[at]))) return at;
    if (words_[at - 1] == "and" || words_[at - 1] == "or") return at;  // "the controller and, um, the chips"
    bool sure = false;
    std::size_t i = at;
    for (;;) {
      while (i < words_.size() && (words_[i] == "," || (words_[i] == "." && (i == at || sure)))) ++i;
      if (i + 1 < words_.size() && words_[i] == "or" && words_[i + 1] == "actually") ++i;
      const std::size_t next = interjection(words_, i, sure);
      if (next == i) break;
      i = next;
    }
    if (!sure) return at;
    Sentence meant = {",", "correction"};
    if (std::string many; counted_before(at)) {
      const std::size_t done = quantity(words_, i, many);
      if (done != i && tail(done)) {
        meant.push_back(many);
        marked.insert(marked.end(), meant.begin(), meant.end());
        return done;
      }
    }
    if (i < words_.size() && words_[i] == "and" && hesitates(words_[at + 1])) {
      marked.emplace_back(",");  // "the fork, the spoon, er, and the salt": the list only goes on
      return i;
    }
    bool that_one = true;
    while (i < words_.size() && words_[i] == "not") {
      const std::size_t denied = thing(i + 1);
      if (denied == i + 1 || denied >= words_.size() || words_[denied] != ",") return at;
      meant.insert(meant.end(), words_.begin() + static_cast<long>(i),
                   words_.begin() + static_cast<long>(denied) + 1);
      that_one = words_[denied - 1] == words_[at - 1];
      i = denied + 1;
      if (i < words_.size() && words_[i] == "but") ++i;
    }
    if (i + 1 < words_.size() && (words_[i] == "just" || words_[i] == "only")) ++i;  // "just burner one"
    if (that_one) {                                                                  // or nothing was denied
      if (const std::size_t done = in_its_place(at, i, marked); done != i) return done;
      if (const std::size_t done = list_again(at, i, marked); done != i) return done;
    }
    const std::size_t done = thing(i);
    if (done == i || !tail(done)) return at;
    meant.insert(meant.end(), words_.begin() + static_cast<long>(i),
                 words_.begin() + static_cast<long>(done));
    marked.insert(marked.end(), meant.begin(), meant.end());
    if (!ends_part(words_, done)) marked.emplace_back(",");
    return done;
  }

  // Where the thing or number begins that ends before `at`, with its article; `at` where there is none.
  std::size_t thing_begin(std::size_t at) const {
    std::size_t begin = at;
    bool named = false;
    while (begin > 0 && !ends_part(words_, begin - 1)) {
      const bool pair = begin > 1 && !ends_part(words_, begin - 2) && name(begin - 2) == 2;
      const bool one = name(begin - 1) > 0 || number_word(words_[begin - 1]) > 0;
      if (!pair && !one && !small(begin - 1)) break;
      named = named || pair || one;
      begin -= pair ? 2 : 1;
      if (one_of(words_[begin], kArticles)) break;
    }
    return named ? begin : at;
  }

  // "put the mug, sorry, the glass in the sink", "the salt and the fork, sorry, spoon": where the sentence
  // goes on behind it, or a list was before it, only the thing before the pause is replaced. `i` where it is
  // not so.
  std::size_t in_its_place(std::size_t at, std::size_t i, Sentence& marked) const {
    const std::size_t begin = thing_begin(at);
    if (begin == at || begin == 0 || place_preposition(words_[begin - 1])) return i;
    if (i < words_.size() && place_preposition(words_[i])) return i;
    const std::size_t done = thing(i, true);
    if (done == i) return i;
    const bool goes_on =
        goes_on_at(done) || (done + 1 < words_.size() && words_[done] == "," && goes_on_at(done + 1));
    const bool number = done == i + 1 && number_word(words_[i]) > 0;
    const bool listed = words_[begin - 1] == "and" && tail(done) && !number && !said_before(begin, done - 1);
    const std::size_t replaced = number ? 1 : at - begin;
    if ((!goes_on && !listed) || (number && number_word(words_[at - 1]) == 0) || marked.size() < replaced ||
        !std::equal(marked.end() - static_cast<long>(replaced), marked.end(),
                    words_.begin() + static_cast<long>(at - replaced)))
      return i;
    marked.resize(marked.size() - replaced);
    marked.insert(marked.end(), words_.begin() + static_cast<long>(i),
                  words_.begin() + static_cast<long>(done));
    return goes_on && words_[done] == "," ? done + 1 : done;
  }

  // "the fork and the plate, sorry, the fork and the bowl": a list that keeps something of the one before
  // stands for it. `i` where it is not so.
  std::size_t list_again(std::size_t at, std::size_t i, Sentence& marked) const {
    std::size_t done = thing(i), begin = thing_begin(at);
    if (done == i || begin == at || done >= words_.size() || words_[done] != "and") return i;
    bool kept = said_in(begin, at, words_[done - 1]);
    while (begin > 1 && words_[begin - 1] == "and" && thing_begin(begin - 1) != begin - 1) {
      const std::size_t earlier = thing_begin(begin - 1);
      kept = kept || said_in(earlier, begin, words_[done - 1]);
      begin = earlier;
    }
    while (done < words_.size() && words_[done] == "and" && thing(done + 1) != done + 1)
      done = thing(done + 1);
    const std::size_t replaced = at - begin;
    if (!kept || !tail(done) || place_preposition(words_[begin - 1]) || marked.size() < replaced ||
        !std::equal(marked.end() - static_cast<long>(replaced), marked.end(),
                    words_.begin() + static_cast<long>(begin)))
      return i;
    marked.resize(marked.size() - replaced);
    marked.insert(marked.end(), words_.begin() + static_cast<long>(i),
                  words_.begin() + static_cast<long>(done));
    return done;
  }

  bool said_in(std::size_t begin, std::size_t end, const std::string& word) const {
    return std::find(words_.begin() + static_cast<long>(begin), words_.begin() + static_cast<long>(end),
                     word) != words_.begin() + static_cast<long>(end);
  }

  bool goes_on_at(std::size_t i) const {
    return !ends_part(words_, i) &&
           (place_preposition(words_[i]) || one_of(words_[i], kParticles) || words_[i] == "with");
  }

  // Whether the word at `i` was said in the sentence that ends before `end`.
  bool said_before(std::size_t end, std::size_t i) const {
    for (std::size_t k = end; k-- > 0 && words_[k] != ".";)
      if (words_[k] == words_[i] && number_word(words_[k]) == 0) return true;
    return false;
  }

  static bool hesitates(const std::string& word) {
    static constexpr std::array kSounds = {"sorry"sv, "oops"sv, "whoops"sv, "hmm"sv, "hm"sv,
                                           "er"sv,    "erm"sv,  "uh"sv,     "um"sv};
    return one_of(word, kSounds);
  }

  bool small(std::size_t i) const {
    return one_of(words_[i], kArticles) || one_of(words_[i], kPointers) || ordinal_word(words_[i]) > 0 ||
           one_of(words_[i], kStates) || one_of(words_[i], kVague) || one_of(words_[i], kAll);
  }

  // How many words at `i` make a name; 0 for none.
  std::size_t name(std::size_t i) const {
    if (!ends_part(words_, i + 1) && language_.names_thing(words_[i] + " " + words_[i + 1])) return 2;
    const std::string one = singular(words_[i]);
    if (language_.names_thing(words_[i]) || language_.tv_word(one) || language_.names_place(one)) return 1;
    return language_.names_something(words_[i]) && language_.verb(words_[i]) == Frame::kNone ? 1 : 0;
  }

  bool named_before(std::size_t at) const {
    for (std::size_t i = 0; i < at; ++i)
      if (!ends_part(words_, i) && name(i) > 0) return true;
    return false;
  }

  // Whether the sentence before tells how many.
  bool counted_before(std::size_t at) const {
    for (std::size_t i = at; i-- > 0 && words_[i] != ".";)
      if (!ends_part(words_, i) && name(i) > 0)
        for (std::size_t k = i; k-- > 0 && i - k < 3 && !ends_part(words_, k);)
          if (number_word(words_[k]) > 0 || words_[k] == "both" || words_[k] == "all" || words_[k] == "a")
            return true;
    return false;
  }

  // A thing or a place and nothing else: "the fork", "burner four", "in the sink", "two", "the second".
  // `open`: the part may go on behind it.
  std::size_t thing(std::size_t at, bool open = false) const {
    std::size_t i = at;
    if (i < words_.size() && place_preposition(words_[i])) ++i;
    if (i + 1 < words_.size() && language_.verb(words_[i]) != Frame::kNone && !ends_part(words_, i + 1) &&
        name(i) == 0 && name(i + 1) == 0)
      return at;  // "sorry, water the plants"
    bool named = false;
    while (!ends_part(words_, i) && words_[i] != "and" && !is_tail(i)) {
      std::size_t length = name(i);
      if (length == 0 && number_word(words_[i]) > 0) length = 1;
      if (open && named && length == 0 && goes_on_at(i)) return i;
      if (i - at >= kLongestThing || (length == 0 && !small(i) && words_[i] != "of")) return at;
      named = named || length > 0 || (i > at && ordinal_word(words_[i]) > 0);
      i += std::max<std::size_t>(length, 1);
    }
    return named ? i : at;
  }

  bool is_tail(std::size_t i) const {
    static constexpr std::array kTails = {"please"sv, "instead"sv, "sorry"sv, "thanks"sv,
                                          "then"sv,   "rather"sv,  "pls"sv};
    if (one_of(words_[i], kTails)) return true;
    return words_[i] == "i" && i + 1 < words_.size() && (words_[i + 1] == "mean" || words_[i + 1] == "meant");
  }

  // Whether no list goes on at `at`: "sorry, the fork and the plate" may be all that is wanted.
  bool tail(std::size_t at) const {
    std::size_t i = at;
    while (i < words_.size() && (words_[i] == "," || words_[i] == "and" || words_[i] == "then")) ++i;
    if (i >= words_.size() || words_[i] == "." || is_tail(i)) return true;
    bool more = false;
    if (interjection(words_, i, more) != i) return true;
    return thing(i) == i;
  }

  const Sentence& words_;
  const Language& language_;
};

}  // namespace

void mark_slips(std::vector<std::string>& words, const Language& language) {
  words = SlipMarker(words, language).mark();
}

}  // namespace goalnet::inference
