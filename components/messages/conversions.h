// Between the vocabulary of the cores (components/core) and goalnet_msgs. Every component speaks both.
#pragma once

#include <cstdint>
#include <vector>

#include "builtin_interfaces/msg/Time.h"
#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/Predicate.h"
#include "goalnet_msgs/msg/SymbolicAction.h"
#include "goalnet_msgs/msg/WorldState.h"

namespace goalnet::messages {

// What a message may hold before it is refused as hostile: far above anything real.
constexpr std::size_t kMaxObjects = 10'000;
constexpr std::size_t kMaxFacts = 100'000;
constexpr std::size_t kMaxGoalSize = 10'000;
constexpr std::size_t kMaxActions = 10'000;

goalnet_msgs::msg::Predicate to_message(const Predicate& predicate);
Predicate from_message(const goalnet_msgs::msg::Predicate& message);

std::vector<goalnet_msgs::msg::Predicate> to_message(const std::vector<Predicate>& predicates);
std::vector<goalnet_msgs::msg::Predicate> to_message(const FactSet& facts);
std::vector<Predicate> from_message(const std::vector<goalnet_msgs::msg::Predicate>& message);

goalnet_msgs::msg::SymbolicAction to_message(const Action& action);
Action from_message(const goalnet_msgs::msg::SymbolicAction& message);
std::vector<goalnet_msgs::msg::SymbolicAction> to_message(const std::vector<Action>& actions);
std::vector<Action> from_message(const std::vector<goalnet_msgs::msg::SymbolicAction>& message);

// objects[] and facts[]; the header is the caller's. from_message fails with kInvalidRequest where a limit above is
// passed.
void fill(goalnet_msgs::msg::WorldState& message, const WorldState& world);
Expected<WorldState> from_message(const goalnet_msgs::msg::WorldState& message);

// positive[], negative[] and confidence; all else is the caller's. A confidence that is no number becomes 0.
void fill(goalnet_msgs::msg::GoalPredicates& message, const Goal& goal);
Expected<Goal> goal_from_message(const goalnet_msgs::msg::GoalPredicates& message);

// Nanoseconds of a stamp, and back.
std::int64_t to_nanoseconds(const builtin_interfaces::msg::Time& stamp);
builtin_interfaces::msg::Time to_stamp(std::int64_t nanoseconds);

}  // namespace goalnet::messages
