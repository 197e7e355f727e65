#include "components/world_model/world_model_parameters.h"

namespace goalnet::world_model {
namespace {

class Declarer {
 public:
  explicit Declarer(ros::Node& node) : node_(node) {}

  void number(const std::string& name, double& value, const std::string& description, double from,
              double to) {
    keep(node_.declare_parameter<double>(
             name, value,
             {.description = description, .read_only = true, .range = ros::ParameterRange{from, to}}),
         value);
  }
  void threshold(const std::string& name, Threshold& value, const std::string& description, double to) {
    number(name + ".enter", value.enter, description + ": begins", 0.0, to);
    number(name + ".exit", value.exit, description + ": ends", 0.0, to);
    if (result && value.exit < value.enter)
      result = fail(Outcome::kInvalidRequest,
                    "parameter " + name + ".exit must not be less than " + name + ".enter");
  }
  template <class T>
  void plain(const std::string& name, T& value, const std::string& description) {
    keep(node_.declare_parameter<T>(name, value, {.description = description, .read_only = true}), value);
  }

  Expected<void> result = {};

 private:
  template <class T>
  void keep(const Expected<T>& declared, T& value) {
    if (declared)
      value = *declared;
    else if (result)
      result = tl::unexpected(declared.error());
  }
  ros::Node& node_;
};

}  // namespace

Expected<DeclaredParams> declare_parameters(ros::Node& node) {
  Declarer declare(node);
  DeclaredParams params{{}, "kitchen", "default"};
  Params& core = params.node.core;
  declare.plain("scene", params.scene, "scene: a name in config/scenes or a file");
  declare.plain("robot", params.robot, "robot: a name in config/robots or a file");
  declare.number("rate", params.node.rate, "how often facts are computed at most [Hz]", 1.0, 1000.0);
  declare.number("stale_after", params.node.stale_after, "age of an observation that counts as lost [s]",
                 0.01, 60.0);
  declare.threshold("surface_gap", core.surface_gap, "On: gap between object and surface [m]", 0.5);
  declare.threshold("edge", core.edge, "On, In: middle of the object outside the edge [m]", 0.5);
  declare.number("resting_speed", core.resting_speed, "On, In begin below this speed [m/s]", 0.0, 10.0);
  declare.threshold("near_object", core.near_object, "Near: base to object [m]", 10.0);
  declare.threshold("near_support", core.near_support, "Near: base to the small support of an object [m]",
                    10.0);
  declare.number("small_support", core.small_support, "longest side of a support judged as a whole [m]", 0.0,
                 10.0);
  declare.threshold("near_fixture", core.near_fixture, "Near: base to fixture [m]", 10.0);
  declare.threshold("near_bearing", core.near_bearing, "Near: direction off the robot's front [rad]", 3.15);
  declare.threshold("finger_gap", core.finger_gap, "Held: material short of a finger pad [m]", 0.1);
  declare.number("grip_slip", core.grip_slip, "Held: shift against the hand between observations [m]", 0.0,
                 0.1);
  declare.number("grip_time", core.grip_time, "Held: how long contact must last [s]", 0.0, 5.0);
  declare.number("object_timeout", core.object_timeout, "an object unseen for longer is unknown [s]", 0.01,
                 3600.0);
  declare.plain("static_properties", core.static_properties, "model properties that become one-place facts");
  if (!declare.result) return tl::unexpected(declare.result.error());
  if (params.robot.empty()) params.robot = "default";
  return params;
}

}  // namespace goalnet::world_model
