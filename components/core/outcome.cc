#include "components/core/outcome.h"

namespace goalnet {

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kDone: return "done";
    case Outcome::kNotUnderstood: return "not_understood";
    case Outcome::kUnknownObject: return "unknown_object";
    case Outcome::kNoPlan: return "no_plan";
    case Outcome::kInvalidRequest: return "invalid_request";
    case Outcome::kBusy: return "busy";
    case Outcome::kTimeLimit: return "time_limit";
    case Outcome::kStepLimit: return "step_limit";
    case Outcome::kCancelled: return "cancelled";
    case Outcome::kMotionFailed: return "motion_failed";
    case Outcome::kWorldStale: return "world_stale";
    case Outcome::kComponentLost: return "component_lost";
    case Outcome::kEmergencyStop: return "emergency_stop";
    case Outcome::kInternal: return "internal_error";
  }
  return "internal_error";
}

Outcome outcome_from_int(int code) {
  const auto outcome = static_cast<Outcome>(code);
  const bool known = to_string(outcome) != "internal_error";
  return known ? outcome : Outcome::kInternal;
}

}  // namespace goalnet
