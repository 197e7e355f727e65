// Scooping ice cream.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr int kMostScoops = 5;

}  // namespace

std::string FrameActions::scoop_into(Symbol target, int times) {
  Symbol source = resolver_.ice_cream();
  if (source == kNone || !resolver_.exists(kSpoon_1)) return not_here("there is nothing here to scoop");
  for (int i = 0; i < std::min(times, kMostScoops); ++i) {
    if (!now_.is(kSpoon_1, kScoopsLeft)) {
      if (!now_.is(source, kScoopsLeft)) return "no ice cream is left";
      if (const Problem problem = act({Verb::kScoop, kSpoon_1, source}); !problem.empty()) return problem;
    }
    if (target == kNone) return {};
    if (const Problem problem = act({Verb::kAdd, kIceCreamScoop, target}); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::scoop(const Clause& clause) {
  const NounPhrase* destination = clause.first(Role::kDestination);
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (at_home_ && destination == nullptr && thing != nullptr && thing->scoop && thing->at.size() == 1)
    destination = &thing->at.front();  // "I want a scoop of ice cream in the bowl"
  if (thing != nullptr && !can_be_scooped(*thing)) return "only ice cream can be scooped";
  const int times = thing != nullptr && thing->count > 1 ? thing->count : 1;
  if (const NounPhrase* with = clause.first(Role::kWith);
      with != nullptr && !with->pronoun &&
      (with->bare() || resolver_.options(*with, Sort::kMovable, now_).empty()))
    return unknown_thing(*with, Sort::kMovable);
  if (destination == nullptr) {
    remember({resolver_.exists(kSpoon_1) ? Symbol{kSpoon_1} : Symbol{kNone}});
    return scoop_into(kNone, 1);
  }
  Objects targets = destination->pronoun  ? pronoun(*destination, Sort::kPlace, {})
                    : destination->bare() ? Objects{}
                                          : resolver_.options(*destination, Sort::kMovable, now_);
  std::erase_if(targets, [&](Symbol object) { return !is_vessel_or_dish(object); });
  if (targets.empty()) return unknown_thing(*destination, Sort::kVessel);
  if (!destination->pronoun) targets = resolver_.chosen(*destination, targets);
  for (const Symbol target : targets)
    if (const Problem problem = scoop_into(target, times); !problem.empty()) return problem;
  if (const Problem problem = squeeze_on_scoops(clause, targets); !problem.empty()) return problem;
  remember(targets);
  return {};
}

// Ice cream, under its name or as "it", or "some" of what nobody names.
bool FrameActions::can_be_scooped(const NounPhrase& thing) const {
  if (thing.bare() && thing.some) return true;  // "scoop some into the mug"
  if (language_.content(thing.phrase) == kIceCream) return true;
  if (thing.scoop) return thing.phrase.empty();
  if (!thing.pronoun) return false;
  const Objects it = pronoun(thing, Sort::kMovable, {});
  return !it.empty() && it.front() == resolver_.ice_cream();
}

// "a scoop of ice cream in the bowl with chocolate syrup"
std::string FrameActions::squeeze_on_scoops(const Clause& clause, const Objects& targets) {
  const NounPhrase* with = clause.first(Role::kWith);
  if (!at_home_ || with == nullptr || with->pronoun || with->bare()) return {};
  const Objects toppings = resolver_.options(*with, Sort::kMovable, now_);
  if (toppings.empty() || !now_.has(Relation::kIsSqueezeable, toppings.front())) return {};
  for (const Symbol target : targets)
    if (const Problem problem = act({Verb::kSqueeze, toppings.front(), target}); !problem.empty())
      return problem;
  return {};
}

}  // namespace goalnet::inference
