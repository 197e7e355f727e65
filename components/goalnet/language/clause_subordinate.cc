// "before you open the fridge, ...", "because I am thirsty".
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;
using std::string_view_literals::operator""sv;

// "once it has been filled with water, put it on the stove": to be done first, where nobody asked for it
// before; `at` where it is none.
std::size_t ClauseParser::done_first(std::size_t at, std::size_t end) {
  static constexpr std::array kBeen = {"is"sv, "are"sv, "has"sv, "have"sv, "been"sv, "all"sv, "both"sv};
  if (!language_.hears_people()) return at;
  NounPhrase thing;
  const std::size_t named = reader_.read(at + 1, end, thing);
  std::size_t verb = named;
  while (verb < end && one_of(words_[verb], kBeen)) ++verb;
  if (named == at + 1 || verb == named || verb >= end || thing.person || thing.unknown ||
      !language_.participle(words_[verb]))
    return at;
  if ((words_[verb - 1] == "has" || words_[verb - 1] == "have")) return at;  // "once it has boiled"
  const Frame frame = language_.verb(words_[verb]);
  if (frame != Frame::kFill && frame != Frame::kWash && frame != Frame::kEmpty && frame != Frame::kHeat &&
      frame != Frame::kOpen && frame != Frame::kClose)
    return at;
  for (const Clause& before : result_.clauses)
    if (before.mood == Mood::kCommand && before.frame == frame) return at;
  Clause clause;
  clause.frame = frame, clause.verb = language_.verb_base(words_[verb]), clause.words = {clause.verb};
  thing.role = Role::kDirect;
  clause.phrases = {std::move(thing)};
  Role role = Role::kDirect;
  Where where = Where::kTo;
  std::size_t i = verb + 1;
  while (i < end && !language_.joins(words_[i]) && !opens_command(i, end)) {
    clause.words.push_back(words_[i]);
    const std::size_t next = argument(i, end, clause, role, where);
    if (next == i) break;
    i = next;
  }
  const bool leading =
      at == 0 || words_[at - 1] == "." || words_[at - 1] == "," || language_.joins(words_[at - 1]);
  if (!leading && !result_.clauses.empty()) insert_before_ = result_.clauses.size() - 1;
  add(std::move(clause));
  return i;
}

std::size_t ClauseParser::subordinate(std::size_t at, std::size_t end) {
  const std::string& word = words_[at];
  const std::size_t count = result_.clauses.size();
  if ((word == "if" || word == "unless") && at + 1 < end)
    if (const std::size_t stop = condition(at, end); stop != at) return stop;
  if (word == "otherwise")
    if (const std::size_t next = otherwise(at, end); next != at) return next;
  // "if you are not busy", "when you have time", "if I may"
  static constexpr std::array kPolite = {"can"sv,  "could"sv,  "would"sv, "will"sv, "are"sv,    "have"sv,
                                         "get"sv,  "want"sv,   "like"sv,  "feel"sv, "happen"sv, "do"sv,
                                         "mind"sv, "please"sv, "need"sv,  "may"sv};
  if ((word == "if" || word == "when" || word == "whenever") && at + 2 < end &&
      (words_[at + 1] == "you" || words_[at + 1] == "i" || words_[at + 1] == "nobody") &&
      one_of(words_[at + 2], kPolite)) {
    const std::size_t stop = part_end(at, end);
    std::size_t verb = at + 3;  // "if you can open the fridge": the verb counts
    while (verb < stop && !opens_command(verb, stop)) ++verb;
    if (verb >= stop) return stop;
  }
  if (word == "if" || word == "unless" || word == "whenever") {
    if (result_.problem.empty())
      result_.problem = "conditions (\"" + word + " ...\") are not understood; say what to do now";
    return skip_part(at, end);
  }
  if (const std::size_t done = before_that(at, end); done != at) return done;
  if (word == "before" || word == "after" || word == "once" || word == "when") {
    // "after that run", "before the match"
    if (language_.hears_people() && at + 2 < end &&
        (one_of(words_[at + 1], kArticles) || one_of(words_[at + 1], kPointers)) &&
        language_.verb(words_[at + 2]) != Frame::kNone && (at + 3 == end || words_[at + 3] == ","))
      return at + 3;
    std::size_t verb = at + 1;
    while (verb < end && !opens_command(verb, end) &&
           (harmless(verb) || words_[verb] == "you" || words_[verb] == "have"))
      ++verb;
    // "before it melts", "after dinner": says when, asks for nothing
    const bool finite =
        at + 1 < end && words_[at + 1] != "you" &&
        (one_of(words_[at + 1], kSubjects) || !language_.participle(words_[verb < end ? verb : at]));
    const bool asks_for_it = verb < end && opens_command(verb, end) && !(finite && verb > at + 1);
    if (asks_for_it) {
      const bool leading =
          count == 0 || at == 0 || words_[at - 1] == "." || words_[at - 1] == "," || words_[at - 1] == "then";
      if (word == "before" && leading) {
        const std::size_t done = command(verb, end, Mood::kCommand);
        if (result_.clauses.size() > count) insert_before_ = count;
        return done;
      }
      // "fill the kettle and after you put it on the stove": afterwards
      const bool afterwards = language_.hears_people() && word == "after" && at > 0 &&
                              words_[at - 1] == "and" && skip_part(at, end) == end;
      if (word != "before" && !leading && !afterwards) insert_before_ = count - 1;  // "A after B": B first
      return command(verb, end, Mood::kCommand);
    }
    if (word == "before" || word == "after") return verb >= end ? verb : part_end(at, end);
    if (const std::size_t stop = done_first(at, end); stop != at) return stop;
    if (verb >= end || words_[verb] == ",") return verb;  // "and after that, ..."
    // "once the mug is full, ...", "when it is done": what was asked before is done by then
    return skip_part(at, end);
  }
  if (word == "as" && at + 1 < end && (words_[at + 1] == "well" || words_[at + 1] == "soon")) return at + 2;
  // until it is hot; because I am thirsty; so that I can sit down; where it belongs; while you are there
  std::size_t next = at + 1;
  const bool reason = word == "since" || word == "because" || word == "while";
  const auto command_begins = [&](std::size_t i) {
    return reason && i > at + 2 && opens_command(i, end) &&
           (reader_.starts(i + 1, end) || (i + 1 < end && one_of(words_[i + 1], kParticles))) &&
           words_[i - 1] != "to" && words_[i - 1] != "i" && words_[i - 1] != "you" &&
           words_[i - 1] != "can" && words_[i - 1] != "not";
  };
  const auto tells_on = [&](std::size_t i) {  // "so I was going to cook but there is stuff on the stove"
    return words_[i] == "but" && i + 2 < end && words_[i + 1] == "there" && language_.copula(words_[i + 2]);
  };
  while (next < end && words_[next] != "," && !command_begins(next) && !tells_on(next) &&
         !(words_[next] == "and" && opens_command(skip_joins(next, end), end)))
    ++next;
  if ((reason || word == "where") && language_.hears_people() && next > at + 1)
    add_told(at + 1, next);  // "it" may mean what is spoken of
  return next;
}

}  // namespace goalnet::inference
