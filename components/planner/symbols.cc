#include "components/planner/symbols.h"

#include <algorithm>

namespace goalnet::planner {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::uint64_t hash_ignoring_case(std::string_view name) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(lower(c))) * 1099511628211ULL;
  return hash ^ (hash >> 29);
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
  return left.size() == right.size() && std::equal(left.begin(), left.end(), right.begin(),
                                                   [](char a, char b) { return lower(a) == lower(b); });
}

std::int32_t SymbolTable::add(std::string_view name) {
  const std::int32_t next = size();
  const std::int32_t id = index_.find_or_add(
      hash_ignoring_case(name), next,
      [&](std::int32_t other) { return equal_ignoring_case(view(other), name); },
      [this](std::int32_t other) { return hash_ignoring_case(view(other)); });
  if (id == next) names_.push_back(text_.copy_text(name));
  return id;
}

std::int32_t SymbolTable::find(std::string_view name) const {
  return index_.find(hash_ignoring_case(name),
                     [&](std::int32_t id) { return equal_ignoring_case(view(id), name); });
}

std::vector<std::string> SymbolTable::first_names() const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < names_.size() && i < kMostNames; ++i) result.emplace_back(names_[i]);
  return result;
}

void SymbolTable::clear() {
  names_.clear();
  text_.clear();
  index_.clear();
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 64;  // with kMostNames bounds the work on hostile input
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
