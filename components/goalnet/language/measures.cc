// "about 250 ml of water": how much nobody here can measure; what is asked for is the water.
#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/language/word_spans.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::array kUnits = {
    "ml"sv,         "mls"sv,   "millilitre"sv, "millilitres"sv, "milliliter"sv,  "milliliters"sv, "cl"sv,
    "dl"sv,         "l"sv,     "litre"sv,      "litres"sv,      "liter"sv,       "liters"sv,      "g"sv,
    "gram"sv,       "grams"sv, "gramme"sv,     "grammes"sv,     "oz"sv,          "ounce"sv,       "ounces"sv,
    "tablespoon"sv, "tbsp"sv,  "teaspoon"sv,   "tsp"sv,         "tablespoons"sv, "teaspoons"sv};

bool number(const std::string& word) {
  return !word.empty() &&
         (word.find_first_not_of("0123456789/") == std::string::npos || number_word(word) > 0);
}

// "250ml" in one word.
bool number_with_unit(const std::string& word) {
  const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
  return digits > 0 && digits < word.size() && one_of(word.substr(digits), kUnits);
}

}  // namespace

void drop_measures(Sentence& words, const Language& language) {
  for (std::size_t at = 0; at < words.size(); ++at) {
    const WordSpans spans(words, language);
    std::size_t i = spans.phrase(at, {"about", "approximately", "around", "roughly", "some", "exactly",
                                      "precisely", "nearly", "almost", "at least", "up to", "circa"});
    std::size_t unit = i;
    if (i < words.size() && number_with_unit(words[i])) {
      unit = i + 1;
    } else {
      while (i < words.size() && (number(words[i]) || spans.is_one(i, {"a", "half", "quarter", "hundred"})))
        ++i;
      if (i == unit || i >= words.size() || !one_of(words[i], kUnits)) continue;
      unit = i + 1;
    }
    const bool content = spans.is(unit, "of") && spans.name(unit + 1) > 0;
    const bool said_after = spans.begins(at) && at > 0 && spans.ends(unit);  // "water, about 250 ml"
    if (!content && !said_after && spans.name(unit) == 0) continue;
    replace(words, said_after ? at - 1 : at, content ? unit + 1 : unit, {});
  }
}

}  // namespace goalnet::inference
