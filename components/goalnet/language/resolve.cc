#include "components/goalnet/language/resolve.h"

#include <algorithm>

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
      return c->place || c->dish || c->vessel || c->name == "xbox" || c->name == "garbage_bag";
    case Sort::kDevice:
      return std::find(c->kinds.begin(), c->kinds.end(), "device") != c->kinds.end();
    case Sort::kVessel:
      return movable && (c->vessel || c->dish);
  }
  return false;
}

std::vector<Symbol> Resolver::all(Sort sort, const SymState& now) const {
  std::vector<Symbol> result;
  for (const SeenObject& object : instruction_.objects)
    if (fits(object.symbol, sort, now)) result.push_back(object.symbol);
  return result;
}

bool Resolver::is_at(Symbol object, const std::string& place_phrase, const SymState& now) const {
  for (const SymFact fact : now.facts()) {
    if (relation_of(fact) != Relation::kOn && relation_of(fact) != Relation::kIn) continue;
    if (subject_of(fact) != object) continue;
    const int place = instruction_.find(object_of(fact));
    if (place < 0) continue;
    const SeenObject& seen = instruction_.objects[static_cast<std::size_t>(place)];
    if (lexicon_.names(place_phrase, seen.symbol, seen.class_id) != NameLevel::kNone) return true;
  }
  return false;
}

bool Resolver::is_empty(Symbol object, const SymState& now) const {
  for (Symbol content = kWater; content <= kEgg; ++content)
    if (now.is(object, content)) return false;
  return true;
}

std::vector<Symbol> Resolver::options(const NounPhrase& phrase, Sort sort, const SymState& now,
                                      const NounPhrase* source) const {
  struct Option {
    Symbol symbol;
    int cost;
    std::string name;
  };
  std::vector<Option> found;
  NameLevel best = NameLevel::kNone;
  for (const SeenObject& object : instruction_.objects) {
    const NameLevel level = lexicon_.names(phrase.phrase, object.symbol, object.class_id);
    if (level == NameLevel::kNone || !fits(object.symbol, sort, now)) continue;
    const ObjectClass& c = lexicon_.object_class(object.class_id);
    if (sort == Sort::kPlace && !c.place && level == NameLevel::kGeneric) continue;
    if (level > best) best = level, found.clear();
    if (level < best) continue;
    int cost = 0;
    for (const std::string& adjective : phrase.adjectives) {
      if (adjective == "empty" && !is_empty(object.symbol, now)) cost += 100;
      if (adjective == "full" && is_empty(object.symbol, now)) cost += 100;
      if ((adjective == "near" || adjective == "nearest" || adjective == "closest") &&
          !now.near(object.symbol))
        cost += 50;
      if (adjective == "other" && (now.holds(object.symbol) || now.near(object.symbol))) cost += 50;
    }
    if (!phrase.modifier.empty() && is_at(object.symbol, phrase.modifier, now)) cost -= 200;
    if (source != nullptr && !source->phrase.empty() && is_at(object.symbol, source->phrase, now))
      cost -= 200;
    if (now.holds(object.symbol))
      cost -= 4;
    else if (now.near(object.symbol))
      cost -= 2;
    found.push_back({object.symbol, cost, symbols_.name(object.symbol)});
  }
  std::sort(found.begin(), found.end(), [](const Option& a, const Option& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.name < b.name;
  });
  // What is said of a thing ("empty", "from the shelf") binds: others are left out when some fit.
  if (!found.empty()) {
    const bool strict = found.front().cost < 50;
    std::erase_if(found, [&](const Option& o) {
      return (strict && o.cost >= 50) || (found.front().cost <= -200 && o.cost > -150);
    });
  }
  std::vector<Symbol> result;
  for (const Option& option : found) result.push_back(option.symbol);
  return result;
}

std::vector<Symbol> Resolver::chosen(const NounPhrase& phrase, std::vector<Symbol> options) const {
  if (phrase.ordinal > 0 && options.size() >= static_cast<std::size_t>(phrase.ordinal))
    return {options[static_cast<std::size_t>(phrase.ordinal - 1)]};
  std::size_t count = 1;
  if (phrase.all || (phrase.plural && phrase.count == 0))
    count = options.size();
  else if (phrase.count > 0)
    count = static_cast<std::size_t>(phrase.count);
  if (options.size() > count) options.erase(options.begin() + static_cast<long>(count), options.end());
  return options;
}

}  // namespace goalnet::inference
