// Of all that a phrase may mean: what fits best, and how many of it.
#include <algorithm>

#include "components/goalnet/language/resolve.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr int kSlight = 1;        // a place by a word that names another one better
constexpr int kFault = 2;         // of an adjective
constexpr int kGraveFault = 100;  // names another object: wrong number, wrong content
}  // namespace

int number_of(const std::string& name) {
  const std::size_t at = name.find_last_not_of("0123456789");
  if (at == std::string::npos || at + 1 >= name.size() || name.size() - at > 6) return 0;
  return std::stoi(name.substr(at + 1));
}

int Resolver::faults(const NounPhrase& phrase, const SeenObject& seen, const SymState& now) const {
  const Symbol object = seen.symbol;
  int count = 0;
  const auto wants = [&](const char* adjective, bool holds) {
    count += phrase.has(adjective) && !holds ? kFault : 0;
  };
  const ObjectClass& c = lexicon_.object_class(seen.class_id);
  wants("empty", c.place ? !taken(object, now) : is_empty(object, now));
  wants("full", !is_empty(object, now));
  wants("free", !taken(object, now));
  if (language_.hears_people() && phrase.has("free") && start_ && taken(object, *start_)) count += kSlight;
  wants("hot", now.is(object, ktemperatureHigh));
  wants("warm", now.is(object, ktemperatureHigh));
  wants("boiling", now.is(object, ktemperatureHigh));
  wants("cold", !now.is(object, ktemperatureHigh));
  wants("wet", now.is(object, kWater));
  wants("held", now.holds(object));
  wants("clean", !is_empty(object, now) ? now.is(object, kWater) : true);
  const bool spoken = spoken_.empty() ? now.holds(object) || now.near(object) : contains(spoken_, object);
  wants("other", !spoken);
  wants("different", !spoken);
  wants("next", !spoken);
  wants("same", spoken);
  if (object >= kStoveFire_1 && object <= kStoveFire_4)
    wants("lit", now.is(kStove, static_cast<Symbol>(kStoveFire1 + (object - kStoveFire_1))));
  if (phrase.rest && spoken) count += kGraveFault;
  if (phrase.number > 0 && number_of(symbols_.name(object)) != phrase.number &&
      !(phrase.number == 1 && number_of(symbols_.name(object)) == 0))
    count += kGraveFault;
  if (!phrase.content.empty()) {
    const Symbol content = language_.content(phrase.content);
    if (content != kNone && !now.is(object, content)) count += kGraveFault;
  }
  if (!phrase.modifier.empty()) {
    NounPhrase place;
    place.phrase = phrase.modifier;
    const Symbol content = language_.content(phrase.modifier);
    NounPhrase inside;
    inside.phrase = phrase.modifier;
    const bool holds_them = [&] {
      for (const Symbol thing : things_at(object, now))
        if (contains(named(inside), thing)) return true;
      return false;
    }();
    if (language_.hears_people() && phrase.filled_with_things && !holds_them) count += kGraveFault;
    if (!is_at(object, place, now) && !(content != kNone && now.is(object, content)) &&
        lexicon_.names(phrase.modifier, object, seen.class_id) == NameLevel::kNone)
      count += kFault;
  }
  if (language_.hears_people() && phrase.has("open") && object == kBagOfChips_1 && !now.is(object, kIsOpen))
    count += kGraveFault;  // "throw away any open food"
  if (phrase.on_floor && (place_of(object, now) != kNone || now.holds(object)))
    count += phrase.everything ? kGraveFault : kFault;
  // "the coke in the glass" is the glass that holds some
  const Symbol named_content = language_.hears_people() ? language_.content(phrase.phrase) : Symbol{kNone};
  const auto holds_it = [&](const NounPhrase& place) {
    return named_content != kNone && !place.negated && is_vessel(object) && now.is(object, named_content) &&
           place.where != Where::kUnder && !place.pronoun && !place.phrase.empty() &&
           level(place, object, seen.class_id, Sort::kPlace, now) != NameLevel::kNone;
  };
  for (const NounPhrase& place : phrase.at)
    if (holds_it(place))
      continue;
    else if (is_at(object, place, now) == place.negated)
      count += kFault;
    else if (language_.hears_people() && !place.negated && !is_at(object, place, now, true))
      count += kSlight;
  return count;
}

std::vector<Symbol> Resolver::options(const NounPhrase& phrase, Sort sort, const SymState& now) {
  std::vector<Option> found;
  for (const SeenObject& object : instruction_.objects) {
    if (!fits(object.symbol, sort, now)) continue;
    const NameLevel name_level = level(phrase, object.symbol, object.class_id, sort, now);
    if (name_level == NameLevel::kNone) continue;
    const ObjectClass& c = lexicon_.object_class(object.class_id);
    const bool side = object.symbol == kFridgeLeft || object.symbol == kFridgeRight ||
                      (c.name == "garbage_bag" && phrase.phrase == "bag");
    if (sort == Sort::kPlace && !c.place && name_level == NameLevel::kGeneric && !is_vessel(object.symbol) &&
        !side)
      continue;
    if (phrase.everything && sort == Sort::kMovable && c.place) continue;
    double order = distance(object.symbol);
    if (phrase.has("farthest")) order = order < kFar ? -order : kFar;
    if (now.holds(object.symbol) && !phrase.has("other"))
      order -= 3 * kFar;
    else if (now.near(object.symbol))
      order -= phrase.has("farthest") ? -kFar : 0.5;
    found.push_back(
        {object.symbol, faults(phrase, object, now), name_level, order, symbols_.name(object.symbol)});
  }
  if (found.empty()) return {};
  const auto best = std::min_element(found.begin(), found.end(), [](const Option& a, const Option& b) {
    return a.faults != b.faults ? a.faults < b.faults : a.level > b.level;
  });
  const int fewest = best->faults;
  const NameLevel top = best->level;
  if (fewest >= kGraveFault) return {};
  std::erase_if(found, [&](const Option& o) { return o.faults > fewest || o.level < top; });
  std::sort(found.begin(), found.end(), [](const Option& a, const Option& b) {
    return a.order != b.order ? a.order < b.order : a.name < b.name;
  });
  doubts_.loose += fewest > 0;
  doubts_.generic += top == NameLevel::kGeneric && !phrase.everything;
  std::vector<Symbol> result;
  for (const Option& option : found) result.push_back(option.symbol);
  return result;
}

std::vector<Symbol> Resolver::chosen(const NounPhrase& phrase, std::vector<Symbol> options) {
  if (phrase.ordinal == 1 && phrase.count > 1) {  // "the first two burners"
    std::sort(options.begin(), options.end(),
              [&](Symbol a, Symbol b) { return symbols_.name(a) < symbols_.name(b); });
    if (options.size() > static_cast<std::size_t>(phrase.count))
      options.resize(static_cast<std::size_t>(phrase.count), kNone);
    return options;
  }
  if (phrase.ordinal > 0) {
    // "the second armchair": by its name, else the second in the row
    for (const Symbol option : options)
      if (number_of(symbols_.name(option)) == phrase.ordinal) return {option};
    if (options.size() >= static_cast<std::size_t>(phrase.ordinal)) {
      std::sort(options.begin(), options.end(),
                [&](Symbol a, Symbol b) { return symbols_.name(a) < symbols_.name(b); });
      return {options[static_cast<std::size_t>(phrase.ordinal - 1)]};
    }
    return {};
  }
  if (phrase.has("last") && !options.empty()) {
    return {*std::max_element(options.begin(), options.end(),
                              [&](Symbol a, Symbol b) { return symbols_.name(a) < symbols_.name(b); })};
  }
  std::size_t count = 1;
  if (phrase.count > 0)
    count = static_cast<std::size_t>(phrase.count);
  else if (phrase.all || (phrase.plural && !phrase.some))
    count = options.size();
  else if (phrase.some && phrase.plural)
    count = std::min<std::size_t>(2, options.size());
  if (phrase.count > 0 && options.size() < count && !phrase.scoop) {
    if (options.size() + 1 < count || options.empty()) return {};  // "five plates" where there are two
    ++doubts_.loose;
  }
  if (options.size() > count) {
    const bool told = distances_ != nullptr && distance(options[count - 1]) < distance(options[count]);
    doubts_.ties += told ? 0 : 1;
    options.erase(options.begin() + static_cast<long>(count), options.end());
  }
  return options;
}

}  // namespace goalnet::inference
