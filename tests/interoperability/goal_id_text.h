// An action goal's id as both processes write it into the log of executions.
#pragma once

#include <cstdio>
#include <string>

#include "components/ros/action_goals.h"

namespace goalnet::ros {

inline std::string to_hex(const GoalId& id) {
  std::string text;
  for (const std::uint8_t byte : id) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    text += digits;
  }
  return text;
}

}  // namespace goalnet::ros
