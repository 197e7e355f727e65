#include "components/goalnet/language/slips.h"

#include <algorithm>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/slip_words.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using Sentence = std::vector<std::string>;

class SlipMarker : SlipWords {
 public:
  using SlipWords::SlipWords;

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
    std::size_t i = behind_interjections(at, sure);
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

  // "..., hmm, sorry, or actually"
  std::size_t behind_interjections(std::size_t at, bool& sure) const {
    std::size_t i = at;
    for (;;) {
      while (i < words_.size() && (words_[i] == "," || (words_[i] == "." && (i == at || sure)))) ++i;
      if (i + 1 < words_.size() && words_[i] == "or" && words_[i + 1] == "actually") ++i;
      const std::size_t next = interjection(words_, i, sure);
      if (next == i) return i;
      i = next;
    }
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
    if (!kept || !tail(done) || (begin > 0 && place_preposition(words_[begin - 1])) ||
        marked.size() < replaced ||
        !std::equal(marked.end() - static_cast<long>(replaced), marked.end(),
                    words_.begin() + static_cast<long>(begin)))
      return i;
    marked.resize(marked.size() - replaced);
    marked.insert(marked.end(), words_.begin() + static_cast<long>(i),
                  words_.begin() + static_cast<long>(done));
    return done;
  }
};

}  // namespace

void mark_slips(std::vector<std::string>& words, const Language& language) {
  words = SlipMarker(words, language).mark();
}

}  // namespace goalnet::inference
