// Putting things somewhere.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::put(const Clause& said) {
  Clause clause = said;
  // "bring the book on the shelf": where one is on the shelf, that says which
  if (const NounPhrase* thing = clause.first(Role::kDirect), *place = clause.first(Role::kDestination);
      at_home_ && clause.frame == Frame::kBring && (clause.verb == "bring" || clause.verb == "fetch") &&
      clause.phrases.size() == 2 && thing != nullptr && place != nullptr && clause.particles.empty() &&
      !thing->pronoun && !thing->bare() && !thing->everything && !thing->has("other") && !thing->rest &&
      !place->pronoun && !place->bare() && !place->has("other") &&
      (place->where == Where::kOn || place->where == Where::kIn) && !clause.has("onto") &&
      !clause.has("into") && !clause.has("a") && !clause.has("another")) {
    NounPhrase located = *thing;
    located.at.push_back(*place);
    const int loose = resolver_.doubts().loose;
    const auto there = resolver_.options(located, Sort::kMovable, now_);
    const bool which = !there.empty() && resolver_.doubts().loose == loose;
    resolver_.doubts().loose = loose;
    if (which) {
      clause.phrases = {located};
      clause.frame = Frame::kTake, clause.to_person = true;
      return take(clause);
    }
  }
  // "put the mug in the sink and the glass too": what is joined to a place, but is none, is moved as well
  bool first_place = true;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination) continue;
    const ObjectClass* c = nullptr;
    if (!first_place && !phrase.pronoun && !phrase.bare())
      if (const auto options = resolver_.options(phrase, Sort::kMovable, now_); !options.empty())
        c = resolver_.class_of(options.front());
    if (c != nullptr && !c->place && phrase.joined) phrase.role = Role::kDirect;
    first_place = false;
  }
  // "put mug sink"
  if (clause.phrases.size() == 1 && clause.first(Role::kDirect) != nullptr &&
      !clause.phrases.front().modifier.empty() && clause.particles.empty() &&
      resolver_.options(clause.phrases.front(), Sort::kMovable, now_).empty()) {
    NounPhrase moved = clause.phrases.front();
    moved.phrase = moved.word = moved.modifier;
    moved.plural = moved.modifier_plural;
    moved.modifier.clear();
    NounPhrase& place = clause.phrases.front();
    place.role = Role::kDestination, place.where = Where::kOn;
    place.modifier.clear();
    clause.phrases.push_back(moved);
  }
  // "load the microwave with the bowl"
  if (const NounPhrase* with = clause.first(Role::kWith), *place = clause.first(Role::kDirect);
      with != nullptr && place != nullptr && clause.verb == "load" &&
      (lexicon_place(*place) ||
       (at_home_ && !place->pronoun && !place->bare() && !resolver_.named(*place).empty() &&
        resolver_.named(*place).front() == resolver_.xbox()))) {
    for (NounPhrase& phrase : clause.phrases)
      phrase.role = phrase.role == Role::kWith     ? Role::kDirect
                    : phrase.role == Role::kDirect ? Role::kDestination
                                                   : phrase.role;
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.where = Where::kTo;
  }
  if (clause.has_particle("to_boil")) return heat(clause, true);  // "bring the water to the boil"
  // "put in a disc"
  if (clause.phrases.size() == 1 && clause.first(Role::kDirect) == nullptr) {
    NounPhrase& only = clause.phrases.front();
    const auto moved = only.pronoun || only.bare() || only.where != Where::kIn
                           ? Objects{}
                           : resolver_.options(only, Sort::kMovable, now_);
    if (!moved.empty() && !resolver_.class_of(moved.front())->place && !resolver_.is_vessel(moved.front())) {
      only.role = Role::kDirect;
      if (resolver_.is_of_class(moved.front(), "cd")) return insert(clause);
      clause.particles.push_back("in");
    }
  }
  const NounPhrase* thing = clause.first(Role::kDirect);
  const NounPhrase* destination = nullptr;
  int places_said = 0;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination) destination = &phrase, ++places_said;
  // "with the other drinks": where those are
  if (destination == nullptr && thing != nullptr)
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kWith && !phrase.bare() && !phrase.pronoun &&
          !(at_home_ && !thing->content.empty()) &&  // "a bowl of ice cream with syrup"
          !resolver_.options(phrase, Sort::kMovable, now_).empty()) {
        const Symbol beside = resolver_.options(phrase, Sort::kMovable, now_).front();
        const bool rubbish =
            beside == kGarbageBin_1 || beside == kGarbageBag_1;  // "put the beer with the rubbish"
        phrase.role = Role::kDestination, phrase.where = rubbish ? Where::kIn : Where::kNear;
        destination = &phrase;
        break;
      }
  // Of two places the first says where it is: "put the cup on the counter in the sink".
  if (places_said > 1)
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination && &phrase != destination) phrase.role = Role::kSource;

  if (destination == nullptr) return put_without_place(clause);
  if (clause.verb == "spread" || clause.verb == "distribute" || clause.verb == "scatter" ||
      clause.verb == "divide")
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.all = true;
  if (thing == nullptr)
    return clause.frame == Frame::kBring || clause.frame == Frame::kTake || clause.verb == "move"
               ? go(clause)
               : "it is not clear what to put there";
  if (thing->scoop) return scoop(clause);
  if (at_home_ && !destination->pronoun && !destination->bare()) {
    const Objects into = resolver_.options(*destination, Sort::kMovable, now_);
    // "transfer what is in the mug to the glass"
    if (thing->everything && !thing->at.empty() && !thing->at.front().pronoun && !thing->at.front().bare() &&
        !into.empty() && resolver_.is_vessel(into.front()) &&
        !resolver_.options(thing->at.front(), Sort::kVessel, now_).empty()) {
      Clause poured = clause;
      poured.frame = Frame::kPour, poured.verb = "pour";
      return pour(poured);
    }
    // "chocolate sauce on the ice cream"
    const Objects bottle =
        thing->pronoun || thing->everything ? Objects{} : resolver_.options(*thing, Sort::kMovable, now_);
    if (!into.empty() && into.front() == resolver_.ice_cream() && !bottle.empty() &&
        now_.has(Relation::kIsSqueezeable, bottle.front()))
      return add_to(clause);
    if (thing->phrase == "bag" && !into.empty() && into.front() == kGarbageBin_1 &&
        resolver_.exists(kGarbageBag_1))
      for (NounPhrase& phrase : clause.phrases)  // "the bag goes in the bin"
        if (phrase.role == Role::kDirect) phrase.phrase = "garbage bag";
  }
  if (language_.tv_word(destination->phrase)) return television(clause);  // "put the tv on channel 2"
  if (language_.content(destination->phrase) == kIceCream && !thing->pronoun &&
      !resolver_.named(*thing).empty() && resolver_.named(*thing).front() == kSpoon_1)
    return scoop_into(kNone, 1);
  // "put a pot of water on the stove": it has none yet
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect || phrase.content.empty()) continue;
    NounPhrase plain = phrase;
    plain.content.clear();
    const auto vessels = resolver_.options(plain, Sort::kVessel, now_);
    if (resolver_.options(phrase, Sort::kMovable, now_).empty() && !vessels.empty()) {
      if (const Problem problem = fill_one(vessels.front(), language_.content(phrase.content));
          !problem.empty())
        return problem;
    }
  }

  // Contents are poured, shaken or scooped; only vessels are carried.
  const Symbol content = thing->pronoun ? Symbol{kNone} : language_.content(thing->phrase);
  const auto vessels = destination->pronoun  ? pronoun(*destination, Sort::kPlace, {})
                       : destination->bare() ? Objects{}
                                             : resolver_.options(*destination, Sort::kPlace, now_);
  const bool into_dish =
      !vessels.empty() && (resolver_.is_vessel(vessels.front()) || resolver_.class_of(vessels.front())->dish);
  // "put the noodles into the kettle with some water"
  const auto with_the_rest = [&](const Problem& so_far) {
    const NounPhrase* with = clause.first(Role::kWith);
    if (!so_far.empty() || with == nullptr || !into_dish || vessels.empty()) return so_far;
    bool done = false;
    return add_content(*with, history_.empty() ? vessels.front() : history_.back().front(), done);
  };
  if (content != kNone && into_dish && thing->content.empty()) {
    // "I want boiling water in the kettle": where none is hot yet it is heated there
    if (content == kWater && (thing->has("boiling") || thing->has("hot")) &&
        resolver_.is_vessel(vessels.front())) {
      const Symbol has = vessel_with(kWater);
      if (has == kNone || !now_.is(has, ktemperatureHigh)) return with_the_rest(heat(clause, false));
    }
    if (content == kWater || content == kCoffee) return with_the_rest(pour(clause));
    if (content == kIceCream) return with_the_rest(scoop(clause));
    // "serve coke in a glass": a can does not go into a glass, what it holds does
    const bool drink = content == kCoke || content == kEnergyDrink || content == kCanadaDry;
    if (drink && destination->where != Where::kOn && destination->where != Where::kNear)
      return with_the_rest(pour(clause));
    if (content == kSalt || content == kChocolate || content == kVanilla || content == kRamen ||
        content == kEgg || thing->some) {
      Clause only = clause;
      std::erase_if(only.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kWith; });
      return with_the_rest(add_to(only));
    }
  }
  if (content == kWater && !into_dish && vessel_with(kWater) == kNone) {
    if (!vessels.empty() && vessels.front() == kSink)
      return turn_on(kSinkKnob, true, 0);  // "let water into the sink"
    const bool hot = vessels.empty() || resolver_.is_of_class(vessels.front(), "burner");
    if (hot) return heat(clause, true);
  }

  // "serve the ginger ale in the glass": what a can holds, not the can
  if (into_dish && content == kNone && !thing->pronoun && !thing->bare() && !thing->everything &&
      destination->where != Where::kOn && destination->where != Where::kNear) {
    const auto cans = resolver_.options(*thing, Sort::kVessel, now_);
    if (!cans.empty() && resolver_.class_of(cans.front())->drink &&
        std::any_of(now_.facts().begin(), now_.facts().end(), [&](SymFact fact) {
          return relation_of(fact) == Relation::kState && subject_of(fact) == cans.front() &&
                 object_of(fact) >= kWater && object_of(fact) <= kSalt;
        }))
      return with_the_rest(pour(clause));
  }
  // "a pillow on each couch": as many as there are couches; "two pillows on each couch": twice as many
  if (destination->all && !thing->pronoun && !thing->plural && thing->count < 2 && !thing->all &&
      vessels.size() > 1) {
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect) phrase.count = static_cast<int>(vessels.size());
  } else if (destination->all && !thing->pronoun && !thing->all && thing->count > 1 && vessels.size() > 1) {
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect) phrase.count *= static_cast<int>(vessels.size());
  }
  avoid_ = destination->pronoun || destination->bare() ? Objects{} : vessels;
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  avoid_.clear();
  if (!problem.empty()) return problem;
  moves_ = clause.frame == Frame::kBring && objects.size() == 1;
  problem = put_at(clause, objects, *destination);
  moves_ = false;
  if (!problem.empty()) return problem;
  if (const NounPhrase* with = clause.first(Role::kWith);
      at_home_ && with != nullptr && !with->at.empty() && with->at.front().pronoun && !objects.empty()) {
    // "put the plate on the table, with the beer beside it"
    const bool on_it = with->at.front().where == Where::kOn || with->at.front().where == Where::kIn;
    const Objects more = resolver_.chosen(*with, resolver_.options(
                                                     [&] {
                                                       NounPhrase plain = *with;
                                                       plain.at.clear();
                                                       return plain;
                                                     }(),
                                                     Sort::kMovable, now_));
    const Symbol target = on_it ? objects.front() : resolver_.place_of(objects.front(), now_);
    if (more.empty()) return unknown_thing(*with, Sort::kMovable);
    if (target == kNone) return "it is not clear where to put " + with->word;
    for (const Symbol object : more)
      if (problem = keep(object, target, on_it ? with->at.front().where : destination->where);
          !problem.empty())
        return problem;
    return {};
  }
  if (const NounPhrase* with = clause.first(Role::kWith);
      with != nullptr && !last_destination_.empty() && into_dish) {
    bool done = false;
    return add_content(*with, last_destination_.front(), done);
  }
  return {};
}

std::string FrameActions::put_at(const Clause& clause, const Objects& objects,
                                 const NounPhrase& destination) {
  Problem problem;
  Objects targets;
  Where where = destination.where;
  if (where == Where::kNear) {
    // beside a thing: on what it stands on; beside a fixture: on the counter
    Objects beside = destination.pronoun ? pronoun(destination, Sort::kAny, objects) : Objects{};
    if (!destination.pronoun && !destination.bare())
      beside = resolver_.options(destination, Sort::kAny, now_);
    std::erase_if(beside, [&](Symbol object) { return contains(objects, object); });
    if (beside.empty()) return unknown_thing(destination, Sort::kAny);
    Symbol support = resolver_.place_of(beside.front(), now_);
    const bool fixture = beside.front() == kSink || beside.front() == kSinkKnob || beside.front() == kStove ||
                         beside.front() == kMicrowave || beside.front() == kFridge;
    if (support == kNone && (fixture || now_.has(Relation::kIsGraspable, beside.front())))
      support = surface();
    if (support == kNone)
      return "there is nothing beside " + resolver_.name(beside.front()) + " to put things on";
    targets = {support};
    where = now_.has(Relation::kIn, beside.front(), support) ? Where::kIn : Where::kOn;
  } else {
    targets = places(destination, objects, objects.size(), problem);
  }
  if (!problem.empty()) return problem;
  if (where == Where::kUnder && targets.front() != kSink)
    return "things cannot be put under " + resolver_.name(targets.front());
  if (destination.pronoun && destination.word != "there" && where == Where::kTo) where = Where::kOn;
  // Where the place is not said exactly, what is there already may stay.
  Objects all = destination.pronoun ? targets : resolver_.options(destination, Sort::kPlace, now_);
  if (destination.ordinal > 0 || destination.number > 0 || where == Where::kNear) all = targets;
  const bool one_each = destination.all && objects.size() <= targets.size();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Symbol object = objects[i];
    Symbol target = targets[i % targets.size()];
    if (!one_each && objects.size() > 1 && !clause.has("one") &&
        contains(all, resolver_.place_of(object, now_)))
      continue;
    if (!destination.all && destination.count < 2) {
      target = targets.front();
      // several things, one burner each
      if (objects.size() > 1 && resolver_.is_of_class(target, "burner")) target = burner_for(object);
    }
    if (object == kSalt_1 && (resolver_.is_vessel(target) || resolver_.class_of(target)->dish)) {
      if (problem = act({Verb::kAdd, object, target}); !problem.empty()) return problem;
      continue;
    }
    if (now_.has(Relation::kIsSqueezeable, object) &&
        (resolver_.is_vessel(target) || resolver_.class_of(target)->dish)) {
      if (problem = act({Verb::kSqueeze, object, target}); !problem.empty()) return problem;
      continue;
    }
    if (problem = keep(object, target, where); !problem.empty()) return problem;
  }
  last_destination_ = {targets.front()};
  resolver_.remember(targets.size() > 1 && !destination.all ? Objects{targets.front()}
                                                            : targets);  // "the other couch"
  history_.insert(history_.end() - static_cast<long>(history_.empty() ? 0 : 1), last_destination_);
  return {};
}

}  // namespace goalnet::inference
