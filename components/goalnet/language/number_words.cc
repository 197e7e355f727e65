// Numbers, ordinals and prepositions of place.
#include <algorithm>
#include <array>
#include <utility>

#include "components/goalnet/language/noun_phrase.h"

namespace goalnet::inference {

using std::string_view_literals::operator""sv;

namespace {

constexpr int kMostCounted = 20;

}  // namespace

int number_word(const std::string& word) {
  static constexpr std::array kWords = {"one"sv,   "two"sv,   "three"sv, "four"sv, "five"sv,   "six"sv,
                                        "seven"sv, "eight"sv, "nine"sv,  "ten"sv,  "eleven"sv, "twelve"sv};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (kWords[i] == word) return static_cast<int>(i) + 1;
  if (word == "couple" || word == "both") return 2;
  if (word.empty() || word.size() > 2 || word.find_first_not_of("0123456789") != std::string::npos) return 0;
  return std::min(std::stoi(word), kMostCounted);
}

int ordinal_word(const std::string& word) {
  static constexpr std::array kWords = {"first"sv, "second"sv, "third"sv, "fourth"sv, "fifth"sv, "sixth"sv};
  static constexpr std::array kDigits = {"1st"sv, "2nd"sv, "3rd"sv, "4th"sv, "5th"sv, "6th"sv};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (kWords[i] == word || kDigits[i] == word) return static_cast<int>(i) + 1;
  return 0;
}

bool place_preposition(const std::string& word, Where* where) {
  static constexpr std::array<std::pair<std::string_view, Where>, 26> kPlaces = {{
      {"on", Where::kOn},       {"onto", Where::kOn},       {"upon", Where::kOn},
      {"over", Where::kOn},     {"atop", Where::kOn},       {"in", Where::kIn},
      {"into", Where::kIn},     {"inside", Where::kIn},     {"within", Where::kIn},
      {"to", Where::kTo},       {"toward", Where::kTo},     {"at", Where::kTo},
      {"near", Where::kNear},   {"by", Where::kNear},       {"beside", Where::kNear},
      {"nearby", Where::kNear}, {"behind", Where::kNear},   {"under", Where::kUnder},
      {"below", Where::kUnder}, {"beneath", Where::kUnder}, {"underneath", Where::kUnder},
      {"towards", Where::kTo},  {"along", Where::kNear},    {"between", Where::kNear},
      {"among", Where::kNear},  {"against", Where::kNear},
  }};
  for (const auto& [name, value] : kPlaces)
    if (name == word) {
      if (where != nullptr) *where = value;
      return true;
    }
  return false;
}

}  // namespace goalnet::inference
