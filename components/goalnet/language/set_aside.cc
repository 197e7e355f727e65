// Readings of a message without the parts that are most likely background.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace word_group;

constexpr double kLeast = 0.5;            // how likely a part that is set aside must be background
constexpr std::size_t kMostReadings = 6;  // that are tried

// Words that change what other parts ask for; a part that has one of them is never set aside.
constexpr std::array kTurnsRequest = {"if"sv,      "unless"sv, "except"sv,   "instead"sv,   "without"sv,
                                      "otherwise"sv, "until"sv,  "till"sv,     "only"sv,      "rather"sv,
                                      "whenever"sv, "hour"sv,   "hours"sv,    "minutes"sv,   "minute"sv,
                                      "mins"sv,    "later"sv,  "tomorrow"sv, "tonight"sv,   "oclock"sv,
                                      "wait"sv,    "sorry"sv,  "actually"sv, "mean"sv,      "every"sv,
                                      "both"sv,    "all"sv,    "each"sv,     "other"sv};
// Nor one that begins with these, but for going on with one that is set aside ("I like glasses, not cans").
constexpr std::array kDenies = {"not"sv, "no"sv, "dont"sv, "never"sv, "nothing"sv, "nobody"sv};

}  // namespace

std::vector<SentencePart> RobotLanguage::parts(const std::vector<std::string>& tokens) const {
  return sentence_parts(tokens, *language_, *lexicon_);
}

std::vector<std::string> RobotLanguage::without(const std::vector<std::string>& tokens,
                                                const std::vector<SentencePart>& parts,
                                                const std::vector<bool>& aside) const {
  return without_parts(tokens, parts, aside, *language_, *lexicon_);
}

std::vector<std::vector<std::string>> RobotLanguage::without_background(
    const std::vector<std::string>& tokens) const {
  const std::vector<SentencePart> parts = this->parts(tokens);
  std::vector<double> likely(parts.size(), 0);
  std::vector<std::size_t> order;  // of those that may be set aside, the likeliest background first
  for (std::size_t p = 0; p < parts.size(); ++p) {
    bool may = true;
    for (std::size_t i = parts[p].begin; i < parts[p].end; ++i) may = may && !one_of(tokens[i], kTurnsRequest);
    if (one_of(tokens[parts[p].begin], kDenies)) may = may && p > 0 && likely[p - 1] >= kLeast;
    if (may) likely[p] = background_.of(parts[p].signs);
    if (likely[p] >= kLeast) order.push_back(p);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return likely[a] > likely[b]; });
  // All of them is the most probable choice, then all but the least sure, and so on.
  std::vector<std::vector<std::string>> readings;
  for (std::size_t count = order.size(); count > 0 && readings.size() < kMostReadings; --count) {
    if (count == parts.size()) continue;  // something must be asked for
    std::vector<bool> aside(parts.size(), false);
    for (std::size_t i = 0; i < count; ++i) aside[order[i]] = true;
    readings.push_back(without(tokens, parts, aside));
  }
  return readings;
}

}  // namespace goalnet::inference
