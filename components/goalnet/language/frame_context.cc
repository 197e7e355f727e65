// What is to be done, and what becomes of the world by it.
#include "components/goalnet/language/frame_context.h"

#include <algorithm>

#include "components/goalnet/language/home_rules.h"

namespace goalnet::inference {

using namespace symbol;

// Nobody leaves the tap running behind a vessel that is full. While more is done at the sink it may run.
void FrameContext::close_tap() {
  if (!tap_fills_) return;
  tap_fills_ = false;
  if (closes_tap_ && now_.is(kSinkKnob, kTapIsOn)) act({Verb::kTurn, kSinkKnob});
}

std::string FrameContext::act(const SymAction& macro) {
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
void FrameContext::keep_held(SymDelta& step) const {
  constexpr std::size_t kMostHeld = 6;  // two hands and the tray
  if (!at_home_ || step.empty() || taken_.size() > kMostHeld) return;
  for (const Symbol object : taken_)
    if (now_.holds(object)) step.added.push_back(sym_fact(Relation::kGrasping, kRobot, object));
  std::sort(step.added.begin(), step.added.end());
  step.added.erase(std::unique(step.added.begin(), step.added.end()), step.added.end());
}

std::string FrameContext::keep(Symbol x, Symbol y, Where where) {
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

}  // namespace goalnet::inference
