// Where a thing is thought to be that was asked for before: "pass me the coke? It should be in the fridge".
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

namespace {

bool says_where_from(const Clause& clause) {
  return std::any_of(clause.phrases.begin(), clause.phrases.end(), [](const NounPhrase& phrase) {
    return phrase.role == Role::kSource || (phrase.role == Role::kDirect && !phrase.at.empty());
  });
}

}  // namespace

void FrameActions::believe_places(std::vector<Clause>& clauses) {
  for (std::size_t i = 1; i < clauses.size(); ++i) {
    Clause& told = clauses[i];
    const NounPhrase* what = told.first(Role::kDirect);
    const NounPhrase* place = told.first(Role::kDestination);
    // "there should be one on the shelf"
    const bool there_is = told.mood == Mood::kStatement && !told.negative;
    if (there_is && told.frame == Frame::kNone && what != nullptr && what->at.size() == 1)
      place = &what->at.front();
    const bool puts = told.frame == Frame::kPlace && told.belongs && told.phrases.size() == 2;
    if (!told.supposed || !told.condition.empty() || what == nullptr || place == nullptr || place->pronoun ||
        place->bare() || !(there_is || (puts && told.mood == Mood::kCommand)))
      continue;
    std::size_t before = i;
    while (before > 0 && clauses[before - 1].mood != Mood::kCommand) --before;
    if (before == 0) continue;
    Clause& asked = clauses[before - 1];
    NounPhrase* thing = nullptr;
    for (NounPhrase& phrase : asked.phrases)
      if (phrase.role == Role::kDirect && thing == nullptr) thing = &phrase;
    if (thing == nullptr || thing->everything || !asked.condition.empty()) continue;
    const bool same = what->pronoun || (what->phrase == thing->phrase && (what->definite || there_is));
    if (!same || says_where_from(asked)) continue;  // "take it off the shelf, it should be on the table"
    NounPhrase there = thing->pronoun ? *what : *thing;
    there.at = {*place};
    const auto named = there.pronoun ? Objects{} : resolver_.named(there);
    const bool is_there = std::any_of(named.begin(), named.end(), [&](Symbol object) {
      return resolver_.is_where_said(object, there, start_);
    });
    // What somebody wants to have is not put elsewhere, even where it is not thought to be.
    const bool given = asked.to_person && (asked.frame == Frame::kTake || asked.frame == Frame::kBring);
    if (!is_there && !given) continue;
    const bool several = thing->plural || thing->all || thing->count > 1;
    if (is_there && !several) thing->at.push_back(*place);  // of several books that one
    told.mood = Mood::kStatement, told.frame = Frame::kNone;
    told.belongs = told.wish = false, told.verb.clear();
    told.phrases = {std::move(there)};
    told.phrases.front().role = Role::kDirect;
  }
}

}  // namespace goalnet::inference
