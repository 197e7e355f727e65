#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::add(const Clause& clause) {
  if (!clause.unknown.empty()) return language_.unknown_word(clause.unknown.front());
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.unknown) return unknown_name(phrase.word);
  Problem problem;
  if (const bool asked = wanted(clause, problem); !asked || !problem.empty()) return problem;
  const SymState before = now_;
  const std::size_t count = macros_.size();
  named_.clear();
  problem = dispatch(clause);
  if (!problem.empty()) {
    now_ = before;
    macros_.resize(count);
    steps_.resize(count);
  }
  return problem;
}

// "warm up whatever is in the mug": the mug.
Clause FrameActions::what_holds_it(const Clause& said) {
  Clause clause = said;
  for (NounPhrase& phrase : clause.phrases) {
    if (!at_home_ || phrase.role != Role::kDirect || !phrase.everything || phrase.at.size() != 1) continue;
    const NounPhrase& in = phrase.at.front();
    if (in.pronoun || in.bare() || in.negated || resolver_.options(in, Sort::kVessel, now_).empty()) continue;
    phrase = NounPhrase(in);
    phrase.role = Role::kDirect;
  }
  return clause;
}

std::string FrameActions::dispatch(const Clause& clause) {
  if (const NounPhrase* channel = at_home_ ? channel_of_television(clause) : nullptr; channel != nullptr)
    return change_channel(*channel);
  struct Meaning {
    Frame frame;
    Problem (FrameActions::*read)(const Clause&);
  };
  static constexpr Meaning kMeanings[] = {
      {Frame::kGo, &FrameActions::go},
      {Frame::kTake, &FrameActions::take},
      {Frame::kDiscard, &FrameActions::discard},
      {Frame::kFill, &FrameActions::fill},
      {Frame::kPour, &FrameActions::pour},
      {Frame::kEmpty, &FrameActions::empty},
      {Frame::kWash, &FrameActions::wash},
      {Frame::kAdd, &FrameActions::add_to},
      {Frame::kSqueeze, &FrameActions::add_to},
      {Frame::kScoop, &FrameActions::scoop},
      {Frame::kInsert, &FrameActions::insert},
      {Frame::kRelease, &FrameActions::release},
      {Frame::kChange, &FrameActions::television},
      {Frame::kMute, &FrameActions::television},
      {Frame::kRaise, &FrameActions::raise},
      {Frame::kLower, &FrameActions::television},
      {Frame::kMake, &FrameActions::make},
      {Frame::kSwap, &FrameActions::swap},
      {Frame::kClear, &FrameActions::clear},
      {Frame::kCool, &FrameActions::cool},
      {Frame::kPlay, &FrameActions::play},
      {Frame::kTry, &FrameActions::try_to_go},
  };
  for (const Meaning& meaning : kMeanings)
    if (meaning.frame == clause.frame) return (this->*meaning.read)(clause);
  switch (clause.frame) {
    case Frame::kPlace:
    case Frame::kBring:
      close_tap();  // "fill one cup and put the other one in the sink": that one is not to be filled
      return put(clause);
    case Frame::kTurn:
      return turn(clause, -1);
    case Frame::kStart:
      return turn(clause, 1);
    case Frame::kStop:
      return turn(clause, 0);
    case Frame::kOpen:
      return door(clause, true);
    case Frame::kClose:
      return door(clause, false);
    case Frame::kHeat:
      return heat(what_holds_it(clause), false);
    case Frame::kBoil:
      return heat(what_holds_it(clause), true);
    default:
      return "there is no verb that a robot could act on";
  }
}

std::optional<std::string> FrameActions::first_that_fits(std::span<const Reading> readings,
                                                         const Clause& clause) {
  for (const Reading reading : readings)
    if (auto read = (this->*reading)(clause)) return read;
  return std::nullopt;
}

// "I want the tv on channel 4"
std::string FrameActions::change_channel(const NounPhrase& channel) {
  Clause change;
  change.frame = Frame::kChange, change.verb = "change";
  change.phrases = {channel};
  change.phrases.front().role = Role::kDirect;
  return television(change);
}

// "raise the book" lifts it, "make the book louder" means nothing
std::string FrameActions::raise(const Clause& clause) {
  return !about_television(clause) && language_.wanted_by_state(clause.verb) == Frame::kNone
             ? take(clause)
             : television(clause);
}

// "proceed to the armchair"
std::string FrameActions::try_to_go(const Clause& clause) {
  if (at_home_ && clause.first(Role::kDestination) != nullptr && clause.first(Role::kDirect) == nullptr)
    return go(clause);
  return "there is no verb that a robot could act on";
}

}  // namespace goalnet::inference
