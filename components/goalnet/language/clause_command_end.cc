// What a command means once all of it is read: the state that is wanted, what was said before it.
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"

namespace goalnet::inference {

std::size_t ClauseParser::end_command(Clause clause, std::size_t i, std::size_t end) {
  if (!clause.state.empty() && language_.wanted_by_state(clause.state) != Frame::kNone &&
      clause.mood != Mood::kStatement) {
    // "do not leave the tap on" wants it off
    if (clause.mood == Mood::kForbidden) {
      if (const std::string opposite = language_.opposite_state(clause.state); !opposite.empty())
        clause.state = opposite, clause.mood = Mood::kCommand;
    }
    clause.frame = language_.wanted_by_state(clause.state);
    clause.verb = clause.state;
  }
  // "do not leave the controller lying on the couch": take it from there
  if (const NounPhrase* left = clause.first(Role::kDirect);
      language_.hears_people() && clause.mood == Mood::kForbidden && clause.verb == "leave" &&
      left != nullptr && clause.state.empty() &&
      (clause.first(Role::kDestination) != nullptr || !left->at.empty())) {
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.role = Role::kSource;
    clause.mood = Mood::kCommand, clause.frame = Frame::kTake, clause.verb = "take";
  }
  // "take a cup to the sink, then take the other one too"
  if (language_.hears_people() && !clause.words.empty() && clause.words.back() == "too" &&
      clause.mood == Mood::kCommand && clause.first(Role::kDestination) == nullptr &&
      clause.first(Role::kDirect) != nullptr && !result_.clauses.empty() &&
      (clause.frame == Frame::kTake || clause.frame == Frame::kBring || clause.frame == Frame::kPlace)) {
    const Clause& before = result_.clauses.back();
    const NounPhrase* there = before.mood == Mood::kCommand ? before.first(Role::kDestination) : nullptr;
    const bool same =
        clause.verb == before.verb || clause.verb == "take" || clause.verb == "put" || clause.verb == "move";
    if (same && there != nullptr)
      clause.phrases.push_back(*there), clause.frame = before.frame, clause.verb = before.verb;
  }
  // "get the salt. ... Get the fork instead.": not both
  if (language_.hears_people() && clause.has("instead") && clause.mood == Mood::kCommand) {
    const auto before = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                     [](const Clause& c) { return c.mood == Mood::kCommand && !c.weak; });
    if (before != result_.clauses.rend() && before->frame == clause.frame &&
        (clause.frame == Frame::kTake || clause.frame == Frame::kBring))
      before->mood = Mood::kStatement, before->frame = Frame::kNone, before->wish = false;
  }
  behind_what_was_taken(clause);
  // "make the tap off", "make the sound away"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      language_.hears_people() && clause.frame == Frame::kMake && thing != nullptr) {
    const bool off = clause.has_particle("off") || clause.has_particle("out") || clause.has_particle("away");
    if (off) clause.frame = language_.tv_word(thing->phrase) ? Frame::kMute : Frame::kStop;
    if (clause.has_particle("on")) clause.frame = Frame::kStart;
  }
  if (language_.hears_people() && clause.frame == Frame::kStart && clause.has_particle("under_tap"))
    clause.frame = Frame::kWash;  // "run the mug under the tap"
  // "the news is on channel 1, put it on"
  if (Clause* told = result_.clauses.empty() ? nullptr : &result_.clauses.back();
      told != nullptr && (told->mood == Mood::kStatement || told->mood == Mood::kQuestion) &&
      told->frame == Frame::kChange && clause.has_particle("on") && clause.first(Role::kDirect) != nullptr) {
    const NounPhrase& thing = *clause.first(Role::kDirect);
    if (thing.pronoun || (language_.hears_people() && lexicon_->is_name_of(thing.phrase, "tv")))
      told->asked = told->wish = true, told->mood = Mood::kStatement;
    if (thing.pronoun) return i;
  }
  // "it goes on the shelf, put it back": there, wherever it stood
  const auto last_asked = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                       [](const Clause& c) { return c.mood == Mood::kCommand; });
  const bool belongs = language_.hears_people() ? last_asked != result_.clauses.rend() && last_asked->belongs
                                                : !result_.clauses.empty() && result_.clauses.back().belongs;
  if (belongs && (clause.has_particle("back") || (language_.hears_people() && !clause.to_person)) &&
      (clause.frame == Frame::kPlace || (language_.hears_people() && clause.frame == Frame::kBring)) &&
      clause.phrases.size() == 1 && clause.phrases.front().pronoun && clause.mood == Mood::kCommand)
    return i;
  if (clause.frame == Frame::kChange)  // "I wonder what is on channel two, switch over"
    for (Clause& told : result_.clauses)
      if (told.mood == Mood::kStatement && told.frame == Frame::kChange && told.wish &&
          std::none_of(clause.phrases.begin(), clause.phrases.end(),
                       [](const NounPhrase& phrase) { return phrase.number > 0 || phrase.ordinal > 0; })) {
        told.asked = true;
        return i;
      }
  // "I'm cold, shut... never mind. Bring me a pillow."
  if (clause.phrases.empty() && clause.particles.empty() && i >= end && end + 1 < words_.size() &&
      (clause.frame == Frame::kClose || clause.frame == Frame::kOpen || clause.frame == Frame::kPlace ||
       clause.frame == Frame::kTake || clause.frame == Frame::kBring))
    clause.weak = true;
  // "let us tidy up, the beer goes on the counter"
  if (language_.hears_people() && clause.verb == "tidy" && clause.phrases.empty() &&
      (i >= end || words_[i] == ","))
    clause.weak = true;
  // "I need a break, turn on the tv"
  if (clause.wish && (i >= end || words_[i] == ","))
    clause.weak =
        clause.weak || std::any_of(clause.phrases.begin(), clause.phrases.end(),
                                   [](const NounPhrase& phrase) { return phrase.unknown || phrase.bare(); });
  add(std::move(clause));
  return i;
}

// "take the drink from the fridge and put on counter": a place to put it, no thing.
void ClauseParser::behind_what_was_taken(Clause& clause) const {
  if (!language_.hears_people() || clause.mood != Mood::kCommand || clause.frame != Frame::kPlace ||
      clause.phrases.empty() || result_.clauses.empty())
    return;
  const Clause& before = result_.clauses.back();
  const NounPhrase* taken = before.first(Role::kDirect);
  if (before.mood != Mood::kCommand || taken == nullptr || taken->unknown || taken->person) return;
  if (before.frame != Frame::kTake && before.frame != Frame::kBring) return;
  NounPhrase& place = clause.phrases.front();
  if (clause.phrases.size() == 1 && place.role == Role::kDirect && !clause.particles.empty() &&
      (clause.particles.front() == "on" || clause.particles.front() == "in") &&
      lexicon_->is_place_name(place.phrase) && !language_.tv_word(place.phrase)) {
    place.role = Role::kDestination;
    place.where = clause.particles.front() == "on" ? Where::kOn : Where::kIn;
    clause.particles.clear();
  }
  const NounPhrase* there = clause.first(Role::kDestination);
  if (there == nullptr || !lexicon_->is_place_name(there->phrase) || clause.first(Role::kDirect) != nullptr)
    return;
  const bool several =
      taken->plural || taken->count > 1 || taken->all ||
      std::count_if(before.phrases.begin(), before.phrases.end(),
                    [](const NounPhrase& phrase) { return phrase.role == Role::kDirect; }) > 1;
  NounPhrase it;
  it.pronoun = true, it.plural = several, it.word = several ? "them" : "it";
  clause.phrases.insert(clause.phrases.begin(), std::move(it));
}

}  // namespace goalnet::inference
