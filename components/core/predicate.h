// The one vocabulary from demonstration to robot: (On Mug_1 Sink), (Grasping Robot Mug_1),
// (state SinkKnob TapIsOn). Names are case-sensitive and spelled as the demonstrations spell them.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet {

// A ground fact about the world. `object` is empty for one-place facts such as (IsGraspable Mug_1).
struct Predicate {
  std::string relation;  // On, In, Near, Grasping, state, IsGraspable, ...
  std::string subject;   // the first argument: an object
  std::string object;    // the second argument: an object, or the value of a state

  auto operator<=>(const Predicate&) const = default;
};

// "(On Mug_1 Sink)".
std::string to_string(const Predicate& predicate);

// Parses "(On Mug_1 Sink)", with or without parentheses. Fails with kInvalidRequest for anything but two or
// three words, or for characters other than letters, digits, '_' and '-'.
Expected<Predicate> parse_predicate(std::string_view text);

// A set of facts: sorted and without duplicates. Small, contiguous and cheap to compare.
class FactSet {
 public:
  FactSet() = default;
  explicit FactSet(std::vector<Predicate> facts);

  bool contains(const Predicate& fact) const;
  void insert(const Predicate& fact);
  void erase(const Predicate& fact);
  bool empty() const { return facts_.empty(); }
  std::size_t size() const { return facts_.size(); }
  auto begin() const { return facts_.begin(); }
  auto end() const { return facts_.end(); }
  const std::vector<Predicate>& values() const { return facts_; }

  bool operator==(const FactSet&) const = default;

 private:
  std::vector<Predicate> facts_;
};

// Facts of `left` that `right` lacks.
FactSet difference(const FactSet& left, const FactSet& right);

// What a robot knows of its surroundings at one moment.
struct WorldState {
  std::vector<std::string> objects;
  FactSet facts;
};

// What should hold (positive) and what should not (negative) when a step is over.
struct Goal {
  std::vector<Predicate> positive;
  std::vector<Predicate> negative;
  double confidence = 1.0;  // 0..1, calibrated; 1 where a person gave the goal

  bool empty() const { return positive.empty() && negative.empty(); }
};

bool satisfied(const Goal& goal, const FactSet& facts);

// One step of a plan: ("keep-on", {"Mug_1", "Sink"}).
struct Action {
  std::string name;
  std::vector<std::string> arguments;

  auto operator<=>(const Action&) const = default;
};

// "keep-on Mug_1 Sink".
std::string to_string(const Action& action);

}  // namespace goalnet
