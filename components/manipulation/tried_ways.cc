#include "components/manipulation/tried_ways.h"

#include <algorithm>

namespace goalnet::manipulation {
namespace {

constexpr double kNear = 0.02;   // [m]
constexpr double kTurned = 0.3;  // [rad]

bool alike(const Try& a, const Try& b) {
  if (a.what != b.what || a.arm != b.arm) return false;
  const Eigen::Quaterniond turn_a(a.tool.linear()), turn_b(b.tool.linear());
  return (a.tool.translation() - b.tool.translation()).norm() < kNear &&
         turn_a.angularDistance(turn_b) < kTurned;
}

}  // namespace

void TriedWays::begin_instruction() {
  tried_.clear();
  begin_step();
}

void TriedWays::begin_step() { done_.clear(); }

void TriedWays::begin_action(const std::string& action) {
  action_ = action;
  of_this_action_.clear();
  for (const auto& [of, one] : done_)
    if (of == action) tried_.push_back(one);
  std::erase_if(done_, [&](const auto& entry) { return entry.first == action; });
  while (tried_.size() > kMost) tried_.pop_front();
}

void TriedWays::end_action(bool done) {
  for (Try& one : of_this_action_) {
    if (done) {
      done_.emplace_back(action_, std::move(one));
    } else {
      tried_.push_back(std::move(one));
    }
  }
  of_this_action_.clear();
  while (tried_.size() > kMost) tried_.pop_front();
  while (done_.size() > kMost) done_.pop_front();
}

void TriedWays::add(const Try& one) { of_this_action_.push_back(one); }

bool TriedWays::contains(const Try& one) const {
  return std::any_of(tried_.begin(), tried_.end(), [&](const Try& old) { return alike(old, one); });
}

}  // namespace goalnet::manipulation
