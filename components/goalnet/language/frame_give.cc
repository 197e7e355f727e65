// What is given to things and places instead of people: a pillow, a squirt of syrup, a minute in the
// microwave.
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

// "give water in the kettle", "get me coke in the glass", "... in it instead"; nothing where it is not that.
std::optional<std::string> FrameActions::give_content(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || (clause.verb != "give" && (!clause.to_person || clause.wish)) || thing == nullptr ||
      thing->definite)
    return std::nullopt;
  const Symbol content = language_.content(thing->phrase);
  const NounPhrase* in = thing->at.empty() ? clause.first(Role::kDestination) : &thing->at.front();
  const bool drink = content == kWater || content == kCoffee || is_canned_drink(content);
  if (!drink || in == nullptr || in->where == Where::kTo || in->bare() || in->everything) return std::nullopt;
  const Objects vessels = in->pronoun ? pronoun(*in, Sort::kVessel, {})
                                      : resolver_.chosen(*in, resolver_.options(*in, Sort::kVessel, now_));
  if (vessels.empty() || now_.is(vessels.front(), content)) return std::nullopt;
  if (const Problem problem = fill_one(vessels.front(), content); !problem.empty()) return problem;
  remember({vessels.front()});
  return clause.to_person ? take_up(vessels.front()) : Problem{};
}

// Nothing where somebody is given something.
std::optional<std::string> FrameActions::give(const Clause& clause) {
  if (clause.verb != "give") return std::nullopt;
  static constexpr Reading kReadings[] = {
      &FrameActions::give_to_place,      // "the armchair has no pillow, give it the one from the shelf"
      &FrameActions::give_topping,       // "give both plates a squirt of chocolate"
      &FrameActions::give_time_in_heat,  // "give the coffee a minute in the microwave"
  };
  return first_that_fits(kReadings, clause);
}

// "the armchair has no pillow, give it the one from the shelf"
std::optional<std::string> FrameActions::give_to_place(const Clause& clause) {
  if (!at_home_ || clause.to_person || clause.phrases.size() < 2 || clause.phrases[0].role != Role::kDirect ||
      clause.phrases[1].role != Role::kDirect)
    return std::nullopt;
  const NounPhrase& receiver = clause.phrases[0];
  const Objects places = meant_by(receiver, Sort::kPlace);
  if (places.empty() || !resolver_.class_of(places.front())->place) return std::nullopt;
  Clause placed = clause;
  placed.phrases.erase(placed.phrases.begin());
  placed.phrases.push_back(receiver);
  placed.phrases.back().role = Role::kDestination, placed.phrases.back().where = Where::kOn;
  placed.frame = Frame::kPlace, placed.verb = "put";
  return put(placed);
}

// "give both plates a squirt of chocolate"
std::optional<std::string> FrameActions::give_topping(const Clause& clause) {
  if (clause.phrases.size() != 2 || clause.phrases[0].role != Role::kDirect ||
      clause.phrases[1].role != Role::kDirect || language_.content(clause.phrases[1].phrase) == kNone ||
      clause.phrases[0].bare() || clause.phrases[0].pronoun)
    return std::nullopt;
  const auto dishes = resolver_.options(clause.phrases[0], Sort::kPlace, now_);
  if (dishes.empty() || !is_vessel_or_dish(dishes.front())) return std::nullopt;
  Clause added = clause;
  added.frame = Frame::kAdd, added.verb = "add";
  added.phrases[0].role = Role::kDestination;
  return add_to(added);
}

// "give the coffee a minute in the microwave"
std::optional<std::string> FrameActions::give_time_in_heat(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->at.empty() || thing->at.front().pronoun || thing->at.front().bare())
    return std::nullopt;
  const auto places = resolver_.options(thing->at.front(), Sort::kPlace, now_);
  NounPhrase plain = *thing;
  plain.at.clear();
  const auto objects = plain.pronoun ? Objects{} : resolver_.options(plain, Sort::kMovable, now_);
  const bool heats =
      !places.empty() && (places.front() == kMicrowave || resolver_.is_of_class(places.front(), "burner"));
  if (!heats || objects.empty() || resolver_.place_of(objects.front(), now_) == places.front())
    return std::nullopt;
  Clause hot = clause;
  NounPhrase place = thing->at.front();
  place.role = Role::kDestination;
  hot.phrases = {plain, place};
  hot.frame = Frame::kHeat, hot.verb = "heat";
  return heat(hot, false);
}

}  // namespace goalnet::inference
