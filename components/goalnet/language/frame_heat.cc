// Heating and boiling.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::heat(const Clause& clause, bool boil) {
  const NounPhrase* where = nullptr;
  bool microwave = clause.verb == "microwave" || clause.verb == "nuke", stove = boil;
  read_where_to_heat(clause, microwave, stove, where);
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing != nullptr && thing->bare() && thing->some) {  // "heat some in the kettle": water
    Clause water = clause;
    for (NounPhrase& phrase : water.phrases)
      if (phrase.role == Role::kDirect) phrase.phrase = phrase.word = "water";
    return heat(water, boil);
  }
  if (const auto cooked = cook_a_dish(clause)) return *cooked;
  Problem problem;
  const Objects objects = objects_to_heat(clause, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    const ObjectClass* c = resolver_.class_of(object);
    if (!resolver_.is_vessel(object) && !c->dish && !c->food)
      return resolver_.name(object) + " should not be heated";
  }
  const Symbol front = objects.front();
  const bool raw = front == kRamen_1 || front == kBoiledEgg_1;
  if (raw && (boil || (clause.verb == "cook" && front == kRamen_1)) && !microwave)
    return boil_in_water(clause, objects, where);
  if (boil && resolver_.is_of_class(front, "kettle"))
    if (problem = fill_with_water(front); !problem.empty()) return problem;
  if (!microwave && !stove && !resolver_.is_of_class(front, "kettle"))
    microwave = resolver_.exists(kMicrowave);
  // What stands on a burner already is heated there.
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (clause.verb != "microwave" && objects.size() == 1 && now_.has(Relation::kOn, front, burner) &&
        !stove && clause.first(Role::kDestination) == nullptr && clause.first(Role::kWith) == nullptr)
      microwave = false;
  return heat_objects(objects, microwave, where);
}

// "in the microwave", "on burner two": `where` is the burner
void FrameActions::read_where_to_heat(const Clause& clause, bool& microwave, bool& stove,
                                      const NounPhrase*& where) {
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination && phrase.role != Role::kWith) continue;
    if (phrase.pronoun || phrase.bare()) continue;
    const auto options = resolver_.options(phrase, Sort::kPlace, now_);
    if (options.empty()) continue;
    if (options.front() == kMicrowave) microwave = true, stove = false;
    if (resolver_.is_of_class(options.front(), "burner")) stove = true, microwave = false, where = &phrase;
  }
}

// "cook me a bowl of ramen": nothing holds any yet
std::optional<std::string> FrameActions::cook_a_dish(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->content.empty()) return std::nullopt;
  const Symbol dish = language_.content(thing->content);
  if ((dish != kRamen && dish != kEgg) || vessel_with(dish) != kNone) return std::nullopt;
  Clause hot = clause;
  for (NounPhrase& phrase : hot.phrases)
    if (phrase.role == Role::kDirect) phrase.adjectives.push_back("hot");
  return make(hot);
}

FrameActions::Objects FrameActions::objects_to_heat(const Clause& clause, Problem& problem) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const bool named_vessel = thing != nullptr && !thing->content.empty();
  if (mentioned_content(clause, Role::kDirect) == kWater ||
      (named_vessel && language_.content(thing->content) == kWater)) {
    const Symbol vessel = vessel_to_heat_water_in(clause, named_vessel);
    problem = vessel == kNone ? not_here("there is no pot here to heat it in") : fill_with_water(vessel);
    if (problem.empty()) remember({vessel});
    return {vessel};
  }
  Objects objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return {};
  // what is in a vessel is heated with it
  for (Symbol& object : objects)
    if (const Symbol in = resolver_.place_of(object, now_);
        in != kNone &&
        (resolver_.is_vessel(in) || (at_home_ && !start_.has(Relation::kIn, object, in) &&
                                     resolver_.class_of(in) != nullptr && resolver_.class_of(in)->dish)))
      object = in;
  return objects;
}

// What the sentence says, else what holds water, else the kettle.
Symbol FrameActions::vessel_to_heat_water_in(const Clause& clause, bool named_vessel) {
  Symbol vessel = kNone;
  for (const NounPhrase& phrase : clause.phrases) {
    NounPhrase plain = phrase;
    plain.content.clear();
    if ((phrase.role == Role::kDirect && !named_vessel) || phrase.pronoun || phrase.bare()) continue;
    const auto options = resolver_.options(plain, Sort::kVessel, now_);
    if (!options.empty()) vessel = options.front();
  }
  if (vessel == kNone) vessel = vessel_with(kWater);
  return vessel == kNone ? pot() : vessel;
}

Symbol FrameActions::pot() const {
  Symbol found = kNone;
  for (const Symbol option : resolver_.all(Sort::kVessel, now_))
    if (resolver_.is_of_class(option, "kettle")) found = option;
  return found;
}

// "boil the egg with salt": in the pot that is named, else in any
std::string FrameActions::boil_in_water(const Clause& clause, const Objects& objects,
                                        const NounPhrase* where) {
  Symbol vessel = pot();
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination && !phrase.pronoun && !phrase.bare())
      if (const auto options = resolver_.options(phrase, Sort::kVessel, now_); !options.empty())
        vessel = options.front();
  if (vessel == kNone) return not_here("there is no pot here to heat it in");
  Problem problem;
  if (problem = fill_with_water(vessel); !problem.empty()) return problem;
  for (const Symbol object : objects)
    if (problem = keep(object, vessel, Where::kIn); !problem.empty()) return problem;
  for (const NounPhrase& phrase : clause.phrases) {
    bool done = false;
    if (phrase.role == Role::kWith && !phrase.pronoun)
      if (problem = add_content(phrase, vessel, done); !problem.empty()) return problem;
  }
  return heat_objects({vessel}, false, where);
}

std::string FrameActions::heat_objects(const Objects& objects, bool microwave, const NounPhrase* where) {
  Problem problem;
  if (microwave && !resolver_.exists(kMicrowave)) return not_here("there is no microwave here");
  if (microwave) {
    for (const Symbol object : objects)
      if (problem = keep(object, kMicrowave, Where::kIn); !problem.empty()) return problem;
    last_destination_ = {Symbol{kMicrowave}};
    return turn_on(kMicrowave, true, 0);
  }
  const bool which = where != nullptr && (where->ordinal > 0 || where->number > 0);
  for (const Symbol object : objects) {
    Symbol burner = burner_for(object);
    if (which) {
      const auto said = places(*where, objects, 1, problem);
      if (!problem.empty()) return problem;
      burner = said.front();
    }
    if (burner == kNone) return not_here("there is no stove here");
    if (!now_.has(Relation::kOn, object, burner))
      if (problem = act({Verb::kKeepOn, object, burner}); !problem.empty()) return problem;
    if (problem = turn_on(burner, true, 0); !problem.empty()) return problem;
    last_destination_ = {burner};
  }
  return {};
}

}  // namespace goalnet::inference
