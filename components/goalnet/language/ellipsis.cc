#include "components/goalnet/language/ellipsis.h"

#include <algorithm>

#include "components/goalnet/language/ellipsis_parts.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::array kTemperatures = {"hot"sv, "warm"sv};
constexpr std::array kAllOfThem = {"both"sv, "all"sv, "them"sv};

class Filler {
 public:
  Filler(Words words, const Language& language, const Lexicon& lexicon)
      : words_(std::move(words)), language_(language), lexicon_(lexicon) {}

  Words fill() {
    // Each change makes the parts anew; a sentence has few.
    for (int changes = 0; changes < kMostChanges && change(); ++changes) {
    }
    return std::move(words_);
  }

 private:
  static constexpr int kMostChanges = 20;

  void erase(std::size_t at) {
    words_.text.erase(words_.text.begin() + static_cast<long>(at));
    words_.plural.erase(words_.plural.begin() + static_cast<long>(at));
  }
  void insert(std::size_t at, const std::vector<std::string>& text) {
    words_.text.insert(words_.text.begin() + static_cast<long>(at), text.begin(), text.end());
    words_.plural.insert(words_.plural.begin() + static_cast<long>(at), text.size(), false);
  }

  // "three waters: one in the glass, two in the long cups": each part gets the thing, what is shared out
  // before them goes.
  bool share_out(const PartReader& reader, const std::vector<Span>& spans, std::size_t first) {
    const Span& one = spans[first];
    std::size_t from = one.content, to = one.end;
    while (from + 1 < to && (number_word(words_.text[from]) > 0 || one_of(words_.text[from], kDeterminers)))
      ++from;
    while (to > from + 1 && reader.harmless(to - 1)) --to;
    const std::vector<std::string> thing(words_.text.begin() + static_cast<long>(from),
                                         words_.text.begin() + static_cast<long>(to));
    constexpr std::size_t kLongestThing = 6;  // words
    if (thing.size() > kLongestThing) return false;
    std::size_t last = first + 1;
    while (last + 1 < spans.size() && spans[last + 1].part == Part::kCountAtPlace) ++last;
    NounPhrase shared;
    reader.phrases().read(from, to, shared);
    const bool content = language_.content(shared.phrase) != symbol::kNone;
    const bool moved = !shared.scoop && !content, drink = content && !shared.scoop && to == from + 1;
    for (std::size_t k = last; k > first; --k) {
      const std::size_t number = spans[k].content;
      if (one_of(words_.text[number + 1], kDesire)) erase(number + 1);
      std::vector<std::string> again = thing;
      if (moved && k > first + 1) again.insert(again.begin(), "other");
      // "two in the long cups": in two of them
      const bool vessels = drink && number_word(words_.text[number]) > 1;
      if (vessels) {
        const std::size_t in = number + 2;
        if (!one_of(words_.text[in], kArticles))
          insert(in, {words_.text[number]});
        else
          insert(in + 1, {words_.text[number]});
        erase(number);
        insert(number, again);
      } else {
        insert(number + 1, again);
      }
      insert(number, {"put"});
    }
    for (std::size_t k = one.content; k <= one.end; ++k) erase(one.content);
    return true;
  }

  // Whether the things listed up to a full stop are what the sentence behind calls "both", "all", "them".
  bool lists_for_all(const std::vector<Span>& spans, std::size_t from) const {
    std::size_t last = from;
    while (last + 1 < spans.size() && spans[last + 1].part == Part::kThings &&
           words_.text[spans[last].end] == ",")
      ++last;
    if (last + 1 >= spans.size() || words_.text[spans[last].end] != ".") return false;
    const Span& order = spans[last + 1];
    return order.content + 1 < order.end && language_.verb(words_.text[order.content]) != Frame::kNone &&
           one_of(words_.text[order.content + 1], kAllOfThem);
  }

  bool change() {
    const PartReader reader(words_, language_, lexicon_);
    const std::vector<Span> spans = reader.spans();
    bool own = true;  // nothing before in this sentence could be the verb of what follows
    for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
      const Span &one = spans[i], &two = spans[i + 1];
      const bool sentence_start = one.begin == 0 || words_.text[one.begin - 1] == ".";
      own = sentence_start || (own && i > 0 && spans[i - 1].part != Part::kOther);
      const bool last = i + 2 >= spans.size();
      const bool pair_ends = last || words_.text[two.end] == "." || spans[i + 2].part == Part::kThings ||
                             spans[i + 2].part == Part::kOther;
      if (!own) continue;
      if (one.part == Part::kThings && two.part == Part::kPlace && pair_ends) {
        erase(one.end);  // the pause
        if (!two.with_preposition) insert(two.content - 1, {"to"});
        return true;
      }
      if (one.part == Part::kThings && two.part == Part::kCountAtPlace) {
        if (share_out(reader, spans, i)) return true;
      }
      // "need coffee. hot.", "coffee, hot, please"
      if (one.part == Part::kThings && two.content < two.end &&
          one_of(words_.text[two.content], kTemperatures) && two.end == two.content + 1) {
        const std::string word = words_.text[two.content];
        erase(two.content);
        erase(one.end);
        insert(one.content, {word});
        return true;
      }
      // "fetch! the fork!"
      if (one.part == Part::kVerb && two.part == Part::kThings && words_.text[one.end] == "." &&
          one.end == one.content + 1) {
        erase(one.end);
        return true;
      }
      // "egg, fork. bring both."
      if (one.part == Part::kThings && two.part == Part::kThings && sentence_start &&
          words_.text[one.end] == "," && lists_for_all(spans, i + 1)) {
        words_.text[one.end] = "and";
        return true;
      }
      // "egg and fork. bring both.": those that were listed
      if (one.part == Part::kThings && sentence_start && two.content + 1 < two.end &&
          language_.verb(words_.text[two.content]) != Frame::kNone &&
          one_of(words_.text[two.content + 1], kAllOfThem) &&
          std::count(words_.text.begin() + static_cast<long>(one.content),
                     words_.text.begin() + static_cast<long>(one.end), "and") > 0 &&
          (two.content + 2 == two.end || reader.harmless(two.content + 2) ||
           one_of(words_.text[two.content + 2], kParticles) ||
           place_preposition(words_.text[two.content + 2]))) {
        const std::vector<std::string> things(words_.text.begin() + static_cast<long>(one.content),
                                              words_.text.begin() + static_cast<long>(one.end));
        erase(two.content + 1);
        insert(two.content + 1, things);
        for (std::size_t k = one.content; k <= one.end; ++k) erase(one.content);
        return true;
      }
      // "the fork. give.", "desk, go"
      if ((one.part == Part::kThings || one.part == Part::kPlace) && !one.with_preposition &&
          two.part == Part::kVerb && (words_.text[one.end] == "." || two.end == two.content + 1)) {
        const std::string verb = words_.text[two.content];
        erase(two.content);
        erase(one.end);
        insert(one.content, {verb});
        return true;
      }
      // "tap running. off."
      if (sentence_start && reader.only_switches(two) && words_.text[one.end] == "." && pair_ends) {
        if (const std::size_t device_end = reader.told_device(one); device_end != one.content) {
          const std::string way = words_.text[two.content];
          erase(two.content);
          for (std::size_t k = device_end; k <= one.end; ++k) erase(device_end);
          insert(one.content, {"turn", way});
          return true;
        }
      }
      // "The plate does not belong on the shelf. Counter, please.", "The ice cream is melting! Back in the
      // freezer!"
      if (sentence_start && one.part == Part::kOther && two.part == Part::kPlace &&
          words_.text[one.end] == "." &&
          language_.verb(words_.text[one.content < one.end ? one.content : one.begin]) == Frame::kNone &&
          words_.text[one.begin] != "wish" && (reader.tells(one) || language_.asks(words_.text[one.begin]))) {
        const bool many = std::any_of(words_.plural.begin() + static_cast<long>(one.begin),
                                      words_.plural.begin() + static_cast<long>(one.end),
                                      [](bool plural) { return plural; });
        std::vector<std::string> put_it = {"put", many ? "them" : "it"};
        if (!two.with_preposition) put_it.emplace_back("to");
        insert(two.content, put_it);
        return true;
      }
    }
    // "the fork and the spoon both in the sink"
    for (std::size_t i = 1; i + 1 < words_.text.size(); ++i)
      if ((words_.text[i] == "both" || words_.text[i] == "all") && place_preposition(words_.text[i + 1]) &&
          words_.text[i + 1] != "to" && lexicon_.is_name(words_.text[i - 1]) && i > 1 &&
          (language_.joins(words_.text[i - 2]) || one_of(words_.text[i - 2], kArticles) ||
           lexicon_.is_name(words_.text[i - 2]))) {
        erase(i);
        return true;
      }
    return false;
  }

  Words words_;
  const Language& language_;
  const Lexicon& lexicon_;
};

}  // namespace

Words fill_ellipses(const Words& words, const Language& language, const Lexicon& lexicon) {
  return Filler(words, language, lexicon).fill();
}

}  // namespace goalnet::inference
