#include "components/goalnet/language/frame_actions.h"

#include <algorithm>

#include "components/goalnet/language/home_rules.h"

namespace goalnet::inference {

using namespace symbol;

// Nobody leaves the tap running behind a vessel that is full. While more is done at the sink it may run.
void FrameActions::close_tap() {
  if (!tap_fills_) return;
  tap_fills_ = false;
  if (closes_tap_ && now_.is(kSinkKnob, kTapIsOn)) act({Verb::kTurn, kSinkKnob});
}

std::string FrameActions::act(const SymAction& macro) {
  if (macro.x != kSinkKnob && macro.y != kSink) close_tap();
  const auto run = with_means(macro, now_);
  if (run.empty()) return "that cannot be done from here";
  SymDelta step;
  std::vector<Symbol> handled = {macro.x, macro.y};
  for (const SymAction& other : macros_) handled.push_back(other.x);
  std::erase_if(handled, [&](Symbol object) { return !resolver_.is_vessel(object); });
  for (const SymAction& action : run) {
    if (action == macro) step = purpose(action, now_, handled);
    apply_at_home(action, now_);
  }
  keep_held(step);
  macros_.push_back(macro);
  steps_.push_back(std::move(step));
  return {};
}

// What somebody wants held must still be so when the next thing is done: a planner may put it down to free a
// hand.
void FrameActions::keep_held(SymDelta& step) const {
  constexpr std::size_t kMostHeld = 6;  // two hands and the tray
  if (!at_home_ || step.empty() || taken_.size() > kMostHeld) return;
  for (const Symbol object : taken_)
    if (now_.holds(object)) step.added.push_back(sym_fact(Relation::kGrasping, kRobot, object));
  std::sort(step.added.begin(), step.added.end());
  step.added.erase(std::unique(step.added.begin(), step.added.end()), step.added.end());
}

std::string FrameActions::keep(Symbol x, Symbol y, Where where) {
  if (x == y) return "a thing cannot be put on itself";
  const bool box = y == kMicrowave || y == kFridge || y == kGarbageBin_1 || y == kGarbageBag_1 ||
                   y == kFridgeLeft || y == kFridgeRight;
  if (resolver_.is_of_class(x, "cd") && resolver_.is_of_class(y, "xbox")) {
    if (now_.has(Relation::kIn, x, y)) return {};
    return act({Verb::kInsert, x, y});
  }
  if (y == kMicrowave && where == Where::kOn) return "nothing can be put on top of the microwave";
  if (y == kFridge && where == Where::kOn) return "nothing can be put on top of the fridge";
  const ObjectClass* c = resolver_.class_of(y);
  const bool container = c != nullptr && (c->vessel || c->dish);
  if (container && (where == Where::kIn || !c->dish || c->name == "bowl")) {
    if (x == kRamen_1 || x == kBoiledEgg_1 || x == kSalt_1) {
      if (x != kSalt_1 && now_.has(Relation::kIn, x, y)) return {};
      return act({Verb::kAdd, x, y});
    }
    if (x == kSpoon_1 || x == kFork_1)
      return now_.has(Relation::kIn, x, y) ? Problem{} : act({Verb::kPlace, x, y});
  }
  if (at_home_ && resolver_.is_vessel(y) && where != Where::kNear)
    return "it is not known how " + resolver_.name(x) + " could be put into or onto " + resolver_.name(y);
  const Verb verb =
      box || (where == Where::kIn && container && c->name != "plate") ? Verb::kKeepIn : Verb::kKeepOn;
  if (now_.has(verb == Verb::kKeepIn ? Relation::kIn : Relation::kOn, x, y)) return {};
  return act({verb, x, y});
}

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
  if (const NounPhrase* channel = at_home_ ? channel_of_television(clause) : nullptr; channel != nullptr) {
    Clause change;
    change.frame = Frame::kChange, change.verb = "change";
    change.phrases = {*channel};
    change.phrases.front().role = Role::kDirect;
    return television(change);
  }
  switch (clause.frame) {
    case Frame::kGo:
      return go(clause);
    case Frame::kTake:
      return take(clause);
    case Frame::kPlace:
    case Frame::kBring:
      close_tap();  // "fill one cup and put the other one in the sink": that one is not to be filled
      return put(clause);
    case Frame::kDiscard:
      return discard(clause);
    case Frame::kFill:
      return fill(clause);
    case Frame::kPour:
      return pour(clause);
    case Frame::kEmpty:
      return empty(clause);
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
    case Frame::kWash:
      return wash(clause);
    case Frame::kHeat:
      return heat(what_holds_it(clause), false);
    case Frame::kBoil:
      return heat(what_holds_it(clause), true);
    case Frame::kAdd:
    case Frame::kSqueeze:
      return add_to(clause);
    case Frame::kScoop:
      return scoop(clause);
    case Frame::kInsert:
      return insert(clause);
    case Frame::kRelease:
      return release(clause);
    case Frame::kChange:
    case Frame::kMute:
    case Frame::kRaise:
    case Frame::kLower:
      // "raise the book" lifts it, "make the book louder" means nothing
      return clause.frame == Frame::kRaise && !about_television(clause) &&
                     language_.wanted_by_state(clause.verb) == Frame::kNone
                 ? take(clause)
                 : television(clause);
    case Frame::kMake:
      return make(clause);
    case Frame::kSwap:
      return swap(clause);
    case Frame::kClear:
      return clear(clause);
    case Frame::kCool:
      return cool(clause);
    case Frame::kPlay:
      return play(clause);
    case Frame::kTry:
      if (at_home_ && clause.first(Role::kDestination) != nullptr && clause.first(Role::kDirect) == nullptr)
        return go(clause);  // "proceed to the armchair"
      break;
    case Frame::kNone:
      break;
  }
  return "there is no verb that a robot could act on";
}

}  // namespace goalnet::inference
