// Which predicates are well-formed: the paper's grammar masks. The tables are learned from demonstrations
// (and from constants.json where it is given) and travel in the model's metadata.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::inference::network {

// The relations a goal can have. Each has one main argument; On and In have a second object, state a value.
enum class GoalRelation : int { kNear = 0, kGrasping = 1, kOn = 2, kIn = 3, kState = 4 };
inline constexpr int kRelations = 5;
// Tokens of the decoder: stop, the five relations that shall hold, the five that shall not.
inline constexpr int kStopToken = 0;
inline constexpr int kTokens = 1 + 2 * kRelations;

constexpr int token_of(GoalRelation relation, bool positive) {
  return 1 + static_cast<int>(relation) + (positive ? 0 : kRelations);
}
constexpr GoalRelation relation_of_token(int token) {
  return static_cast<GoalRelation>((token - 1) % kRelations);
}
constexpr bool is_positive_token(int token) { return token >= 1 && token <= kRelations; }
constexpr bool has_second_object(GoalRelation r) { return r == GoalRelation::kOn || r == GoalRelation::kIn; }

std::string_view to_string(GoalRelation relation);
// -1 for a relation that no goal has (IsGraspable, Held, ...).
int relation_id(std::string_view name);

// The argument that says what a goal is about: the object for Near and Grasping (their subject is the robot).
const std::string& main_argument(const Predicate& predicate);
Predicate make_predicate(GoalRelation relation, const std::string& main, const std::string& second);

class Grammar {
 public:
  // `classes` in the order of the lexicon's classes; `values` all values of states.
  Grammar(std::vector<std::string> values, std::size_t classes);

  void allow(GoalRelation relation, int main_class);
  void allow_second(GoalRelation relation, int second_class);
  void allow_value(int main_class, int value);

  // Class -1 is an unknown class: whatever can be grasped may be grasped, put on and put in; all may be gone
  // to.
  bool main_allowed(GoalRelation relation, int main_class, bool graspable) const;
  bool second_allowed(GoalRelation relation, int second_class) const;
  bool value_allowed(int main_class, int value) const;

  const std::vector<std::string>& values() const { return values_; }
  int value(std::string_view name) const;  // -1 when unknown

  // The metadata "goalnet.grammar"; classes are named.
  std::string to_json(const std::vector<std::string>& classes) const;
  static Expected<Grammar> parse(const std::string& json, const std::vector<std::string>& classes);

 private:
  std::vector<std::string> values_;
  std::array<std::vector<std::uint8_t>, kRelations> main_, second_;  // by class
  std::vector<std::vector<std::uint8_t>> value_;                     // by class, then value
};

}  // namespace goalnet::inference::network
