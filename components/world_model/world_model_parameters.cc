#include "components/world_model/world_model_parameters.h"

#include "components/world_model/world_model_node.h"

namespace goalnet::world_model {
namespace {

// The thresholds by name; one list for the table and for the check.
struct NamedThreshold {
  const char* name;
  Threshold Params::*member;
  const char* description;
  double to;
};
constexpr NamedThreshold kThresholds[] = {
    {"surface_gap", &Params::surface_gap, "On: gap between object and surface [m]", 0.5},
    {"edge", &Params::edge, "On, In: middle of the object outside the edge [m]", 0.5},
    {"near_object", &Params::near_object, "Near: base to object [m]", 10.0},
    {"near_support", &Params::near_support, "Near: base to the small support of an object [m]", 10.0},
    {"near_fixture", &Params::near_fixture, "Near: base to fixture [m]", 10.0},
    {"near_bearing", &Params::near_bearing, "Near: direction off the robot's front [rad]", 3.15},
    {"finger_gap", &Params::finger_gap, "Held: material short of a finger pad [m]", 0.1},
};

}  // namespace

void WorldModelNode::describe(ros::ParameterSet& set, Params& params) {
  world_model::Params& core = params.session.core;
  set.text("scene", params.scene, "room that is observed", "a name in config/scenes or a file");
  set.text("robot", params.robot, "robot that is observed", "a name in config/robots or a file");
  set.number("rate", params.session.rate, "how often facts are computed at most [Hz]", 1.0, 1000.0);
  set.number("stale_after", params.session.stale_after, "age of an observation that counts as lost [s]", 0.01,
             60.0);
  for (const NamedThreshold& one : kThresholds) {
    Threshold& threshold = core.*one.member;
    const std::string name = one.name, text = one.description;
    set.number(name + ".enter", threshold.enter, text + ": begins", 0.0, one.to);
    set.number(name + ".exit", threshold.exit, text + ": ends; not less than " + name + ".enter", 0.0,
               one.to);
  }
  set.number("resting_speed", core.resting_speed, "On, In begin below this speed [m/s]", 0.0, 10.0);
  set.number("small_support", core.small_support, "longest side of a support judged as a whole [m]", 0.0,
             10.0);
  set.number("grip_slip", core.grip_slip, "Held: shift against the hand between observations [m]", 0.0, 0.1);
  set.number("grip_time", core.grip_time, "Held: how long contact must last [s]", 0.0, 5.0);
  set.number("object_timeout", core.object_timeout, "an object unseen for longer is unknown [s]", 0.01,
             3600.0);
  set.texts("static_properties", core.static_properties, "model properties that become one-place facts");
}

Expected<void> check_thresholds(const Params& params) {
  for (const NamedThreshold& one : kThresholds) {
    const Threshold& threshold = params.*one.member;
    if (threshold.exit < threshold.enter) {
      return fail(Outcome::kInvalidRequest, std::string("parameter ") + one.name +
                                                ".exit must not be less than " + one.name + ".enter");
    }
  }
  return {};
}

}  // namespace goalnet::world_model
