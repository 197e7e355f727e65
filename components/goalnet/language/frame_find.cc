// Things that nobody names, and what they are: what holds some coffee, a burner for the pot, where to put
// what is in the way.
#include <algorithm>

#include "components/goalnet/language/frame_context.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

Symbol FrameContext::mentioned_content(const Clause& clause, Role role) const {
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == role)
      if (const Symbol content = language_.content(phrase.phrase); content != kNone) return content;
  return kNone;
}

Symbol FrameContext::vessel_with(Symbol content) const {
  Symbol best = kNone;
  for (const Symbol vessel : resolver_.all(Sort::kVessel, now_)) {
    if (!now_.is(vessel, content)) continue;
    if (best == kNone || now_.holds(vessel) ||
        (!now_.holds(best) && resolver_.distance(vessel) < resolver_.distance(best)))
      best = vessel;
  }
  return best;
}

Symbol FrameContext::burner_for(Symbol object) const {
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (now_.has(Relation::kOn, object, burner)) return burner;
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (resolver_.exists(burner) && !resolver_.taken(burner, now_)) return burner;
  return resolver_.exists(kStoveFire_1) ? Symbol{kStoveFire_1} : Symbol{kNone};
}

Symbol FrameContext::first_of_class(std::string_view name) const {
  for (const SeenObject& object : resolver_.objects())
    if (resolver_.is_of_class(object.symbol, name)) return object.symbol;
  return kNone;
}

Symbol FrameContext::surface() const {
  const Symbol counter = first_of_class("counter");
  return counter != kNone ? counter : first_of_class("coffee_table");
}

FrameContext::Objects FrameContext::meant_by(const NounPhrase& phrase, Sort sort) {
  if (phrase.pronoun) return pronoun(phrase, sort, {});
  return phrase.bare() ? Objects{} : resolver_.options(phrase, sort, now_);
}

bool FrameContext::is_vessel_or_dish(Symbol object) const {
  const ObjectClass* c = resolver_.class_of(object);
  return resolver_.is_vessel(object) || (c != nullptr && c->dish);
}

// A can does not go into a glass, what it holds does.
bool FrameContext::is_canned_drink(Symbol content) {
  return content == kCoke || content == kEnergyDrink || content == kCanadaDry;
}

bool FrameContext::lexicon_place(const NounPhrase& phrase) {
  if (phrase.pronoun || phrase.bare() || phrase.everything) return false;
  const auto places = resolver_.options(phrase, Sort::kPlace, now_);
  return !places.empty() && resolver_.class_of(places.front())->place &&
         !now_.has(Relation::kIsGraspable, places.front());
}

bool FrameContext::is_home(Symbol object, Symbol place) const {
  const ObjectClass* c = resolver_.class_of(object);
  for (const std::string& home : language_.homes(c->name))
    if (place != kNone && resolver_.is_of_class(place, home)) return true;
  return false;
}

// Where things of its kind belong, by config/language/english.json; the first such place that is here.
Symbol FrameContext::home_of(Symbol object) const {
  const ObjectClass* c = resolver_.class_of(object);
  for (const std::string& home : language_.homes(c->name))
    for (const SeenObject& place : resolver_.objects())
      if (place.symbol != object && resolver_.is_of_class(place.symbol, home)) return place.symbol;
  return kNone;
}

// "It".
NounPhrase FrameContext::it() {
  NounPhrase phrase;
  phrase.pronoun = true, phrase.word = "it";
  return phrase;
}

// "I want to sit in armchair 2, get the pillow out of the way": the one that is there.
void FrameContext::prefer_there(const Clause& clause, const NounPhrase& phrase, Objects& options) const {
  const bool away = clause.has_particle("away") || clause.has_particle("aside") || clause.has("way");
  if (!at_home_ || !away || phrase.role != Role::kDirect || !phrase.at.empty() || phrase.number > 0 ||
      phrase.ordinal > 0 || last_destination_.empty())
    return;
  std::stable_partition(options.begin(), options.end(), [&](Symbol object) {
    return contains(last_destination_, resolver_.place_of(object, now_));
  });
}

}  // namespace goalnet::inference
