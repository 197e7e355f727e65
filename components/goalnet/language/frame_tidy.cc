// Throwing away, clearing places, swapping, cooling, playing a game.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::optional<std::string> FrameActions::discard_content(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || thing == nullptr || !thing->everything) return std::nullopt;
  const NounPhrase* in = clause.first(Role::kDestination);
  if (in == nullptr) in = clause.first(Role::kSource);
  if (in == nullptr && thing->at.size() == 1) in = &thing->at.front();
  if (in == nullptr || in->pronoun || in->bare() || in->unknown) return std::nullopt;
  const Objects vessels = resolver_.options(*in, Sort::kVessel, now_);
  if (vessels.empty() || vessels.front() == kGarbageBin_1 || resolver_.taken(vessels.front(), now_))
    return std::nullopt;
  Clause emptied = clause;
  emptied.frame = Frame::kEmpty, emptied.verb = "empty";
  emptied.phrases = {*in};
  emptied.phrases.front().role = Role::kDirect;
  return empty(emptied);
}

std::string FrameActions::discard(const Clause& clause) {
  if (const auto emptied = discard_content(clause)) return *emptied;
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
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      at_home_ && thing != nullptr && !thing->pronoun && !thing->bare() &&
      !(thing->content.empty() && thing->modifier.empty()) && resolver_.exists(kGarbageBin_1) &&
      contains(resolver_.named(*thing), Symbol{kGarbageBin_1})) {  // "throw coke bin"
    Clause away = clause;
    NounPhrase& thrown = away.phrases.front();
    thrown.phrase = thrown.word = thing->modifier.empty() ? thing->content : thing->modifier;
    thrown.modifier.clear(), thrown.content.clear();
    away.verb = "discard";
    return discard(away);
  }
  if (clause.to_person) return take(clause);                                  // "throw me the remote"
  if (clause.has_particle("in") && clause.first(Role::kDirect) != nullptr) {  // "throw in an egg"
    const bool bin_told = !last_destination_.empty() && (last_destination_.front() == kGarbageBin_1 ||
                                                         last_destination_.front() == kGarbageBag_1);
    if (at_home_ && bin_told) {  // "if the beer is not in the bin, throw it in"
      Clause binned = clause;
      binned.particles.clear(), binned.verb = "discard";
      return discard(binned);
    }
    Clause added = clause;
    added.frame = Frame::kAdd, added.verb = "add";
    return add_to(added);
  }
  const bool flung =  // "toss it" is for the bin
      clause.verb == "throw" || (!at_home_ && (clause.verb == "toss" || clause.verb == "chuck"));
  if (flung && !clause.has_particle("away") && !clause.has_particle("out"))
    return "it is not clear where to " + clause.verb + " that; say \"throw ... away\" for the bin";
  if (const NounPhrase* it_said = clause.first(Role::kDirect);
      it_said != nullptr && it_said->pronoun &&
      !content_told_.empty()) {  // "there is coffee in the mug, get rid of it"
    Clause away = clause;
    away.phrases = {*it_said};
    away.phrases.front().pronoun = false,
    away.phrases.front().phrase = away.phrases.front().word = content_told_;
    return pour(away);
  }
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

std::string FrameActions::swap(const Clause& clause) {
  if (at_home_ && clause.has("channel")) return television(clause);  // "swap the channel to four"
  Problem problem;
  Objects two;
  const NounPhrase* thing = clause.first(Role::kDirect);
  for (const NounPhrase& phrase : clause.phrases) {
    if (at_home_ && phrase.role == Role::kDestination && phrase.joined && !lexicon_place(phrase)) {
      thing = &phrase;  // "the pillow on armchair 1 and the one on armchair 3"
    } else if (phrase.role == Role::kDestination &&
               thing != nullptr) {  // "the pillows on armchair 1 and armchair 3"
      NounPhrase one = *thing;
      one.plural = false, one.count = 0, one.all = false;
      one.at = {phrase};
      const auto found = resolver_.options(one, Sort::kMovable, now_);
      if (!found.empty()) two.push_back(found.front());
    }
  }
  if (const auto second = clause.phrases.size() > 1 ? clause.phrases[1] : NounPhrase{};
      two.empty() && thing != nullptr && !thing->at.empty() && second.role == Role::kDirect &&
      lexicon_place(second)) {
    for (const NounPhrase& place :
         {thing->at.front(), second}) {  // "switch the pillows on armchair 1 and armchair 2"
      NounPhrase one = *thing;
      one.plural = false, one.count = 0, one.all = false;
      one.at = {place};
      const auto found = resolver_.options(one, Sort::kMovable, now_);
      if (!found.empty()) two.push_back(found.front());
    }
  }
  if (at_home_ && two.size() == 1)  // "swap the bowl in the microwave for the mug"
    for (const Symbol other : role_objects(clause, Role::kWith, Sort::kMovable, problem))
      two.push_back(other);
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
  const NounPhrase* to = clause.first(Role::kDestination);
  if (place == nullptr && thing != nullptr && thing->everything && to != nullptr && !clause.has("onto") &&
      !clause.has("into") && !clause.has("to")) {  // "clear the stuff on the sofa"
    place = to;
    to = nullptr;
  }
  // but for "the sofa with all that stuff on it"
  if (place == nullptr && thing != nullptr && !thing->at.empty() && !thing->at.front().everything)
    place = &thing->at.front();
  // "clear the coke and the salt away"
  if (place == nullptr && at_home_ && thing != nullptr && clause.has_particle("away") && !thing->pronoun &&
      !thing->bare() && !thing->everything && !lexicon_place(*thing)) {
    Clause put_away = clause;
    put_away.frame = Frame::kPlace, put_away.verb = "put";
    return put(put_away);
  }
  if (place == nullptr) place = thing;
  if (place == nullptr) return "it is not clear what to clear";
  auto options = place->pronoun ? pronoun(*place, Sort::kPlace, {})
                                : resolver_.chosen(*place, resolver_.options(*place, Sort::kPlace, now_));
  if (options.empty()) return unknown_thing(*place, Sort::kPlace);
  if (place->pronoun && place != thing && now_.has(Relation::kIsGraspable, options.front()))
    return "it is not clear where \"" + place->word + "\" is";  // "the mug is dirty, get it all off"
  const bool stove =
      resolver_.is_of_class(options.front(), "burner") && place->ordinal == 0 && place->number == 0;
  if (stove && !place->pronoun) options = resolver_.options(*place, Sort::kPlace, now_);
  Objects there;
  for (const Symbol at : options) {
    if (resolver_.is_vessel(at)) {  // alone: the rest of the clause would lead back to here
      Clause emptied = clause;
      emptied.phrases = {*place};
      emptied.phrases.front().role = Role::kDirect;
      return empty(emptied);
    }
    for (const Symbol object : resolver_.things_at(at, now_))
      if (now_.has(Relation::kIsGraspable, object)) there.push_back(object);
  }
  if (place != thing && thing != nullptr && !thing->everything && !thing->pronoun) {
    Objects meant;
    for (const NounPhrase& named : clause.phrases)
      if (named.role == Role::kDirect && !named.pronoun && !named.bare())
        for (const Symbol object : resolver_.options(named, Sort::kMovable, now_)) meant.push_back(object);
    std::erase_if(there, [&](Symbol object) { return !contains(meant, object); });
  }
  for (const NounPhrase& stays : clause.phrases)  // "clear the couch, only the snacks may stay"
    if (stays.role == Role::kExcept && !stays.pronoun && !stays.bare())
      for (const Symbol object : resolver_.options(stays, Sort::kMovable, now_)) std::erase(there, object);
  Symbol target = surface();
  if (contains(options, target)) target = kNone;
  for (const SeenObject& other : resolver_.objects())
    if (target == kNone && resolver_.class_of(other.symbol)->place && !contains(options, other.symbol) &&
        other.symbol != kFridge && other.symbol != kMicrowave && other.symbol != kSink &&
        !now_.has(Relation::kIsGraspable, other.symbol) && !resolver_.is_of_class(other.symbol, "burner"))
      target = other.symbol;
  if (to != nullptr) return put(clause);
  if (target == kNone)
    return "it is not clear where to put what is there; say for example \"put everything in the sink\"";
  for (const Symbol object : there)
    if (const Problem problem = keep(object, target, Where::kOn); !problem.empty()) return problem;
  remember(there);
  return {};
}

std::string FrameActions::cool(const Clause& clause) {
  if (clause.has_particle("under_tap") && resolver_.exists(kSink)) return wash(clause);
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
