// What a command means once all of it is read: the state that is wanted, how earnest it is.
#include "components/goalnet/language/clause_command_end.h"

#include <algorithm>

namespace goalnet::inference {

std::size_t ClauseParser::end_command(Clause clause, std::size_t i, std::size_t end) {
  CommandEnd(*this, std::move(clause), i, end).add();
  return i;
}

void ClauseParser::CommandEnd::add() {
  wanted_state();
  not_left_lying();
  there_too();
  instead_of_before();
  behind_what_was_taken();
  make_on_or_off();
  under_tap();
  // these were asked for already
  if (on_what_channel() || back_where_it_belongs() || channel_wondered_about() || left_after_all()) return;
  only_perhaps();
  parser_.add(std::move(clause_));
}

// "leave the door open" opens it; "do not leave the tap on" wants it off
void ClauseParser::CommandEnd::wanted_state() {
  if (clause_.state.empty() || language_.wanted_by_state(clause_.state) == Frame::kNone ||
      clause_.mood == Mood::kStatement)
    return;
  if (clause_.mood == Mood::kForbidden)
    if (const std::string opposite = language_.opposite_state(clause_.state); !opposite.empty())
      clause_.state = opposite, clause_.mood = Mood::kCommand;
  clause_.frame = language_.wanted_by_state(clause_.state);
  clause_.verb = clause_.state;
}

// "do not leave the controller lying on the couch": take it from there
void ClauseParser::CommandEnd::not_left_lying() {
  const NounPhrase* left = clause_.first(Role::kDirect);
  if (!people() || clause_.mood != Mood::kForbidden || clause_.verb != "leave" || left == nullptr ||
      !clause_.state.empty() || (clause_.first(Role::kDestination) == nullptr && left->at.empty()))
    return;
  for (NounPhrase& phrase : clause_.phrases)
    if (phrase.role == Role::kDestination) phrase.role = Role::kSource;
  clause_.mood = Mood::kCommand, clause_.frame = Frame::kTake, clause_.verb = "take";
}

// "make the tap off", "make the sound away"
void ClauseParser::CommandEnd::make_on_or_off() {
  const NounPhrase* thing = clause_.first(Role::kDirect);
  if (!people() || clause_.frame != Frame::kMake || thing == nullptr) return;
  const bool off = clause_.has_particle("off") || clause_.has_particle("out") || clause_.has_particle("away");
  if (off) clause_.frame = language_.tv_word(thing->phrase) ? Frame::kMute : Frame::kStop;
  if (clause_.has_particle("on")) clause_.frame = Frame::kStart;
}

// "run the mug under the tap"
void ClauseParser::CommandEnd::under_tap() {
  if (people() && clause_.frame == Frame::kStart && clause_.has_particle("under_tap"))
    clause_.frame = Frame::kWash;
}

// What counts only where nothing else is asked for.
void ClauseParser::CommandEnd::only_perhaps() {
  const Frame frame = clause_.frame;
  // "I'm cold, shut... never mind. Bring me a pillow."
  if (clause_.phrases.empty() && clause_.particles.empty() && at_ >= end_ && end_ + 1 < words_.size() &&
      (frame == Frame::kClose || frame == Frame::kOpen || frame == Frame::kPlace || frame == Frame::kTake ||
       frame == Frame::kBring))
    clause_.weak = true;
  // "let us tidy up, the beer goes on the counter"
  if (people() && clause_.verb == "tidy" && clause_.phrases.empty() && ends_part()) clause_.weak = true;
  // "I need a break, turn on the tv"
  if (clause_.wish && ends_part())
    clause_.weak =
        clause_.weak || std::any_of(clause_.phrases.begin(), clause_.phrases.end(),
                                    [](const NounPhrase& phrase) { return phrase.unknown || phrase.bare(); });
}

}  // namespace goalnet::inference
