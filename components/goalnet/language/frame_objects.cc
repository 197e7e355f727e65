// Which things and places a clause means, and what "it", "them" and "there" stand for.
#include <algorithm>
#include <array>

#include "components/goalnet/language/frame_context.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

void FrameContext::remember(const Objects& objects) {
  if (objects.empty()) return;
  history_.push_back(objects);
  resolver_.remember(objects);
}

// What "it" and "them" mean: the newest things spoken of that are of the sort.
FrameContext::Objects FrameContext::pronoun(const NounPhrase& phrase, Sort sort,
                                            const Objects& not_these) const {
  const auto fitting = [&](const Objects& from) {
    Objects result;
    const Objects all = resolver_.all(sort, now_);
    for (const Symbol object : from) {
      const bool burner = sort == Sort::kDevice && object >= kStoveFire_1 && object <= kStoveFire_4;
      if ((burner || contains(all, object)) && !contains(not_these, object)) result.push_back(object);
    }
    return result;
  };
  if (phrase.word == "there" && !last_destination_.empty()) return last_destination_;
  Objects found;
  for (auto it = history_.rbegin(); it != history_.rend(); ++it) {
    const Objects fit = fitting(*it);
    for (const Symbol object : fit)
      if (!contains(found, object)) found.push_back(object);
    if (!found.empty() && (!phrase.plural || found.size() > 1)) break;
  }
  if (found.empty()) found = fitting(last_destination_);
  if (found.empty()) {
    Objects held;
    for (const SymFact fact : now_.facts())
      if (relation_of(fact) == Relation::kGrasping) held.push_back(object_of(fact));
    found = fitting(held);
  }
  const bool mass =
      std::all_of(found.begin(), found.end(), [&](Symbol object) { return contains(mass_, object); });
  if (!phrase.plural && found.size() > 1 && !mass) found.erase(found.begin() + 1, found.end());
  if (phrase.count > 0 && found.size() > static_cast<std::size_t>(phrase.count))
    found.resize(static_cast<std::size_t>(phrase.count));
  return found;
}

FrameContext::Objects FrameContext::objects_of(const NounPhrase& phrase, Sort sort, const Clause& clause) {
  if (phrase.pronoun) {
    Objects meant = pronoun(phrase, sort, {});
    // "remove it from the microwave": what is there, where nothing was spoken of
    for (const NounPhrase& source : clause.phrases) {
      const bool it_or_them = phrase.count == 0 && !phrase.all;
      if (!at_home_ || !it_or_them || !meant.empty() || source.role != Role::kSource || source.pronoun ||
          source.bare())
        continue;
      Objects there;
      for (const Symbol place : resolver_.options(source, Sort::kPlace, now_))
        for (const Symbol thing : resolver_.things_at(place, now_)) there.push_back(thing);
      if (there.size() == 1 || phrase.plural) meant = there;
    }
    return meant;
  }
  if (phrase.bare() || phrase.unknown) return {};
  NounPhrase located = phrase;
  for (const NounPhrase& source : clause.phrases)
    if (source.role == Role::kSource && !source.pronoun && phrase.role == Role::kDirect)
      located.at.push_back(source);
  Objects options = resolver_.options(located, sort, now_);
  if (misplaced(clause, located, options)) return {};
  for (const NounPhrase& source : clause.phrases)  // "the pillow from there"
    if (source.role == Role::kSource && source.word == "there" && phrase.role == Role::kDirect) {
      Objects from_there;
      for (const Symbol object : options)
        if (contains(last_destination_, resolver_.place_of(object, now_))) from_there.push_back(object);
      if (!from_there.empty()) options = from_there;
    }
  for (const NounPhrase& source :
       clause.phrases)  // "I want to sit in armchair three, take the pillow off it"
    if (at_home_ && source.role == Role::kSource && source.pronoun && source.word != "there" &&
        phrase.role == Role::kDirect) {
      const Objects there = pronoun(source, Sort::kPlace, {});
      Objects from_it;
      for (const Symbol object : options)
        if (contains(there, resolver_.place_of(object, now_))) from_it.push_back(object);
      if (!from_it.empty()) options = from_it;
    }
  for (const NounPhrase& left_out : clause.phrases) {
    if (left_out.role != Role::kExcept) continue;
    NounPhrase these = left_out;
    if (these.phrase.empty()) these.phrase = phrase.phrase;
    if (at_home_ && lexicon_place(these)) {  // "from all armchairs except the third"
      const Objects places = resolver_.chosen(these, resolver_.options(these, Sort::kPlace, now_));
      std::erase_if(options,
                    [&](Symbol object) { return contains(places, resolver_.place_of(object, now_)); });
      continue;
    }
    const Objects excluded = resolver_.options(these, sort, now_);
    std::erase_if(options, [&](Symbol object) { return contains(excluded, object); });
  }
  // "the coke is finished, throw away the can": of several, what was spoken of
  if (at_home_ && phrase.definite && !phrase.plural && !phrase.all && phrase.count == 0 &&
      phrase.number == 0 && phrase.ordinal == 0 && phrase.adjectives.empty() && phrase.role == Role::kDirect)
    for (auto spoken = history_.rbegin(); spoken != history_.rend(); ++spoken) {
      // "a scoop of ice cream in the bowl, then put the ice cream back": the tub, no bowl of it
      const Objects named = resolver_.named(phrase);
      const bool by_name = !options.empty() && contains(named, options.front());
      const auto told = [&](Symbol object) {
        return contains(*spoken, object) && (!by_name || contains(named, object));
      };
      if (std::none_of(options.begin(), options.end(), told)) continue;
      std::stable_partition(options.begin(), options.end(), told);
      break;
    }
  prefer_there(clause, phrase, options);
  // "put a book on the shelf" means one that is not there yet
  if (!avoid_.empty() && !phrase.plural && !phrase.all && phrase.role == Role::kDirect)
    std::stable_partition(options.begin(), options.end(),
                          [&](Symbol object) { return !contains(avoid_, resolver_.place_of(object, now_)); });
  return resolver_.chosen(phrase, options);
}

// "The book that is on the table" where none is: another one is no answer.
bool FrameContext::misplaced(const Clause& clause, const NounPhrase& phrase, const Objects& options) {
  static constexpr std::array kMoves = {Frame::kTake,    Frame::kPlace,  Frame::kBring,
                                        Frame::kDiscard, Frame::kInsert, Frame::kSwap};
  elsewhere_.clear();
  const auto there = [&](Symbol object) {
    return resolver_.is_where_said(object, phrase, now_) || resolver_.is_where_said(object, phrase, start_);
  };
  // The only one of its name is meant wherever it is.
  if (!at_home_ || phrase.at.empty() || options.size() < 2 || phrase.role != Role::kDirect ||
      std::find(kMoves.begin(), kMoves.end(), clause.frame) == kMoves.end() ||
      std::any_of(options.begin(), options.end(), there))
    return false;
  for (const Symbol object : options)
    if (const Symbol place = resolver_.place_of(object, now_); place != kNone)
      elsewhere_ += ", " + resolver_.name(object) + " is at " + resolver_.name(place);
  elsewhere_ = "no " + phrase.word + " is where the sentence says" + elsewhere_;
  return true;
}

FrameContext::Objects FrameContext::role_objects(const Clause& clause, Role role, Sort sort,
                                                 Problem& problem) {
  Objects objects;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != role || (phrase.alternative && !objects.empty())) continue;
    const Objects chosen = objects_of(phrase, sort, clause);
    if (chosen.empty() && !phrase.alternative && problem.empty())
      problem = elsewhere_.empty() ? unknown_thing(phrase, sort) : not_here(elsewhere_);
    if (!chosen.empty() && phrase.alternative) problem.clear();
    if (!chosen.empty()) resolver_.remember(chosen);  // "a plate and then the other one"
    for (const Symbol object : chosen)
      if (!contains(objects, object)) objects.push_back(object);
  }
  return objects;
}

NounPhrase FrameContext::unsaid() const {
  NounPhrase what = it();
  const auto held = std::count_if(now_.facts().begin(), now_.facts().end(),
                                  [](SymFact fact) { return relation_of(fact) == Relation::kGrasping; });
  what.plural = history_.empty() && held > 1;
  return what;
}

FrameContext::Objects FrameContext::direct(const Clause& clause, Sort sort, Problem& problem) {
  Objects objects = role_objects(clause, Role::kDirect, sort, problem);
  // "bring the pot to the sink and fill with water": a cook's notes leave "it" out
  static constexpr std::array kWithoutIt = {Frame::kFill,  Frame::kWash, Frame::kHeat, Frame::kBoil,
                                            Frame::kEmpty, Frame::kCool, Frame::kPour, Frame::kInsert};
  if (at_home_ && objects.empty() && problem.empty() && !clause.weak && clause.mood == Mood::kCommand &&
      std::find(kWithoutIt.begin(), kWithoutIt.end(), clause.frame) != kWithoutIt.end())
    objects = pronoun(unsaid(), sort, {});
  if (objects.empty() && problem.empty() &&
      (clause.to_person || clause.verb == "bring" || clause.verb == "get" || clause.verb == "fetch") &&
      !history_.empty())  // "take the pillow, give me"
    objects = pronoun(it(), sort, {});
  if (objects.empty() && problem.empty()) problem = "it is not clear what to " + clause.verb;
  if (problem.empty()) remember(objects);
  for (const NounPhrase& phrase :
       clause.phrases)  // "take the books that are not on the shelf and put them there"
    for (const NounPhrase& place : phrase.at)
      if (place.negated && !place.bare())
        if (const Objects there = resolver_.options(place, Sort::kPlace, now_); !there.empty())
          last_destination_ = {there.front()};
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect && phrase.everything) mass_ = objects;
  return objects;
}

// Where things go: as many places as there are things when people say "each", otherwise one; a free one where
// several are equal.
FrameContext::Objects FrameContext::places(const NounPhrase& phrase, const Objects& for_these,
                                           std::size_t wanted, Problem& problem) {
  if (phrase.pronoun) {
    Objects there = pronoun(phrase, Sort::kPlace, for_these);
    // "one plate is in the microwave, put the other one in": not into the plate
    if (at_home_ && !there.empty() && !for_these.empty() && !last_destination_.empty() &&
        resolver_.class_of(there.front()) == resolver_.class_of(for_these.front()))
      there = last_destination_;
    if (there.empty() && problem.empty()) problem = "it is not clear where \"" + phrase.word + "\" is";
    return there;
  }
  Objects options =
      phrase.bare() || phrase.unknown ? Objects{} : resolver_.options(phrase, Sort::kPlace, now_);
  std::erase_if(options, [&](Symbol option) { return contains(for_these, option); });
  // "the other couch": not the one that they stand on
  if (options.size() > 1 && phrase.number == 0 && phrase.ordinal == 0 && !phrase.all &&
      (phrase.has("other") || phrase.has("different") || moves_)) {
    Objects elsewhere = options;
    std::erase_if(elsewhere, [&](Symbol place) {
      return std::any_of(for_these.begin(), for_these.end(),
                         [&](Symbol o) { return resolver_.place_of(o, now_) == place; });
    });
    if (!elsewhere.empty()) options = elsewhere;
  }
  if (phrase.ordinal > 0 || phrase.has("last")) options = resolver_.chosen(phrase, options);
  if (at_home_ && phrase.definite && !phrase.plural &&
      phrase.adjectives.empty())  // "the second couch is full? ... on the couch"
    std::stable_partition(options.begin(), options.end(),
                          [&](Symbol option) { return contains(last_destination_, option); });
  if (options.empty()) {
    if (problem.empty()) problem = unknown_thing(phrase, Sort::kPlace);
    return {};
  }
  // Burners and seats: the free ones first. Of those that stay equal, the one that the things stand on
  // already.
  const ObjectClass* c = resolver_.class_of(options.front());
  if (c != nullptr && (c->name == "burner" || c->name == "armchair"))
    std::stable_partition(options.begin(), options.end(), [&](Symbol place) {
      const Objects there = resolver_.things_at(place, now_);
      return std::all_of(there.begin(), there.end(),
                         [&](Symbol thing) { return contains(for_these, thing); });
    });
  if (wanted > 1 && (phrase.all || phrase.count > 1 || phrase.plural)) return options;
  options.erase(options.begin() + 1, options.end());
  return options;
}

}  // namespace goalnet::inference
