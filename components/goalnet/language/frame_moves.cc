// What the frames of carrying things about ask for.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

bool contains(const std::vector<Symbol>& list, Symbol symbol) {
  return std::find(list.begin(), list.end(), symbol) != list.end();
}

}  // namespace

std::string FrameActions::go(const Clause& clause) {
  if (about_television(clause)) return television(clause);
  const NounPhrase* phrase = clause.first(Role::kDestination);
  if (phrase == nullptr) phrase = clause.first(Role::kDirect);
  if (phrase == nullptr)
    return clause.to_person ? "it is not known where you are" : "it is not clear where to go";
  Objects options = phrase->pronoun ? pronoun(*phrase, Sort::kAny, {}) : Objects{};
  if (!phrase->pronoun && !phrase->bare() && !phrase->everything)
    options = resolver_.chosen(*phrase, resolver_.options(*phrase, Sort::kAny, now_));
  if (options.empty()) return unknown_thing(*phrase, Sort::kAny);
  remember({options.front()});
  last_destination_ = {options.front()};
  return now_.near(options.front()) ? Problem{} : act({Verb::kMoveTo, options.front()});
}

std::string FrameActions::take(const Clause& clause) {
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.scoop) return scoop(clause);
    if (language_.tv_word(phrase.phrase) && phrase.role == Role::kDirect)
      return television(clause);  // "give me channel 5"
  }
  // "I want the book on the shelf", "gather the pillows on the couch": put it there, unless that says which
  const bool there_or_which = clause.wish || clause.verb == "gather" || clause.verb == "collect";
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      there_or_which && thing != nullptr && !thing->at.empty() && !thing->everything) {
    const int loose = resolver_.doubts().loose;
    const auto there = resolver_.options(*thing, Sort::kMovable, now_);
    const bool content = language_.content(thing->phrase) != kNone && there.empty();
    if ((resolver_.doubts().loose > loose && !there.empty()) || content) {
      resolver_.doubts().loose = loose;
      Clause wanted = clause;
      for (NounPhrase& phrase : wanted.phrases)
        if (phrase.role == Role::kDirect && !phrase.at.empty()) {
          NounPhrase place = phrase.at.front();
          place.role = Role::kDestination;
          phrase.at.clear();
          wanted.phrases.push_back(place);
          break;
        }
      wanted.frame = Frame::kPlace, wanted.to_person = false;
      return put(wanted);
    }
  }
  // "I would like my coffee with vanilla syrup"
  if (const NounPhrase* with = clause.first(Role::kWith); with != nullptr && !with->pronoun && !with->bare())
    if (const NounPhrase* thing = clause.first(Role::kDirect);
        thing != nullptr && !thing->pronoun && !thing->bare()) {
      const auto vessels = resolver_.options(*thing, Sort::kVessel, now_);
      bool done = false;
      if (!vessels.empty() && language_.content(with->phrase) != kNone)
        if (const Problem problem = add_content(*with, vessels.front(), done); !problem.empty())
          return problem;
    }
  // "bring me a glass of water": nothing has it yet
  if (const NounPhrase* thing = clause.first(Role::kDirect); thing != nullptr && !thing->pronoun &&
                                                             !thing->everything &&
                                                             clause.first(Role::kDestination) == nullptr) {
    const Symbol content = language_.content(thing->content.empty() ? thing->phrase : thing->content);
    const bool drink = content == kWater || content == kCoffee;
    if (drink && resolver_.options(*thing, Sort::kMovable, now_).empty()) return make(clause);
  }
  // "take the mug to the sink" says where to put it; "take the mug on the shelf" where it is.
  Clause located = clause;
  for (NounPhrase& phrase : located.phrases) {
    if (phrase.role != Role::kDestination) continue;
    if (phrase.where == Where::kTo || clause.has("into") || clause.has("onto")) return put(clause);
    phrase.role = Role::kSource;
  }
  Problem problem;
  const auto objects = direct(located, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (now_.holds(object)) continue;
    if (problem = act({Verb::kGrasp, object}); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::put(const Clause& said) {
  Clause clause = said;
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
    moved.modifier.clear();
    NounPhrase& place = clause.phrases.front();
    place.role = Role::kDestination, place.where = Where::kOn;
    place.modifier.clear();
    clause.phrases.push_back(moved);
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
          !resolver_.options(phrase, Sort::kMovable, now_).empty()) {
        phrase.role = Role::kDestination, phrase.where = Where::kNear;
        destination = &phrase;
        break;
      }
  // Of two places the first says where it is: "put the cup on the counter in the sink".
  if (places_said > 1)
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination && &phrase != destination) phrase.role = Role::kSource;

  if (destination == nullptr) {
    const bool on = clause.has_particle("on"), off = clause.has_particle("off");
    if (on || off) {
      if (thing != nullptr && !thing->pronoun && !resolver_.options(*thing, Sort::kDevice, now_).empty())
        return turn(clause, on ? 1 : 0);
      if (on && thing != nullptr &&
          resolver_.is_of_class(
              resolver_.named(*thing).empty() ? Symbol{kNone} : resolver_.named(*thing).front(), "kettle"))
        return heat(clause, true);  // "put the kettle on"
    }
    if (clause.verb == "drop" || clause.has_particle("down")) return release(clause);
    if (clause.frame == Frame::kBring || clause.to_person) return take(clause);
    Problem problem;
    const auto objects = direct(clause, Sort::kMovable, problem);
    if (!problem.empty()) return problem;
    if (clause.has_particle("back")) {
      for (const Symbol object : objects) {
        const Symbol place = resolver_.place_of(object, start_);
        if (place == kNone) return "it is not known where " + resolver_.name(object) + " was";
        if (problem = keep(object, place, start_.has(Relation::kIn, object, place) ? Where::kIn : Where::kOn);
            !problem.empty())
          return problem;
      }
      return {};
    }
    if (clause.has_particle("away") || clause.verb == "store" || clause.verb == "stow") {
      for (const Symbol object : objects) {
        const ObjectClass* c = resolver_.class_of(object);
        const bool cold = c->food || c->drink;
        Symbol home = kNone;
        for (const SeenObject& place : resolver_.objects())
          if (home == kNone &&
              ((cold && place.symbol == kFridge) || resolver_.is_of_class(place.symbol, "shelf")))
            home = place.symbol;
        if (home == kNone) return "it is not clear where to put " + resolver_.name(object) + " away";
        if (problem = keep(object, home, home == kFridge ? Where::kIn : Where::kOn); !problem.empty())
          return problem;
      }
      return {};
    }
    return "it is not clear where to put " + resolver_.name(objects.front());
  }
  if (thing == nullptr)
    return clause.frame == Frame::kBring || clause.frame == Frame::kTake || clause.verb == "move"
               ? go(clause)
               : "it is not clear what to put there";
  if (thing->scoop) return scoop(clause);
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
  const auto vessels = destination->pronoun || destination->bare()
                           ? Objects{}
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
  if (content == kWater && !into_dish && vessel_with(kWater) == kNone) return heat(clause, true);

  // "a pillow on each couch": as many as there are couches
  if (destination->all && !thing->pronoun && !thing->plural && thing->count < 2 && !thing->all &&
      vessels.size() > 1)
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect) phrase.count = static_cast<int>(vessels.size());
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
  history_.insert(history_.end() - static_cast<long>(history_.empty() ? 0 : 1), last_destination_);
  return {};
}

std::string FrameActions::discard(const Clause& clause) {
  if (const NounPhrase* to = clause.first(Role::kDestination); to != nullptr) {
    const auto at = to->pronoun || to->bare() ? Objects{} : resolver_.options(*to, Sort::kPlace, now_);
    const bool bin = !at.empty() && (at.front() == kGarbageBin_1 || at.front() == kGarbageBag_1);
    const bool away = clause.has_particle("away") || clause.has_particle("out") || clause.verb == "discard" ||
                      clause.verb == "trash";
    if (bin || !away) return put(clause);
    Clause located = clause;  // "throw away the chips on the couch"
    for (NounPhrase& phrase : located.phrases)
      if (phrase.role == Role::kDestination) phrase.role = Role::kSource;
    return discard(located);
  }
  if (clause.to_person) return take(clause);  // "throw me the remote"
  const bool flung = clause.verb == "throw" || clause.verb == "toss" || clause.verb == "chuck";
  if (flung && !clause.has_particle("away") && !clause.has_particle("out"))
    return "it is not clear where to " + clause.verb + " that; say \"throw ... away\" for the bin";
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const NounPhrase* thing = clause.first(Role::kDirect);
  const Symbol bin = resolver_.exists(kGarbageBin_1) ? Symbol{kGarbageBin_1} : Symbol{kNone};
  if (bin == kNone && content != kNone && thing != nullptr) return pour(clause);
  if (bin == kNone) return not_here("there is no bin here to throw things into");
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (object == bin) return "the bin cannot be thrown into itself";
    if (problem = keep(object, bin, Where::kIn); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::insert(const Clause& clause) {
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (!problem.empty()) return problem;
  if (destination == nullptr) {
    if (resolver_.is_of_class(objects.front(), "cd") && resolver_.exists(resolver_.xbox())) {
      for (const Symbol object : objects)
        if (problem = keep(object, resolver_.xbox(), Where::kIn); !problem.empty()) return problem;
      return {};
    }
    return "it is not clear where to " + clause.verb + " it";
  }
  NounPhrase inside = *destination;
  inside.where = Where::kIn;
  return put_at(clause, objects, inside);
}

std::string FrameActions::release(const Clause& clause) {
  if (clause.first(Role::kDestination) != nullptr) return put(clause);
  Objects objects;
  bool said = false;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect) continue;
    said = true;
    Objects options;
    if (phrase.pronoun || phrase.everything) {
      for (const SymFact fact : now_.facts())
        if (relation_of(fact) == Relation::kGrasping) options.push_back(object_of(fact));
    } else {
      options = resolver_.options(phrase, Sort::kMovable, now_);
      std::erase_if(options, [&](Symbol object) { return !now_.holds(object); });
      options = resolver_.chosen(phrase, options);
    }
    if (options.empty()) return "the robot does not hold that";
    objects.insert(objects.end(), options.begin(), options.end());
  }
  if (!said)
    for (const SymFact fact : now_.facts())
      if (relation_of(fact) == Relation::kGrasping) objects.push_back(object_of(fact));
  if (objects.empty()) return "it is not clear what to let go of";
  for (const Symbol object : objects)
    if (const Problem problem = act({Verb::kRelease, object}); !problem.empty()) return problem;
  return {};
}

std::string FrameActions::swap(const Clause& clause) {
  Problem problem;
  Objects two;
  const NounPhrase* thing = clause.first(Role::kDirect);
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role == Role::kDestination &&
        thing != nullptr) {  // "the pillows on armchair 1 and armchair 3"
      NounPhrase one = *thing;
      one.plural = false, one.count = 0, one.all = false;
      one.at = {phrase};
      const auto found = resolver_.options(one, Sort::kMovable, now_);
      if (!found.empty()) two.push_back(found.front());
    }
  }
  if (two.empty()) {
    two = direct(clause, Sort::kMovable, problem);
    const auto with = role_objects(clause, Role::kWith, Sort::kMovable, problem);
    two.insert(two.end(), with.begin(), with.end());
  }
  if (!problem.empty()) return problem;
  if (two.size() != 2) return "two things are needed to " + clause.verb;
  const Symbol a = two[0], b = two[1], at_a = resolver_.place_of(a, now_), at_b = resolver_.place_of(b, now_);
  if (at_a == kNone || at_b == kNone) return "it is not known where both of them stand";
  const Where to_a = now_.has(Relation::kIn, a, at_a) ? Where::kIn : Where::kOn;
  const Where to_b = now_.has(Relation::kIn, b, at_b) ? Where::kIn : Where::kOn;
  // Where on a place things stand is not known: nothing would tell that they were swapped.
  if (at_a == at_b)
    return resolver_.name(a) + " and " + resolver_.name(b) + " are both at " + resolver_.name(at_a) +
           "; only things at two places can be swapped";
  remember(two);
  if (problem = act({Verb::kGrasp, a}); !problem.empty()) return problem;
  if (problem = keep(b, at_a, to_a); !problem.empty()) return problem;
  return keep(a, at_b, to_b);
}

std::string FrameActions::clear(const Clause& clause) {
  const NounPhrase* place = clause.first(Role::kSource);
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (place == nullptr && thing != nullptr && !thing->at.empty()) place = &thing->at.front();
  if (place == nullptr) place = thing;
  if (place == nullptr) return "it is not clear what to clear";
  auto options = place->pronoun ? pronoun(*place, Sort::kPlace, {})
                                : resolver_.chosen(*place, resolver_.options(*place, Sort::kPlace, now_));
  if (options.empty()) return unknown_thing(*place, Sort::kPlace);
  const bool stove =
      resolver_.is_of_class(options.front(), "burner") && place->ordinal == 0 && place->number == 0;
  if (stove && !place->pronoun) options = resolver_.options(*place, Sort::kPlace, now_);
  Objects there;
  for (const Symbol at : options) {
    if (resolver_.is_vessel(at)) return empty(clause);
    for (const Symbol object : resolver_.things_at(at, now_))
      if (now_.has(Relation::kIsGraspable, object)) there.push_back(object);
  }
  if (place != thing && thing != nullptr && !thing->everything && !thing->pronoun) {
    const auto meant = resolver_.options(*thing, Sort::kMovable, now_);
    std::erase_if(there, [&](Symbol object) { return !contains(meant, object); });
  }
  Symbol target = surface();
  if (contains(options, target)) target = kNone;
  for (const SeenObject& other : resolver_.objects())
    if (target == kNone && resolver_.class_of(other.symbol)->place && !contains(options, other.symbol) &&
        other.symbol != kFridge && other.symbol != kMicrowave && other.symbol != kSink &&
        !now_.has(Relation::kIsGraspable, other.symbol) && !resolver_.is_of_class(other.symbol, "burner"))
      target = other.symbol;
  if (const NounPhrase* to = clause.first(Role::kDestination); to != nullptr) return put(clause);
  if (target == kNone)
    return "it is not clear where to put what is there; say for example \"put everything in the sink\"";
  for (const Symbol object : there)
    if (const Problem problem = keep(object, target, Where::kOn); !problem.empty()) return problem;
  remember(there);
  return {};
}

std::string FrameActions::cool(const Clause& clause) {
  if (!resolver_.exists(kFridge)) return not_here("there is no fridge here");
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    const ObjectClass* c = resolver_.class_of(object);
    if (!c->food && !c->drink && !resolver_.is_vessel(object))
      return resolver_.name(object) + " is nothing to " + clause.verb;
    if (problem = keep(object, kFridge, Where::kIn); !problem.empty()) return problem;
  }
  last_destination_ = {Symbol{kFridge}};
  return {};
}

std::string FrameActions::play(const Clause& clause) {
  if (!resolver_.exists(resolver_.xbox())) return not_here("there is no console here to play on");
  Symbol disc = kNone;
  for (const NounPhrase& phrase : clause.phrases)
    if (!phrase.pronoun && !phrase.bare() && !phrase.everything)
      for (const Symbol option : resolver_.options(phrase, Sort::kMovable, now_))
        if (disc == kNone && resolver_.is_of_class(option, "cd")) disc = option;
  for (const SeenObject& object : resolver_.objects())
    if (disc == kNone && resolver_.is_of_class(object.symbol, "cd")) disc = object.symbol;
  if (disc == kNone) return not_here("there is no disc here to play");
  if (const Problem problem = turn_on(kTv_1, true, 0); !problem.empty()) return problem;
  return keep(disc, resolver_.xbox(), Where::kIn);
}

}  // namespace goalnet::inference
