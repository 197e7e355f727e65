// Making dishes and drinks.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

// "a cup of hot water", "a bowl of ice cream with chocolate syrup", "some noodles".
std::string FrameActions::make(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->bare()) return "it is not clear what to " + clause.verb;
  Symbol content = language_.content(thing->content.empty() ? thing->phrase : thing->content);
  // "serve the egg on a plate"
  if (const NounPhrase* dish = clause.first(Role::kDestination);
      at_home_ && clause.frame == Frame::kMake && dish != nullptr && !dish->pronoun && !dish->bare() &&
      !thing->pronoun && !thing->everything && thing->content.empty() &&
      (content == kNone || (content == kEgg && thing->definite))) {
    const Objects food = resolver_.options(*thing, Sort::kMovable, now_);
    const Objects dishes = resolver_.options(*dish, Sort::kPlace, now_);
    const bool holder =
        !dishes.empty() && (resolver_.is_vessel(dishes.front()) || resolver_.class_of(dishes.front())->dish);
    if (holder && !food.empty() && resolver_.class_of(food.front())->food) {
      Clause served = clause;
      served.frame = Frame::kPlace, served.verb = "put", served.to_person = false;
      return put(served);
    }
  }
  if (content == kNone) {
    const auto objects =
        thing->pronoun || thing->everything ? Objects{} : resolver_.options(*thing, Sort::kMovable, now_);
    if (!objects.empty() && resolver_.is_of_class(objects.front(), "instant_ramen")) {
      if (const Problem problem = fill_with_water(objects.front()); !problem.empty()) return problem;
      remember({objects.front()});
      return heat_objects({objects.front()}, resolver_.exists(kMicrowave), nullptr);
    }
    return "it is not known how to make that; water, coffee, noodles and ice cream can be had";
  }
  const bool hot = thing->has("hot") || thing->has("warm") || thing->has("boiling");
  Symbol vessel = kNone;
  if (!thing->content.empty()) {
    NounPhrase plain = *thing;
    plain.content.clear(), plain.adjectives.clear();
    const auto options = resolver_.options(plain, Sort::kPlace, now_);
    if (options.empty()) return unknown_thing(*thing, Sort::kVessel);
    vessel = options.front();
    // the one that has it already
    for (const Symbol option : resolver_.all(Sort::kVessel, now_))
      if (now_.is(option, content) && content != kWater &&
          resolver_.class_of(option) == resolver_.class_of(vessel))
        vessel = option;
    if (content == kCoffee && vessel_with(kCoffee) != kNone) vessel = vessel_with(kCoffee);
  } else if (const NounPhrase* destination = clause.first(Role::kDestination);
             destination != nullptr && !destination->pronoun && !destination->bare()) {
    const auto options = resolver_.options(*destination, Sort::kPlace, now_);
    if (!options.empty() &&
        (resolver_.is_vessel(options.front()) || resolver_.class_of(options.front())->dish))
      vessel = options.front();
  }
  const auto of_class = [&](const char* name) {
    for (const SeenObject& object : resolver_.objects())
      if (resolver_.is_of_class(object.symbol, name)) return object.symbol;
    return Symbol{kNone};
  };
  Problem problem;
  switch (content) {
    case kWater:
      if (vessel == kNone) vessel = clause.frame == Frame::kMake ? of_class("kettle") : of_class("glass");
      if (vessel == kNone) vessel = of_class("long_cup");
      if (vessel == kNone) return "there is nothing here to fill";
      remember({vessel});
      if (problem = fill_with_water(vessel); !problem.empty()) return problem;
      if (!hot)
        return (clause.frame == Frame::kTake || clause.to_person) && !now_.holds(vessel)
                   ? act({Verb::kGrasp, vessel})
                   : Problem{};
      return heat_objects({vessel}, !resolver_.is_of_class(vessel, "kettle") && resolver_.exists(kMicrowave),
                          nullptr);
    case kCoffee:
      if (vessel == kNone) vessel = vessel_with(kCoffee);
      if (vessel == kNone) return not_here("there is no coffee here");
      remember({vessel});
      if (problem = fill_one(vessel, kCoffee); !problem.empty()) return problem;
      if (hot) problem = heat_objects({vessel}, resolver_.exists(kMicrowave), nullptr);
      if (!problem.empty() || (hot && !at_home_)) return problem;
      return now_.holds(vessel) ? Problem{} : act({Verb::kGrasp, vessel});
    case kCoke:
    case kEnergyDrink:
    case kCanadaDry:
      if (vessel == kNone) vessel = of_class("glass");
      if (vessel == kNone) return "there is nothing here to fill";
      remember({vessel});
      if (problem = fill_one(vessel, content); !problem.empty()) return problem;
      return clause.frame == Frame::kTake || clause.to_person ? take_up(vessel) : Problem{};
    case kIceCream:
      if (vessel == kNone) vessel = of_class("bowl");
      if (vessel == kNone) return not_here("there is no bowl here");
      remember({vessel});
      problem = scoop_into(vessel, std::max(thing->count, 1));
      break;
    case kRamen:
    case kEgg: {
      if (vessel == kNone) vessel = of_class("kettle");
      if (vessel == kNone) return not_here("there is no pot here to heat it in");
      remember({vessel});
      const Symbol food = content == kRamen ? Symbol{kRamen_1} : Symbol{kBoiledEgg_1};
      if (!resolver_.exists(food)) return not_here("there is no " + thing->word + " here");
      if (problem = fill_with_water(vessel); !problem.empty()) return problem;
      if (problem = keep(food, vessel, Where::kIn); !problem.empty()) return problem;
      problem = heat_objects(
          {vessel}, !resolver_.is_of_class(vessel, "kettle") && resolver_.exists(kMicrowave), nullptr);
      break;
    }
    default:
      return "it is not known how to make that; water, coffee, noodles and ice cream can be had";
  }
  if (!problem.empty()) return problem;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kWith) continue;
    bool done = false;
    if (problem = add_content(phrase, vessel, done); !problem.empty()) return problem;
  }
  // "bring me a bowl of ice cream"
  const bool brought = clause.frame == Frame::kTake || clause.frame == Frame::kBring;
  if (at_home_ && brought) return take_up(vessel);
  return {};
}

}  // namespace goalnet::inference
