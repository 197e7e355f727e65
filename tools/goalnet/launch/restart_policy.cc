#include "tools/goalnet/launch/restart_policy.h"

#include <algorithm>
#include <cmath>

namespace goalnet::tools {

RestartPolicy::Decision RestartPolicy::ended(bool failed, double now) {
  using Kind = Decision::Kind;
  const bool wanted =
      params_.when == RestartWhen::kAlways || (params_.when == RestartWhen::kOnFailure && failed);
  if (!wanted) return {failed ? Kind::kGiveUp : Kind::kStayEnded, now};
  while (!restarts_.empty() && now - restarts_.front() > params_.window) restarts_.pop_front();
  if (static_cast<int>(restarts_.size()) >= params_.limit) return {Kind::kGiveUp, now};
  const double delay =
      std::min(params_.longest_delay, params_.delay * std::pow(2.0, static_cast<double>(restarts_.size())));
  restarts_.push_back(now + delay);
  return {Kind::kRestart, now + delay};
}

}  // namespace goalnet::tools
