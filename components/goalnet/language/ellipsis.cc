#include "components/goalnet/language/ellipsis.h"

#include <algorithm>
#include <array>

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

  // A part of the sentence and the one behind it.
  struct Pair {
    const std::vector<Span>& spans;
    std::size_t at;
    bool sentence_start, ends;  // whether another begins behind them
    const Span& one() const { return spans[at]; }
    const Span& two() const { return spans[at + 1]; }
  };
  using Rule = bool (Filler::*)(const PartReader&, const Pair&);

  // Fills in what is left out in one place; false where nothing is.
  bool change() {
    static constexpr std::array<Rule, 9> kRules = {
        &Filler::thing_and_place, &Filler::shared_out,      &Filler::temperature,
        &Filler::verb_and_thing,  &Filler::list_for_all,    &Filler::those_listed,
        &Filler::thing_and_verb,  &Filler::switched_device, &Filler::place_of_what_is_told};
    const PartReader reader(words_, language_, lexicon_);
    const std::vector<Span> spans = reader.spans();
    bool own = true;  // nothing before in this sentence could be the verb of what follows
    for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
      const bool sentence_start = spans[i].begin == 0 || words_.text[spans[i].begin - 1] == ".";
      own = sentence_start || (own && i > 0 && spans[i - 1].part != Part::kOther);
      if (!own) continue;
      const bool ends = i + 2 >= spans.size() || words_.text[spans[i + 1].end] == "." ||
                        spans[i + 2].part == Part::kThings || spans[i + 2].part == Part::kOther;
      const Pair pair{spans, i, sentence_start, ends};
      if (std::ranges::any_of(kRules, [&](Rule rule) { return (this->*rule)(reader, pair); })) return true;
    }
    return both_behind_a_list();
  }

  bool pause(const Span& part, const char* mark) const { return words_.text[part.end] == mark; }
  bool is_verb(std::size_t at) const { return language_.verb(words_.text[at]) != Frame::kNone; }

  // "fork. sink."
  bool thing_and_place(const PartReader&, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if (one.part != Part::kThings || two.part != Part::kPlace || !pair.ends) return false;
    erase(one.end);
    if (!two.with_preposition) insert(two.content - 1, {"to"});
    return true;
  }

  bool shared_out(const PartReader& reader, const Pair& pair) {
    return pair.one().part == Part::kThings && pair.two().part == Part::kCountAtPlace &&
           share_out(reader, pair.spans, pair.at);
  }

  // "need coffee. hot.", "coffee, hot, please"
  bool temperature(const PartReader&, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if (one.part != Part::kThings || two.end != two.content + 1 ||
        !one_of(words_.text[two.content], kTemperatures))
      return false;
    const std::string word = words_.text[two.content];
    erase(two.content);
    erase(one.end);
    insert(one.content, {word});
    return true;
  }

  // "fetch! the fork!"
  bool verb_and_thing(const PartReader&, const Pair& pair) {
    const Span& one = pair.one();
    if (one.part != Part::kVerb || pair.two().part != Part::kThings || !pause(one, ".") ||
        one.end != one.content + 1)
      return false;
    erase(one.end);
    return true;
  }

  // "egg, fork. bring both."
  bool list_for_all(const PartReader&, const Pair& pair) {
    const Span& one = pair.one();
    if (one.part != Part::kThings || pair.two().part != Part::kThings || !pair.sentence_start ||
        !pause(one, ",") || !lists_for_all(pair.spans, pair.at + 1))
      return false;
    words_.text[one.end] = "and";
    return true;
  }

  // "egg and fork. bring both.": those that were listed
  bool those_listed(const PartReader& reader, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if (one.part != Part::kThings || !pair.sentence_start || two.content + 1 >= two.end ||
        !is_verb(two.content) || !one_of(words_.text[two.content + 1], kAllOfThem))
      return false;
    const std::vector<std::string> things(words_.text.begin() + static_cast<long>(one.content),
                                          words_.text.begin() + static_cast<long>(one.end));
    const std::size_t behind = two.content + 2;
    if (std::ranges::find(things, "and") == things.end() ||
        !(behind == two.end || reader.harmless(behind) || one_of(words_.text[behind], kParticles) ||
          place_preposition(words_.text[behind])))
      return false;
    erase(two.content + 1);
    insert(two.content + 1, things);
    for (std::size_t k = one.content; k <= one.end; ++k) erase(one.content);
    return true;
  }

  // "the fork. give.", "desk, go"
  bool thing_and_verb(const PartReader&, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if ((one.part != Part::kThings && one.part != Part::kPlace) || one.with_preposition ||
        two.part != Part::kVerb || !(pause(one, ".") || two.end == two.content + 1))
      return false;
    const std::string verb = words_.text[two.content];
    erase(two.content);
    erase(one.end);
    insert(one.content, {verb});
    return true;
  }

  // "tap running. off."
  bool switched_device(const PartReader& reader, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if (!pair.sentence_start || !reader.only_switches(two) || !pause(one, ".") || !pair.ends) return false;
    const std::size_t device_end = reader.told_device(one);
    if (device_end == one.content) return false;
    const std::string way = words_.text[two.content];
    erase(two.content);
    for (std::size_t k = device_end; k <= one.end; ++k) erase(device_end);
    insert(one.content, {"turn", way});
    return true;
  }

  // "The plate does not belong on the shelf. Counter, please.", "The ice cream is melting! Back in the
  // freezer!"
  bool place_of_what_is_told(const PartReader& reader, const Pair& pair) {
    const Span &one = pair.one(), &two = pair.two();
    if (!pair.sentence_start || one.part != Part::kOther || two.part != Part::kPlace || !pause(one, ".") ||
        is_verb(one.content < one.end ? one.content : one.begin) || words_.text[one.begin] == "wish" ||
        !(reader.tells(one) || language_.asks(words_.text[one.begin])))
      return false;
    const bool many =
        std::any_of(words_.plural.begin() + static_cast<long>(one.begin),
                    words_.plural.begin() + static_cast<long>(one.end), [](bool plural) { return plural; });
    std::vector<std::string> put_it = {"put", many ? "them" : "it"};
    if (!two.with_preposition) put_it.emplace_back("to");
    insert(two.content, put_it);
    return true;
  }

  // "the fork and the spoon both in the sink"
  bool both_behind_a_list() {
    for (std::size_t i = 2; i + 1 < words_.text.size(); ++i) {
      const std::string& before = words_.text[i - 2];
      if ((words_.text[i] == "both" || words_.text[i] == "all") && place_preposition(words_.text[i + 1]) &&
          words_.text[i + 1] != "to" && lexicon_.is_name(words_.text[i - 1]) &&
          (language_.joins(before) || one_of(before, kArticles) || lexicon_.is_name(before))) {
        erase(i);
        return true;
      }
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
