#include "components/messages/conversions.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace goalnet::messages {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

Expected<void> check_size(std::size_t size, std::size_t most, const char* what) {
  if (size <= most) return {};
  return fail(Outcome::kInvalidRequest, "a message with " + std::to_string(size) + " " + what + "; at most " +
                                            std::to_string(most) + " are taken");
}

template <class To, class From>
std::vector<To> converted(const From& list) {
  std::vector<To> result;
  result.reserve(list.size());
  for (const auto& item : list) {
    if constexpr (requires { to_message(item); }) {
      result.push_back(to_message(item));
    } else {
      result.push_back(from_message(item));
    }
  }
  return result;
}

}  // namespace

goalnet_msgs::msg::Predicate to_message(const Predicate& predicate) {
  goalnet_msgs::msg::Predicate message;
  message.relation(predicate.relation);
  message.subject(predicate.subject);
  message.object(predicate.object);
  return message;
}

Predicate from_message(const goalnet_msgs::msg::Predicate& message) {
  return {message.relation(), message.subject(), message.object()};
}

std::vector<goalnet_msgs::msg::Predicate> to_message(const std::vector<Predicate>& predicates) {
  return converted<goalnet_msgs::msg::Predicate>(predicates);
}

std::vector<goalnet_msgs::msg::Predicate> to_message(const FactSet& facts) {
  return converted<goalnet_msgs::msg::Predicate>(facts);
}

std::vector<Predicate> from_message(const std::vector<goalnet_msgs::msg::Predicate>& message) {
  return converted<Predicate>(message);
}

goalnet_msgs::msg::SymbolicAction to_message(const Action& action) {
  goalnet_msgs::msg::SymbolicAction message;
  message.name(action.name);
  message.arguments(action.arguments);
  return message;
}

Action from_message(const goalnet_msgs::msg::SymbolicAction& message) { return {message.name(), message.arguments()}; }

std::vector<goalnet_msgs::msg::SymbolicAction> to_message(const std::vector<Action>& actions) {
  return converted<goalnet_msgs::msg::SymbolicAction>(actions);
}

std::vector<Action> from_message(const std::vector<goalnet_msgs::msg::SymbolicAction>& message) {
  return converted<Action>(message);
}

void fill(goalnet_msgs::msg::WorldState& message, const WorldState& world) {
  std::vector<std::string> objects = world.objects;
  std::sort(objects.begin(), objects.end());
  message.objects(std::move(objects));
  message.facts(to_message(world.facts));
}

Expected<WorldState> from_message(const goalnet_msgs::msg::WorldState& message) {
  if (auto checked = check_size(message.objects().size(), kMaxObjects, "objects"); !checked) {
    return tl::unexpected<Error>(std::move(checked.error()));
  }
  if (auto checked = check_size(message.facts().size(), kMaxFacts, "facts"); !checked) {
    return tl::unexpected<Error>(std::move(checked.error()));
  }
  return WorldState{message.objects(), FactSet(from_message(message.facts()))};
}

void fill(goalnet_msgs::msg::GoalPredicates& message, const Goal& goal) {
  message.positive(to_message(goal.positive));
  message.negative(to_message(goal.negative));
  message.confidence(goal.confidence);
}

Expected<Goal> goal_from_message(const goalnet_msgs::msg::GoalPredicates& message) {
  const std::size_t size = message.positive().size() + message.negative().size();
  if (auto checked = check_size(size, kMaxGoalSize, "goal predicates"); !checked) {
    return tl::unexpected<Error>(std::move(checked.error()));
  }
  Goal goal;
  goal.positive = from_message(message.positive());
  goal.negative = from_message(message.negative());
  goal.confidence = std::isfinite(message.confidence()) ? std::clamp(message.confidence(), 0.0, 1.0) : 0.0;
  return goal;
}

std::int64_t to_nanoseconds(const builtin_interfaces::msg::Time& stamp) {
  return std::int64_t{stamp.sec()} * kNanosecondsPerSecond + stamp.nanosec();
}

builtin_interfaces::msg::Time to_stamp(std::int64_t nanoseconds) {
  // Rounds down, so that the fraction is never negative.
  std::int64_t seconds = nanoseconds / kNanosecondsPerSecond;
  std::int64_t rest = nanoseconds % kNanosecondsPerSecond;
  if (rest < 0) {
    --seconds;
    rest += kNanosecondsPerSecond;
  }
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(seconds));
  stamp.nanosec(static_cast<std::uint32_t>(rest));
  return stamp;
}

}  // namespace goalnet::messages
