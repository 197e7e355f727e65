#include "components/planner/symbols.h"

#include <algorithm>

namespace goalnet::planner {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::size_t hash_ignoring_case(std::string_view name) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(lower(c))) * 1099511628211ULL;
  return static_cast<std::size_t>(hash ^ (hash >> 29));
}

std::size_t edit_distance(std::string_view left, std::string_view right) {
  std::vector<std::size_t> row(right.size() + 1);
  for (std::size_t j = 0; j <= right.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= left.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t change = diagonal + (lower(left[i - 1]) == lower(right[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row.back();
}

}  // namespace

bool equal_ignoring_case(std::string_view left, std::string_view right) {
  return left.size() == right.size() &&
         std::equal(left.begin(), left.end(), right.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

std::size_t SymbolTable::slot_of(std::string_view name) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_ignoring_case(name) & mask;
  while (slots_[slot] != kNone && !equal_ignoring_case(names_[static_cast<std::size_t>(slots_[slot])], name)) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void SymbolTable::grow() {
  slots_.assign(std::max<std::size_t>(16, slots_.size() * 2), kNone);
  for (std::size_t id = 0; id < names_.size(); ++id) slots_[slot_of(names_[id])] = static_cast<std::int32_t>(id);
}

std::int32_t SymbolTable::add(std::string_view name) {
  if (2 * (names_.size() + 1) > slots_.size()) grow();
  const std::size_t slot = slot_of(name);
  if (slots_[slot] == kNone) {
    slots_[slot] = size();
    names_.emplace_back(name);
  }
  return slots_[slot];
}

std::int32_t SymbolTable::find(std::string_view name) const {
  return slots_.empty() ? kNone : slots_[slot_of(name)];
}

void SymbolTable::clear() {
  names_.clear();
  std::fill(slots_.begin(), slots_.end(), kNone);
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 64, kMostNames = 5000;  // bounds the work on hostile input
  if (wanted.empty() || wanted.size() > kLongest) return "";
  std::string_view best;
  std::size_t best_distance = wanted.size() / 2 + 1;
  for (std::size_t i = 0; i < names.size() && i < kMostNames; ++i) {
    const std::string& name = names[i];
    if (name.size() > kLongest || name.empty()) continue;
    const std::size_t distance = edit_distance(wanted, name);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return std::string(best);
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(wanted, names);
  return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

}  // namespace goalnet::planner
