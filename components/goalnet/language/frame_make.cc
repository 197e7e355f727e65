// Making dishes and drinks.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr auto kCannotBeMade =
    "it is not known how to make that; water, coffee, noodles and ice cream can be had";

}  // namespace

// "a cup of hot water", "a bowl of ice cream with chocolate syrup", "some noodles".
std::string FrameActions::make(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->bare()) return "it is not clear what to " + clause.verb;
  const Symbol content = language_.content(thing->content.empty() ? thing->phrase : thing->content);
  if (const auto served = serve_food(clause, *thing, content)) return *served;
  if (content == kNone) return cook_noodles_in_their_cup(*thing);
  Problem problem;
  Symbol vessel = vessel_to_make_it_in(clause, *thing, content, problem);
  if (!problem.empty()) return problem;
  switch (content) {
    case kWater:
      return make_water(clause, *thing, vessel);
    case kCoffee:
      return make_coffee(*thing, vessel);
    case kCoke:
    case kEnergyDrink:
    case kCanadaDry:
      return make_canned_drink(clause, content, vessel);
    case kIceCream:
      if (vessel == kNone) vessel = first_of_class("bowl");
      if (vessel == kNone) return not_here("there is no bowl here");
      remember({vessel});
      problem = scoop_into(vessel, std::max(thing->count, 1));
      break;
    case kRamen:
    case kEgg:
      if (vessel == kNone) vessel = first_of_class("kettle");
      if (vessel == kNone) return not_here("there is no pot here to heat it in");
      problem = boil_food(*thing, content == kRamen ? Symbol{kRamen_1} : Symbol{kBoiledEgg_1}, vessel);
      break;
    default:
      return kCannotBeMade;
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

// "serve the egg on a plate"
std::optional<std::string> FrameActions::serve_food(const Clause& clause, const NounPhrase& thing,
                                                    Symbol content) {
  const NounPhrase* dish = clause.first(Role::kDestination);
  if (!at_home_ || clause.frame != Frame::kMake || dish == nullptr || dish->pronoun || dish->bare() ||
      thing.pronoun || thing.everything || !thing.content.empty() ||
      (content != kNone && !(content == kEgg && thing.definite)))
    return std::nullopt;
  const Objects food = resolver_.options(thing, Sort::kMovable, now_);
  const Objects dishes = resolver_.options(*dish, Sort::kPlace, now_);
  if (dishes.empty() || !is_vessel_or_dish(dishes.front()) || food.empty() ||
      !resolver_.class_of(food.front())->food)
    return std::nullopt;
  Clause served = clause;
  served.frame = Frame::kPlace, served.verb = "put", served.to_person = false;
  return put(served);
}

// "make the instant noodles": with water, hot
std::string FrameActions::cook_noodles_in_their_cup(const NounPhrase& thing) {
  const auto objects =
      thing.pronoun || thing.everything ? Objects{} : resolver_.options(thing, Sort::kMovable, now_);
  if (objects.empty() || !resolver_.is_of_class(objects.front(), "instant_ramen")) return kCannotBeMade;
  if (const Problem problem = fill_with_water(objects.front()); !problem.empty()) return problem;
  remember({objects.front()});
  return heat_objects({objects.front()}, resolver_.exists(kMicrowave), nullptr);
}

// The vessel that the sentence names, or one like it that has the content already; kNone where it names none.
Symbol FrameActions::vessel_to_make_it_in(const Clause& clause, const NounPhrase& thing, Symbol content,
                                          Problem& problem) {
  if (thing.content.empty()) {
    const NounPhrase* destination = clause.first(Role::kDestination);
    if (destination == nullptr || destination->pronoun || destination->bare()) return kNone;
    const auto options = resolver_.options(*destination, Sort::kPlace, now_);
    return !options.empty() && is_vessel_or_dish(options.front()) ? options.front() : Symbol{kNone};
  }
  NounPhrase plain = thing;
  plain.content.clear(), plain.adjectives.clear();
  const auto options = resolver_.options(plain, Sort::kPlace, now_);
  if (options.empty()) {
    problem = unknown_thing(thing, Sort::kVessel);
    return kNone;
  }
  if (content == kCoffee && vessel_with(kCoffee) != kNone) return vessel_with(kCoffee);
  Symbol vessel = options.front();
  for (const Symbol option : resolver_.all(Sort::kVessel, now_))
    if (now_.is(option, content) && content != kWater &&
        resolver_.class_of(option) == resolver_.class_of(vessel))
      vessel = option;
  return vessel;
}

// "make me some hot water"
std::string FrameActions::make_water(const Clause& clause, const NounPhrase& thing, Symbol vessel) {
  if (vessel == kNone) vessel = first_of_class(clause.frame == Frame::kMake ? "kettle" : "glass");
  if (vessel == kNone) vessel = first_of_class("long_cup");
  if (vessel == kNone) return "there is nothing here to fill";
  remember({vessel});
  if (const Problem problem = fill_with_water(vessel); !problem.empty()) return problem;
  if (thing.has("hot") || thing.has("warm") || thing.has("boiling"))
    return heat_objects({vessel}, heats_in_microwave(vessel), nullptr);
  return (clause.frame == Frame::kTake || clause.to_person) && !now_.holds(vessel)
             ? act({Verb::kGrasp, vessel})
             : Problem{};
}

// "a cup of hot coffee"
std::string FrameActions::make_coffee(const NounPhrase& thing, Symbol vessel) {
  if (vessel == kNone) vessel = vessel_with(kCoffee);
  if (vessel == kNone) return not_here("there is no coffee here");
  remember({vessel});
  const bool hot = thing.has("hot") || thing.has("warm") || thing.has("boiling");
  Problem problem = fill_one(vessel, kCoffee);
  if (!problem.empty()) return problem;
  if (hot) problem = heat_objects({vessel}, resolver_.exists(kMicrowave), nullptr);
  if (!problem.empty() || (hot && !at_home_)) return problem;
  return now_.holds(vessel) ? Problem{} : act({Verb::kGrasp, vessel});
}

// "a glass of coke"
std::string FrameActions::make_canned_drink(const Clause& clause, Symbol content, Symbol vessel) {
  if (vessel == kNone) vessel = first_of_class("glass");
  if (vessel == kNone) return "there is nothing here to fill";
  remember({vessel});
  if (const Problem problem = fill_one(vessel, content); !problem.empty()) return problem;
  return clause.frame == Frame::kTake || clause.to_person ? take_up(vessel) : Problem{};
}

// "some noodles", "cook an egg": in water
std::string FrameActions::boil_food(const NounPhrase& thing, Symbol food, Symbol vessel) {
  remember({vessel});
  if (!resolver_.exists(food)) return not_here("there is no " + thing.word + " here");
  if (const Problem problem = fill_with_water(vessel); !problem.empty()) return problem;
  if (const Problem problem = keep(food, vessel, Where::kIn); !problem.empty()) return problem;
  return heat_objects({vessel}, heats_in_microwave(vessel), nullptr);
}

// A pot is heated on the stove, all else in the microwave where there is one.
bool FrameActions::heats_in_microwave(Symbol vessel) const {
  return !resolver_.is_of_class(vessel, "kettle") && resolver_.exists(kMicrowave);
}

}  // namespace goalnet::inference
