// What a message that the grammar does not read is most likely about.
#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "components/goalnet/gist/wording.h"
#include "components/goalnet/language/left_unused.h"
#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

// Less likely guesses are not worth a question; likelier ones overrule a reading by which nothing is to be
// done, and are done unasked, where nothing in the message speaks against it (docs/design/052).
constexpr double kAsks = 0.3, kOverrules = 0.5, kDoes = 0.8;
constexpr std::size_t kMostRequests = 4;
constexpr std::size_t kMostNamed = 16;  // each with each other: bounds the time

// "not", "if", "other": what it is about need not be what it asks for.
bool is_plain(const std::vector<std::string>& words) {
  using std::string_view_literals::operator""sv;
  static constexpr std::array kDepends = {"if"sv,    "otherwise"sv, "unless"sv,  "else"sv, "when"sv,
                                          "until"sv, "other"sv,     "another"sv, "rest"sv};
  return std::none_of(words.begin(), words.end(),
                      [&](const std::string& word) { return turns_round(word) || one_of(word, kDepends); });
}

bool names_something_here(const gist::Message& message, std::size_t word) {
  return std::ranges::any_of(message.named,
                             [&](const gist::Named& name) { return name.begin <= word && word < name.end; });
}

bool is_article(const std::string& word) { return one_of(word, word_group::kArticles); }

}  // namespace

std::optional<RobotLanguage::Guess> RobotLanguage::guess(const std::vector<std::string>& tokens,
                                                         const Reading& refused,
                                                         const std::vector<std::string>& objects,
                                                         const SymState& start, const Distances* distances) {
  const Understanding& why = refused.understanding;
  if (why.only_forbids || why.for_later || why.contradicted)
    return {};  // it was read, and nothing is to be done
  const Sight sight = see(tokens, objects, start);
  for (const gist::View& view : sight.views)
    if (view.message.named.size() > kMostNamed) return {};
  const gist::Likely likely = gist_.likely(sight.views);
  if (likely.probability < kAsks || likely.requests.size() > kMostRequests) return {};
  Guess guess;
  guess.sentence = gist::in_words(sight.views, likely.requests, *language_);
  guess.probability = likely.probability;
  const auto words = tokenize(guess.sentence, Endings::kKept);
  if (!words) return {};
  guess.reading = read(*words, objects, start, distances);
  if (!guess.reading.understanding.complete || guess.reading.understanding.macros.empty()) return {};
  const bool plain = is_plain(tokens);
  guess.overrules = likely.probability >= kOverrules && plain;
  guess.sure = likely.probability >= kDoes && plain &&
               may_be_done_unasked(sight.views.front().message, likely, refused);
  return guess;
}

// Not where the grammar knows why the message asks for nothing that can be done, nor where part of the
// message plays no role in the guess.
bool RobotLanguage::may_be_done_unasked(const gist::Message& message, const gist::Likely& likely,
                                        const Reading& refused) const {
  const Understanding& why = refused.understanding;
  if (refused.beyond_robot || why.only_asks || why.question || why.no_such_number) return false;
  for (std::size_t i = 0; i < message.spoken.size(); ++i) {
    const std::string& word = message.spoken[i];
    const std::string& sort = message.sorts[i];
    const bool unknown = sort == "strange" || sort == "word" || sort.starts_with("kind");
    const bool elsewhere = (sort == "thing" || sort == "place") && !names_something_here(message, i);
    if (elsewhere) return false;
    if (unknown && !language_->describes(word) && !language_->english_verb(word) && !language_->adverb(word))
      return false;
  }
  return uses_all(message, likely);
}

// Whether each thing plays a role and is named once, and each place that is not only where something comes
// from.
bool RobotLanguage::uses_all(const gist::Message& message, const gist::Likely& likely) const {
  using std::string_view_literals::operator""sv;
  static constexpr std::array kFrom = {"from"sv, "off"sv, "of"sv, "near"sv, "beside"sv};
  std::set<std::size_t> used;
  for (const gist::Request& request : likely.requests) {
    if (request.view != 0) return false;  // it names what was not said so
    for (const int index : {request.thing, request.other})
      if (index >= 0) used.insert(static_cast<std::size_t>(index));
  }
  std::set<ClassId> things;
  for (std::size_t i = 0; i < message.named.size(); ++i) {
    const gist::Named& named = message.named[i];
    if (named.classes.empty()) continue;
    const bool thing = lexicon_->object_class(named.classes.front()).movable;
    if (thing && (!used.contains(i) || !things.insert(named.classes.front()).second)) return false;
    std::size_t before = named.begin;
    while (before > 0 && is_article(message.spoken[before - 1])) --before;
    if (!thing && !used.contains(i) && (before == 0 || !one_of(message.spoken[before - 1], kFrom)))
      return false;
  }
  return true;
}

}  // namespace goalnet::inference
