// What was tried since the instruction began, so that the next try differs from those that failed.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "components/manipulation/world_view.h"

namespace goalnet::manipulation {

// One way in which a hand did something: where its tool was, seen from what it was done to.
struct Try {
  std::string what;  // the action, for example "grasp Mug_1"
  std::size_t arm = 0;
  Pose tool = Pose::Identity();
};

// Tries of an action that failed count as tried until the instruction ends. Those of an action that was done
// count until the step ends, should the same action be asked for again: it did not have the effect that was
// wanted, or did not keep it. Bounded: the oldest are forgotten.
class TriedWays {
 public:
  void begin_instruction();
  void begin_step();
  void begin_action(const std::string& action);
  void end_action(bool done);

  void add(const Try& one);  // belongs to the action that runs; counts when that has ended
  // Whether much the same was tried and counts.
  bool contains(const Try& one) const;
  std::size_t size() const { return tried_.size(); }

 private:
  static constexpr std::size_t kMost = 64;

  std::deque<Try> tried_;
  std::vector<Try> of_this_action_;
  std::string action_;
  std::deque<std::pair<std::string, Try>> done_;  // in this step, with the action
};

}  // namespace goalnet::manipulation
