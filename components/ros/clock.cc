#include "components/ros/clock.h"

namespace goalnet::ros {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// Splits so that the nanoseconds are never negative, as the messages demand.
std::int64_t floor_seconds(std::int64_t ns) {
  return ns >= 0 ? ns / kSecond : -((-ns + kSecond - 1) / kSecond);
}

}  // namespace

builtin_interfaces::msg::Time Time::to_msg() const {
  builtin_interfaces::msg::Time message;
  const std::int64_t whole = floor_seconds(nanoseconds);
  message.sec(static_cast<std::int32_t>(whole));
  message.nanosec(static_cast<std::uint32_t>(nanoseconds - whole * kSecond));
  return message;
}

builtin_interfaces::msg::Duration to_duration_msg(std::chrono::nanoseconds span) {
  builtin_interfaces::msg::Duration message;
  const std::int64_t whole = floor_seconds(span.count());
  message.sec(static_cast<std::int32_t>(whole));
  message.nanosec(static_cast<std::uint32_t>(span.count() - whole * kSecond));
  return message;
}

std::chrono::nanoseconds from_duration_msg(const builtin_interfaces::msg::Duration& message) {
  return std::chrono::nanoseconds(std::int64_t{message.sec()} * kSecond + message.nanosec());
}

Time Clock::now() const {
  if (simulated()) return Time(simulated_ns_.load(std::memory_order_acquire));
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  return Time(std::chrono::duration_cast<std::chrono::nanoseconds>(wall).count());
}

std::int64_t Clock::timer_now() const {
  if (simulated()) return simulated_ns_.load(std::memory_order_acquire);
  const auto steady = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(steady).count();
}

}  // namespace goalnet::ros
