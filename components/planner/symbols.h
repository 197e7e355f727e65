// Names and numbers for them. PDDL names are case-insensitive; the first spelling seen is the one printed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "components/planner/arena.h"
#include "components/planner/chunks.h"
#include "components/planner/hash_index.h"

namespace goalnet::planner {

// Interns names: 0, 1, 2, ... in order of arrival. Look-up ignores case. Not thread-safe while adding.
class SymbolTable {
 public:
  static constexpr std::int32_t kNone = -1;

  SymbolTable() = default;
  SymbolTable(SymbolTable&&) = default;
  SymbolTable& operator=(SymbolTable&&) = default;

  // The number of `name`, adding it if new.
  std::int32_t add(std::string_view name);
  // The number of `name`, or kNone.
  std::int32_t find(std::string_view name) const;

  std::string name(std::int32_t id) const { return std::string(view(id)); }
  std::string_view view(std::int32_t id) const { return names_[static_cast<std::size_t>(id)]; }
  std::int32_t size() const { return static_cast<std::int32_t>(names_.size()); }
  // The first of them, as many as did_you_mean() looks at.
  std::vector<std::string> first_names() const;
  void clear();

 private:
  Arena text_;
  Chunks<std::string_view> names_;
  HashIndex index_;
};

bool equal_ignoring_case(std::string_view left, std::string_view right);

// What a person most likely meant: the name with the smallest edit distance to `wanted`, or "" if none is
// near (more than half of the letters differ). Looks at the first kMostNames names.
inline constexpr std::size_t kMostNames = 5000;
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names);

// " (did you mean X?)", or "".
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace goalnet::planner
