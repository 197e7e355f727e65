#include "components/goalnet/language/resolve.h"

#include <algorithm>

#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

}  // namespace

const ObjectClass* Resolver::class_of(Symbol object) const {
  const int found = instruction_.find(object);
  return found < 0 ? nullptr
                   : &lexicon_.object_class(instruction_.objects[static_cast<std::size_t>(found)].class_id);
}

bool Resolver::is_of_class(Symbol object, std::string_view class_name) const {
  const ObjectClass* c = class_of(object);
  return c != nullptr && c->name == class_name;
}

bool Resolver::is_vessel(Symbol object) const {
  const ObjectClass* c = class_of(object);
  return c != nullptr && (c->vessel || c->name == "bowl");
}

double Resolver::distance(Symbol object) const {
  if (distances_ == nullptr) return kFar;
  const auto it = distances_->find(symbols_.name(object));
  return it == distances_->end() ? kFar : it->second;
}

void Resolver::remember(const std::vector<Symbol>& objects) {
  for (const Symbol object : objects)
    if (!contains(spoken_, object)) spoken_.push_back(object);
}

bool Resolver::fits(Symbol object, Sort sort, const SymState& now) const {
  const ObjectClass* c = class_of(object);
  if (c == nullptr) return false;
  const bool movable = now.has(Relation::kIsGraspable, object) || now.holds(object);
  switch (sort) {
    case Sort::kAny:
      return true;
    case Sort::kMovable:
      return movable;
    case Sort::kPlace:
      return c->place || c->dish || c->vessel || c->name == "xbox" || c->name == "garbage_bag" ||
             object == kFridgeLeft || object == kFridgeRight;
    case Sort::kDevice:
      return std::find(c->kinds.begin(), c->kinds.end(), "device") != c->kinds.end();
    case Sort::kVessel:
      return movable && is_vessel(object);
  }
  return false;
}

std::vector<Symbol> Resolver::all(Sort sort, const SymState& now) const {
  std::vector<Symbol> result;
  for (const SeenObject& object : instruction_.objects)
    if (fits(object.symbol, sort, now)) result.push_back(object.symbol);
  return result;
}

std::vector<Symbol> Resolver::things_at(Symbol place, const SymState& now) const {
  std::vector<Symbol> result;
  for (const SymFact fact : now.facts())
    if ((relation_of(fact) == Relation::kOn || relation_of(fact) == Relation::kIn) &&
        object_of(fact) == place && subject_of(fact) != place)
      result.push_back(subject_of(fact));
  return result;
}

bool Resolver::taken(Symbol place, const SymState& now) const { return !things_at(place, now).empty(); }

Symbol Resolver::xbox() const {
  for (const SeenObject& object : instruction_.objects)
    if (is_of_class(object.symbol, "xbox")) return object.symbol;
  return kNone;
}

Symbol Resolver::ice_cream() const {
  for (const SeenObject& object : instruction_.objects)
    if (is_of_class(object.symbol, "ice_cream")) return object.symbol;
  return kNone;
}

Symbol Resolver::place_of(Symbol object, const SymState& now) const {
  for (const SymFact fact : now.facts())
    if ((relation_of(fact) == Relation::kOn || relation_of(fact) == Relation::kIn) &&
        subject_of(fact) == object && object_of(fact) != object)
      return object_of(fact);
  return kNone;
}

bool Resolver::is_at(Symbol object, const NounPhrase& place, const SymState& now, bool exactly) const {
  if (place.pronoun || place.phrase.empty()) return true;  // "on it": whatever that is
  const auto fits_place = [&](Symbol at) {
    const int found = instruction_.find(at);
    if (found < 0) return false;
    const SeenObject& seen = instruction_.objects[static_cast<std::size_t>(found)];
    const NameLevel as = level(place, seen.symbol, seen.class_id, Sort::kPlace, now);
    if (as == NameLevel::kNone) return false;
    if (exactly && as == NameLevel::kGeneric && named_exactly(place)) return false;
    const int which = place.number > 0 ? place.number : place.ordinal;
    return which == 0 || number_of(symbols_.name(at)) == which ||
           (number_of(symbols_.name(at)) == 0 && which == 1);
  };
  if (const Symbol content = language_.content(place.phrase);  // "the plate without ice cream on it"
      place.where == Where::kUnder && content != kNone && now.is(object, content) && language_.hears_people())
    return true;
  for (const SymFact fact : now.facts()) {
    if (relation_of(fact) != Relation::kOn && relation_of(fact) != Relation::kIn) continue;
    if (subject_of(fact) == object && fits_place(object_of(fact))) return true;
    // "next to the xbox", "the burner under the kettle"
    if (place.where == Where::kNear && subject_of(fact) == object)
      for (const Symbol other : things_at(object_of(fact), now))
        if (other != object && fits_place(other)) return true;
    if (place.where == Where::kUnder && object_of(fact) == object && fits_place(subject_of(fact)))
      return true;
  }
  return false;
}

// "Couch", where couches are here, means no armchair.
bool Resolver::named_exactly(const NounPhrase& place) const {
  return std::any_of(instruction_.objects.begin(), instruction_.objects.end(), [&](const SeenObject& object) {
    return lexicon_.object_class(object.class_id).place &&
           lexicon_.names(place.phrase, object.symbol, object.class_id) >= NameLevel::kName;
  });
}

bool Resolver::is_empty(Symbol object, const SymState& now) const {
  for (Symbol content = kWater; content <= kEgg; ++content)
    if (now.is(object, content)) return false;
  return true;
}

NameLevel Resolver::level(const NounPhrase& phrase, Symbol object, ClassId class_id, Sort sort,
                          const SymState& now) const {
  if (phrase.everything) return NameLevel::kGeneric;
  NameLevel found = lexicon_.names(phrase.phrase, object, class_id);
  const std::string& name = lexicon_.object_class(class_id).name;
  if (sort == Sort::kPlace) {
    // Things are put on the burners when people say "stove", in the sink when they say "tap".
    if (name == "burner" && lexicon_.is_name_of(phrase.phrase, "stove"))
      found = std::max(found, NameLevel::kName);
    if (name == "sink" && lexicon_.is_name_of(phrase.phrase, "tap") && found == NameLevel::kNone)
      found = NameLevel::kGeneric;
  }
  if (found == NameLevel::kGeneric && phrase.phrase == "drink" && !lexicon_.object_class(class_id).drink)
    return NameLevel::kNone;  // "the drinks" are drinks, not cups that may hold some
  // What is in a cup names the cup.
  if (const Symbol content = language_.content(phrase.phrase);
      content != kNone && sort != Sort::kPlace && found < NameLevel::kName && is_vessel(object))
    return now.is(object, content) ? NameLevel::kName : found;
  return found;
}

std::vector<Symbol> Resolver::named(const NounPhrase& phrase) const {
  std::vector<Symbol> result;
  for (const SeenObject& object : instruction_.objects)
    if (lexicon_.names(phrase.phrase, object.symbol, object.class_id) != NameLevel::kNone)
      result.push_back(object.symbol);
  return result;
}

}  // namespace goalnet::inference
