// What only is told of: what "it", "them" and "there" may stand for from here on.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

void FrameActions::notice(const Clause& clause) {
  Objects together;  // "the coke, the beer and the chips: all on the table"
  int told = 0;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role == Role::kDestination && !phrase.pronoun && !phrase.bare() && !phrase.unknown)
      if (const Objects there = resolver_.chosen(phrase, resolver_.options(phrase, Sort::kAny, now_));
          !there.empty()) {
        last_destination_ = {there.front()};
        history_.insert(history_.begin(), {there.front()});
      }
    if (at_home_ && phrase.role == Role::kDirect && phrase.pronoun)  // "my soup is cold, it is in the bowl"
      for (const NounPhrase& place : phrase.at)
        if (!place.pronoun && !place.bare() && !place.unknown)
          if (const Objects there = resolver_.options(place, Sort::kVessel, now_); !there.empty())
            history_.push_back({there.front()});
    if (phrase.role != Role::kDirect || phrase.pronoun || phrase.bare() || phrase.unknown) continue;
    // what stands where the sentence says counts, not everything of that name
    NounPhrase located = phrase;
    if (at_home_ && clause.mood == Mood::kStatement && clause.frame == Frame::kPlace && phrase.at.empty())
      for (const NounPhrase& place : clause.phrases)  // "I have put one plate in the microwave": that one
        if (place.role == Role::kDestination && !place.pronoun && !place.bare() && !place.unknown)
          located.at.push_back(place);
    Objects objects = resolver_.options(located, Sort::kAny, now_);
    if (at_home_ && located.ordinal > 0) objects = resolver_.chosen(located, objects);
    if (at_home_ && !clause.negative)  // "one of the burners is on": the one that is
      std::stable_partition(objects.begin(), objects.end(),
                            [&](Symbol object) { return is_so(object, clause.state).value_or(true); });
    if (!phrase.everything && !phrase.plural && !phrase.all && objects.size() > 1)
      objects.erase(objects.begin() + 1, objects.end());
    if (!objects.empty()) history_.push_back(objects), ++told;
    // "one plate is in the microwave, put the other one there": not that one, and there
    if (at_home_ && clause.mood == Mood::kStatement && located.at.size() == 1 &&
        !located.at.front().negated) {
      resolver_.remember(objects);
      if (const NounPhrase& place = located.at.front(); !place.pronoun && !place.bare() && !place.unknown)
        if (const Objects there = resolver_.options(place, Sort::kPlace, now_); !there.empty()) {
          const Symbol stands = objects.empty() ? Symbol{kNone} : resolver_.place_of(objects.front(), now_);
          last_destination_ = {contains(there, stands) ? stands : there.front()};
        }
    }
    together.insert(together.end(), objects.begin(), objects.end());
    if (at_home_)
      for (const NounPhrase& place : phrase.at)
        if (!place.pronoun && !place.bare() && !place.unknown && !place.negated)
          if (const Objects there = resolver_.options(place, Sort::kPlace, now_); there.size() == 1)
            history_.insert(history_.begin(), there);
    const bool content =
        language_.content(phrase.phrase) != kNone &&
        (at_home_ ? !objects.empty() && !resolver_.class_of(objects.front())->drink : !phrase.at.empty());
    content_told_ = content ? phrase.phrase : std::string();
    if (phrase.everything) mass_ = objects;
    // "there is stuff on that burner, clear everything from there"
    if (phrase.everything && phrase.at.size() == 1 && !phrase.at.front().pronoun && !phrase.at.front().bare())
      if (const Objects there =
              resolver_.chosen(phrase.at.front(), resolver_.options(phrase.at.front(), Sort::kPlace, now_));
          !there.empty())
        last_destination_ = {there.front()};
    // "there is an armchair without a pillow, put one there"
    if (!objects.empty() && resolver_.class_of(objects.front())->place &&
        !resolver_.class_of(objects.front())->movable)
      last_destination_ = {objects.front()};
  }
  // "fork. spoon. salt. bring them": all that was named
  const bool only_named = at_home_ && clause.phrases.size() == 1 && clause.state.empty() && told == 1 &&
                          clause.frame == Frame::kNone && clause.phrases.front().at.empty() &&
                          !clause.phrases.front().everything;
  if (!only_named) named_.clear();
  if (only_named) named_.insert(named_.begin(), together.begin(), together.end());  // the newest is "it"
  if (named_.size() > 1) history_.push_back(named_);
  if (told > 1) history_.push_back(together);
}

}  // namespace goalnet::inference
