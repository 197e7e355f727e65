#include "components/goalnet/language/frame_actions.h"

#include <algorithm>

namespace goalnet::inference {
namespace {

using namespace symbol;

}  // namespace

const NounPhrase* FrameActions::first(const Clause& clause, Role role) const {
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == role) return &phrase;
  return nullptr;
}

std::string FrameActions::unknown_thing(const NounPhrase& phrase) const {
  if (phrase.pronoun) return "it is not clear what \"it\" means here";
  std::string nearest;
  for (const Symbol object : resolver_.all(Sort::kMovable, now_))
    if (nearest.empty()) nearest = resolver_.name(object);
  return "there is no " + phrase.phrase + " here that this could be done with" +
         (nearest.empty() ? "" : "; things that could be moved are, for example, " + nearest);
}

std::vector<Symbol> FrameActions::of_role(const Clause& clause, Role role, Sort sort, Problem& problem) {
  const NounPhrase* source = first(clause, Role::kSource);
  std::vector<Symbol> objects;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != role) continue;
    std::vector<Symbol> chosen;
    if (phrase.pronoun) {
      chosen = last_;
      if (chosen.empty())
        for (const SymFact fact : now_.facts())
          if (relation_of(fact) == Relation::kGrasping) chosen.push_back(object_of(fact));
      if (!phrase.plural && chosen.size() > 1) chosen.erase(chosen.begin() + 1, chosen.end());
    } else {
      chosen = resolver_.chosen(
          phrase, resolver_.options(phrase, sort, now_, role == Role::kDirect ? source : nullptr));
    }
    if (chosen.empty() && problem.empty()) problem = unknown_thing(phrase);
    for (const Symbol object : chosen)
      if (std::find(objects.begin(), objects.end(), object) == objects.end()) objects.push_back(object);
  }
  return objects;
}

std::vector<Symbol> FrameActions::direct(const Clause& clause, Sort sort, Problem& problem) {
  std::vector<Symbol> objects = of_role(clause, Role::kDirect, sort, problem);
  if (objects.empty() && problem.empty()) problem = "it is not clear what to " + clause.verb;
  if (problem.empty()) last_ = objects;
  return objects;
}

Symbol FrameActions::place(const Clause& clause, Problem& problem) {
  const NounPhrase* phrase = first(clause, Role::kDestination);
  if (phrase == nullptr || phrase->pronoun) return kNone;
  auto options = resolver_.options(*phrase, Sort::kPlace, now_);
  if (phrase->ordinal > 0) options = resolver_.chosen(*phrase, options);
  if (options.empty()) {
    if (problem.empty()) problem = "there is no place called " + phrase->phrase + " here";
    return kNone;
  }
  // Of several equal places the free one: a burner with nothing on it, an empty seat.
  for (const Symbol option : options) {
    if (!resolver_.is_of_class(option, "burner")) break;
    const bool taken = std::any_of(now_.facts().begin(), now_.facts().end(), [&](SymFact fact) {
      return relation_of(fact) == Relation::kOn && object_of(fact) == option;
    });
    if (!taken) return option;
  }
  return options.front();
}

Symbol FrameActions::mentioned_content(const Clause& clause, Role role) const {
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == role)
      if (const Symbol content = language_.content(phrase.phrase); content != kNone) return content;
  return kNone;
}

Symbol FrameActions::vessel_with(Symbol content) const {
  Symbol best = kNone;
  for (const Symbol vessel : resolver_.all(Sort::kVessel, now_)) {
    if (!now_.is(vessel, content)) continue;
    if (best == kNone || now_.holds(vessel)) best = vessel;
  }
  return best;
}

Symbol FrameActions::burner_for(Symbol object) const {
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (now_.has(Relation::kOn, object, burner)) return burner;
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner) {
    if (resolver_.instruction().find(burner) < 0) continue;
    const bool taken = std::any_of(now_.facts().begin(), now_.facts().end(), [&](SymFact fact) {
      return relation_of(fact) == Relation::kOn && object_of(fact) == burner;
    });
    if (!taken) return burner;
  }
  return resolver_.instruction().find(kStoveFire_1) >= 0 ? Symbol{kStoveFire_1} : Symbol{kNone};
}

std::string FrameActions::act(const SymAction& macro) {
  const auto run = with_means(macro, now_);
  if (run.empty()) return "that cannot be done from here";
  for (const SymAction& action : run) apply(action, now_);
  macros_.push_back(macro);
  return {};
}

std::string FrameActions::keep(Symbol x, Symbol y, bool inside) {
  const ObjectClass* c = resolver_.class_of(y);
  if (x == y) return "a thing cannot be put on itself";
  const bool box = y == kMicrowave || y == kFridge || y == kGarbageBin_1 || y == kGarbageBag_1;
  if (resolver_.is_of_class(x, "cd") && resolver_.is_of_class(y, "xbox")) return act({Verb::kInsert, x, y});
  if (inside && c != nullptr && (c->vessel || c->dish) &&
      (x == kRamen_1 || x == kBoiledEgg_1 || x == kSalt_1))
    return act({Verb::kAdd, x, y});
  const Verb verb = box || (inside && c != nullptr && (c->vessel || c->dish)) ? Verb::kKeepIn : Verb::kKeepOn;
  if (now_.has(verb == Verb::kKeepIn ? Relation::kIn : Relation::kOn, x, y)) return {};
  return act({verb, x, y});
}

std::string FrameActions::turn_on(Symbol device, bool on, int number) {
  const auto set = [&](Symbol object, Symbol value, const SymAction& toggle) -> Problem {
    return now_.is(object, value) == on ? Problem{} : act(toggle);
  };
  if (device == kSinkKnob) return set(kSinkKnob, kTapIsOn, {Verb::kTurn, kSinkKnob});
  if (device == kTv_1 || device == kTv_1Remote_1) return set(kTv_1, kIsOn, {Verb::kPress, kTv_1PowerButton});
  if (device == kFridge || device == kFridgeButton)
    return set(kFridge, kWaterDispenserIsOpen, {Verb::kPress, kFridgeButton});
  if (device == kMicrowave || device == kMicrowaveButton) {
    if (on && now_.is(kMicrowave, kDoorIsOpen))
      if (const Problem problem = act({Verb::kClose, kMicrowave}); !problem.empty()) return problem;
    return set(kMicrowave, kMicrowaveIsOn, {Verb::kPress, kMicrowaveButton});
  }
  const auto knob = [&](int i) {
    return set(kStove, static_cast<Symbol>(kStoveFire1 + i),
               {Verb::kTurn, static_cast<Symbol>(kStoveKnob_1 + i)});
  };
  if (device >= kStoveFire_1 && device <= kStoveFire_4) return knob(device - kStoveFire_1);
  if (device >= kStoveKnob_1 && device <= kStoveKnob_4) return knob(device - kStoveKnob_1);
  if (device == kStove) {
    if (number >= 1 && number <= 4) return knob(number - 1);
    if (!on) {  // everything that burns
      for (int i = 0; i < 4; ++i)
        if (const Problem problem = knob(i); !problem.empty()) return problem;
      return {};
    }
    // The burner under what was just put there, else under anything, else the first.
    for (int i = 0; i < 4; ++i)
      for (const Symbol object : last_)
        if (now_.has(Relation::kOn, object, static_cast<Symbol>(kStoveFire_1 + i))) return knob(i);
    return knob(0);
  }
  return "there is no switch on that";
}

std::string FrameActions::fill_with_water(Symbol vessel) {
  if (resolver_.instruction().find(kSink) < 0) return "there is no tap here";
  if (now_.is(vessel, kWater)) return {};
  if (!now_.has(Relation::kOn, vessel, kSink))
    if (const Problem problem = act({Verb::kKeepOn, vessel, kSink}); !problem.empty()) return problem;
  if (now_.is(vessel, kWater)) return {};
  if (now_.is(kSinkKnob, kTapIsOn)) return "the tap runs, but no water gets into it";
  return act({Verb::kTurn, kSinkKnob});
}

std::string FrameActions::add(const Clause& clause) {
  if (!clause.unknown.empty()) return language_.unknown_word(clause.unknown.front());
  const SymState before = now_;
  const std::size_t count = macros_.size();
  Problem problem;
  switch (clause.frame) {
    case Frame::kGo:
      problem = go(clause);
      break;
    case Frame::kTake:
      problem = take(clause);
      break;
    case Frame::kPlace:
    case Frame::kBring:
      problem = put(clause);
      break;
    case Frame::kDiscard:
      problem = discard(clause);
      break;
    case Frame::kFill:
      problem = fill(clause);
      break;
    case Frame::kPour:
      problem = pour(clause);
      break;
    case Frame::kEmpty:
      problem = empty(clause);
      break;
    case Frame::kTurn:
      problem = turn(clause, -1);
      break;
    case Frame::kStart:
      problem = turn(clause, 1);
      break;
    case Frame::kStop:
      problem = turn(clause, 0);
      break;
    case Frame::kOpen:
      problem = door(clause, true);
      break;
    case Frame::kClose:
      problem = door(clause, false);
      break;
    case Frame::kWash:
      problem = wash(clause);
      break;
    case Frame::kHeat:
      problem = heat(clause, false);
      break;
    case Frame::kBoil:
      problem = heat(clause, true);
      break;
    case Frame::kAdd:
    case Frame::kSqueeze:
      problem = add_to(clause);
      break;
    case Frame::kScoop:
      problem = scoop(clause);
      break;
    case Frame::kInsert:
      problem = insert(clause);
      break;
    case Frame::kRelease:
      problem = release(clause);
      break;
    case Frame::kChange:
    case Frame::kMute:
    case Frame::kRaise:
    case Frame::kLower:
      problem = television(clause);
      break;
    case Frame::kNone:
      problem = "there is no verb that a robot could act on";
      break;
  }
  if (!problem.empty()) {
    now_ = before;
    macros_.erase(macros_.begin() + static_cast<long>(count), macros_.end());
  }
  return problem;
}

}  // namespace goalnet::inference
