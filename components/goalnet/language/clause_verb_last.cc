// Verbs at the end: "the tv turn on please", "the mug bring me".
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "the tv turn on please", "the mug bring me": the thing before its verb.
std::size_t ClauseParser::verb_last(std::size_t at, std::size_t end) {
  NounPhrase thing, place;
  std::size_t i = reader_.read(at, end, thing);
  if (i == at || thing.person || thing.unknown) return at;
  thing.role = Role::kDirect;
  std::vector<NounPhrase> phrases = {thing};
  for (NounPhrase from; language_.hears_people() && i < end && words_[i] == "from"; from = {}) {
    const std::size_t done =
        reader_.read(i + 1, end, from, true);  // "pillows from all armchairs you must bring ..."
    if (done == i + 1 || from.person || from.unknown) break;
    phrases.front().at.push_back(from);
    i = done;
  }
  for (std::size_t done; (done = reader_.read_place(i, end, place)) != i && !place.person; place = {}) {
    place.role = Role::kDestination;
    phrases.push_back(place);
    i = done;
  }
  static constexpr std::array kMay = {"can"sv, "could"sv, "may"sv, "should"sv, "might"sv, "must"sv};
  if (language_.hears_people() && i + 2 < end && words_[i] == "you" && one_of(words_[i + 1], kMay))
    i += 2;  // "the other one you can bring over to me"
  if (!opens_command(i, end) || language_.wanted_by_state(words_[i]) != Frame::kNone ||
      language_.participle(words_[i]))
    return at;
  if (language_.hears_people() && language_.verb(words_[i]) == Frame::kPlace && phrases.size() == 1 &&
      ends_here(i + 1, end))
    return at;  // "the right one sticks"
  // "the water pour into the bowl": a place may follow
  static constexpr std::array kMovesTo = {"pour"sv, "bring"sv, "put"sv, "move"sv, "carry"sv, "add"sv};
  std::size_t from = i + 1;
  if (NounPhrase to; language_.hears_people() && one_of(words_[i], kMovesTo) && phrases.size() == 1)
    if (const std::size_t done = reader_.read_place(from, end, to);
        done != from && !to.pronoun && ends_here(done, end))
      from = done;
  for (std::size_t k = from; k < end && words_[k] != ","; ++k) {
    NounPhrase more;
    if (reader_.read(k, end, more) != k && !more.person) return at;
    if (NounPhrase to;
        language_.hears_people() && words_[k] == "to" && reader_.read(k + 1, end, to) != k + 1 && to.person)
      continue;
    if (!harmless(k) && !one_of(words_[k], kParticles) && !more.person) return at;
  }
  fronted_ = phrases;
  return command(i, end, Mood::kCommand);
}

}  // namespace goalnet::inference
