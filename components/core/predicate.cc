#include "components/core/predicate.h"

#include <algorithm>
#include <iterator>

namespace goalnet {
namespace {

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// Quotes at most 60 characters of what a person typed, so that a message stays one line.
std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 60;
  std::string shown(text.substr(0, kShown));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return "\"" + shown + (text.size() > kShown ? "...\"" : "\"");
}

}  // namespace

std::string to_string(const Predicate& predicate) {
  std::string text = "(" + predicate.relation + " " + predicate.subject;
  if (!predicate.object.empty()) text += " " + predicate.object;
  return text + ")";
}

Expected<Predicate> parse_predicate(std::string_view text) {
  std::string_view inner = text;
  const auto trim = [&inner] {
    while (!inner.empty() && (inner.front() == ' ' || inner.front() == '\t')) inner.remove_prefix(1);
    while (!inner.empty() && (inner.back() == ' ' || inner.back() == '\t')) inner.remove_suffix(1);
  };
  trim();
  const bool opened = inner.starts_with('('), closed = inner.ends_with(')');
  if (opened != closed) {
    return fail(Outcome::kInvalidRequest, "predicate " + quoted(text) + " has unbalanced parentheses");
  }
  if (opened) {
    inner.remove_prefix(1);
    if (!inner.empty()) inner.remove_suffix(1);
  }
  std::vector<std::string> words(1);
  for (const char c : inner) {
    if (c == ' ' || c == '\t') {
      if (!words.back().empty()) words.emplace_back();
    } else if (is_name_character(c)) {
      words.back().push_back(c);
    } else {
      return fail(Outcome::kInvalidRequest, "predicate " + quoted(text) +
                                                " has a character that no name has; write it like (On Mug_1 Sink)");
    }
  }
  if (words.back().empty()) words.pop_back();
  if (words.size() != 2 && words.size() != 3) {
    return fail(Outcome::kInvalidRequest, "predicate " + quoted(text) + " has " + std::to_string(words.size()) +
                                              " words; write it like (On Mug_1 Sink) or (state SinkKnob TapIsOn)");
  }
  return Predicate{words[0], words[1], words.size() == 3 ? words[2] : ""};
}

FactSet::FactSet(std::vector<Predicate> facts) : facts_(std::move(facts)) {
  std::sort(facts_.begin(), facts_.end());
  facts_.erase(std::unique(facts_.begin(), facts_.end()), facts_.end());
}

bool FactSet::contains(const Predicate& fact) const {
  return std::binary_search(facts_.begin(), facts_.end(), fact);
}

void FactSet::insert(const Predicate& fact) {
  const auto place = std::lower_bound(facts_.begin(), facts_.end(), fact);
  if (place == facts_.end() || *place != fact) facts_.insert(place, fact);
}

void FactSet::erase(const Predicate& fact) {
  const auto place = std::lower_bound(facts_.begin(), facts_.end(), fact);
  if (place != facts_.end() && *place == fact) facts_.erase(place);
}

FactSet difference(const FactSet& left, const FactSet& right) {
  std::vector<Predicate> result;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(result));
  return FactSet(std::move(result));
}

bool satisfied(const Goal& goal, const FactSet& facts) {
  const auto holds = [&facts](const Predicate& fact) { return facts.contains(fact); };
  return std::all_of(goal.positive.begin(), goal.positive.end(), holds) &&
         std::none_of(goal.negative.begin(), goal.negative.end(), holds);
}

std::string to_string(const Action& action) {
  std::string text = action.name;
  for (const std::string& argument : action.arguments) text += " " + argument;
  return text;
}

}  // namespace goalnet
