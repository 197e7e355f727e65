// What was said before a command and is part of it: a place, a channel, what it stands in for.
#include <algorithm>

#include "components/goalnet/language/clause_command_end.h"

namespace goalnet::inference {

// "take a cup to the sink, then take the other one too"
void ClauseParser::CommandEnd::there_too() {
  const Frame frame = clause_.frame;
  if (!people() || clause_.words.empty() || clause_.words.back() != "too" || clause_.mood != Mood::kCommand ||
      clause_.first(Role::kDestination) != nullptr || clause_.first(Role::kDirect) == nullptr ||
      !after_command() || (frame != Frame::kTake && frame != Frame::kBring && frame != Frame::kPlace))
    return;
  const Clause& before = result_.clauses.back();
  const NounPhrase* there = before.first(Role::kDestination);
  const bool same = clause_.verb == before.verb || clause_.verb == "take" || clause_.verb == "put" ||
                    clause_.verb == "move";
  if (same && there != nullptr)
    clause_.phrases.push_back(*there), clause_.frame = before.frame, clause_.verb = before.verb;
}

// "get the salt. ... Get the fork instead.": not both
void ClauseParser::CommandEnd::instead_of_before() {
  if (!people() || !clause_.has("instead") || clause_.mood != Mood::kCommand) return;
  const auto before = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                   [](const Clause& c) { return c.mood == Mood::kCommand && !c.weak; });
  if (before != result_.clauses.rend() && before->frame == clause_.frame &&
      (clause_.frame == Frame::kTake || clause_.frame == Frame::kBring))
    before->mood = Mood::kStatement, before->frame = Frame::kNone, before->wish = false;
}

// Whether `clause_` leaves what was asked for; "books on the shelf, but leave book two": asked for but that.
bool ClauseParser::CommandEnd::taken_back(NounPhrase& asked) const {
  const NounPhrase& left = *clause_.first(Role::kDirect);
  return asked.role == Role::kDirect && asked.phrase == left.phrase && asked.number == left.number &&
         asked.ordinal == left.ordinal && asked.plural == left.plural && asked.at.empty() && left.at.empty();
}

// "book one to the shelf, and book two, no, leave book two": what is to be left is asked for no longer
bool ClauseParser::CommandEnd::left_after_all() {
  const NounPhrase* left = clause_.first(Role::kDirect);
  if (!people() || clause_.verb != "leave" || clause_.mood != Mood::kCommand || left == nullptr ||
      clause_.phrases.size() != 1 || left->phrase.empty() || (left->number == 0 && left->ordinal == 0) ||
      !clause_.particles.empty() || clause_.to_person)
    return false;
  bool taken = false;
  for (Clause& before : result_.clauses) {
    const bool carries = before.frame == Frame::kPlace || before.frame == Frame::kTake ||
                         before.frame == Frame::kBring || before.frame == Frame::kDiscard;
    if (before.mood != Mood::kCommand || !carries) continue;
    if (std::erase_if(before.phrases, [&](NounPhrase& asked) { return taken_back(asked); }) > 0) {
      taken = true;
      if (before.first(Role::kDirect) == nullptr) before.mood = Mood::kStatement, before.frame = Frame::kNone;
      continue;
    }
    const NounPhrase* asked = before.first(Role::kDirect);
    if (asked == nullptr || asked->phrase != left->phrase || !asked->plural || left->plural) continue;
    before.phrases.push_back(*left);
    before.phrases.back().role = Role::kExcept;
    taken = true;
  }
  return taken;
}

// "take the drink from the fridge and put on counter": a place to put it, no thing.
void ClauseParser::CommandEnd::behind_what_was_taken() {
  if (!people() || clause_.mood != Mood::kCommand || clause_.frame != Frame::kPlace ||
      clause_.phrases.empty() || !after_command())
    return;
  const Clause& before = result_.clauses.back();
  const NounPhrase* taken = before.first(Role::kDirect);
  if (taken == nullptr || taken->unknown || taken->person) return;
  if (before.frame != Frame::kTake && before.frame != Frame::kBring) return;
  NounPhrase& place = clause_.phrases.front();
  if (clause_.phrases.size() == 1 && place.role == Role::kDirect && !clause_.particles.empty() &&
      (clause_.particles.front() == "on" || clause_.particles.front() == "in") &&
      lexicon_.is_place_name(place.phrase) && !language_.tv_word(place.phrase)) {
    place.role = Role::kDestination;
    place.where = clause_.particles.front() == "on" ? Where::kOn : Where::kIn;
    clause_.particles.clear();
  }
  const NounPhrase* there = clause_.first(Role::kDestination);
  if (there == nullptr || !lexicon_.is_place_name(there->phrase) || clause_.first(Role::kDirect) != nullptr)
    return;
  const bool several =
      taken->plural || taken->count > 1 || taken->all ||
      std::count_if(before.phrases.begin(), before.phrases.end(),
                    [](const NounPhrase& phrase) { return phrase.role == Role::kDirect; }) > 1;
  NounPhrase it;
  it.pronoun = true, it.plural = several, it.word = several ? "them" : "it";
  clause_.phrases.insert(clause_.phrases.begin(), std::move(it));
}

// "the news is on channel 1, put it on"
bool ClauseParser::CommandEnd::on_what_channel() {
  const NounPhrase* thing = clause_.first(Role::kDirect);
  if (result_.clauses.empty() || thing == nullptr || !clause_.has_particle("on")) return false;
  Clause& told = result_.clauses.back();
  if ((told.mood != Mood::kStatement && told.mood != Mood::kQuestion) || told.frame != Frame::kChange)
    return false;
  if (thing->pronoun || (people() && lexicon_.is_name_of(thing->phrase, "tv")))
    told.asked = told.wish = true, told.mood = Mood::kStatement;
  return thing->pronoun;
}

// "it goes on the shelf, put it back": there, wherever it stood
bool ClauseParser::CommandEnd::back_where_it_belongs() {
  const auto last_asked = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                       [](const Clause& c) { return c.mood == Mood::kCommand; });
  const bool belongs = people() ? last_asked != result_.clauses.rend() && last_asked->belongs
                                : !result_.clauses.empty() && result_.clauses.back().belongs;
  return belongs && (clause_.has_particle("back") || (people() && !clause_.to_person)) &&
         (clause_.frame == Frame::kPlace || (people() && clause_.frame == Frame::kBring)) &&
         clause_.phrases.size() == 1 && clause_.phrases.front().pronoun && clause_.mood == Mood::kCommand;
}

// "I wonder what is on channel two, switch over"
bool ClauseParser::CommandEnd::channel_wondered_about() {
  if (clause_.frame != Frame::kChange ||
      std::any_of(clause_.phrases.begin(), clause_.phrases.end(),
                  [](const NounPhrase& phrase) { return phrase.number > 0 || phrase.ordinal > 0; }))
    return false;
  for (Clause& told : result_.clauses)
    if (told.mood == Mood::kStatement && told.frame == Frame::kChange && told.wish) {
      told.asked = true;
      return true;
    }
  return false;
}

}  // namespace goalnet::inference
