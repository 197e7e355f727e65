// What devices do, as data: a thin symbolic layer over the physics. All facts are (state subject value).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "components/core/predicate.h"
#include "components/scene/shape.h"

namespace goalnet::scene {

// A fact that follows a joint, with hysteresis: knobs and doors. On at >= on_above, off at <= off_below.
struct JointFact {
  Predicate fact;
  std::string joint;
  double on_above = 0.0;   // [rad or m]
  double off_below = 0.0;  // [rad or m]
};

// A fact that toggles (or cycles through `values`) each time a button is pressed: joint >= pressed_above,
// armed again at <= released_below. Or, on a movable thing (a remote control), a spot that a finger presses.
struct ButtonRule {
  std::string name;    // of a spot on an object, as plans say it: Tv_1Remote_1PowerButton
  std::string object;  // that carries the spot; empty: a joint
  Eigen::Vector3d at =
      Eigen::Vector3d::Zero();  // [m] in the object's frame, on its upper side; pressed along -z
  double radius = 0.0;          // [m] how far off the middle a finger may press;
                                // of several spots the nearest counts
  std::string joint;
  double pressed_above = 0.0;   // [m]
  double released_below = 0.0;  // [m]
  std::string subject;          // Microwave, Tv_1, ...
  enum class Effect { kToggle, kSet, kClear, kNext, kPrevious } effect = Effect::kToggle;
  std::vector<std::string> values;  // one value; for kNext/kPrevious the cycle
  std::vector<Predicate> when;      // all must hold
  std::vector<Predicate> unless;    // none may hold
};

// Facts that cannot hold together with others: while all of `when` hold, `clears` are deleted.
struct ClearRule {
  std::vector<Predicate> when;
  std::vector<Predicate> clears;
};

// A stream of content from an outlet: fills an upright open container whose mouth is below it.
struct FillRule {
  std::vector<Predicate> when;
  std::string part;  // of the fixture, carries the outlet; empty: the fixture itself
  std::string fixture;
  Eigen::Vector3d outlet =
      Eigen::Vector3d::Zero();       // [m] in the frame of the part or fixture; flows straight down
  double reach = 0.6;                // [m] how far below the outlet the mouth may be
  double after = 2.0;                // [s] of uninterrupted flow
  std::vector<std::string> adds;     // Water
  std::vector<std::string> removes;  // temperatureHigh
};

// Something acts on what is in or on a region: heat.
struct RegionRule {
  std::vector<Predicate> when;
  std::vector<Predicate> unless;
  std::string region;
  double after = 2.0;             // [s]
  std::vector<std::string> adds;  // temperatureHigh
  std::vector<std::string> removes;
};

// A movable thing gives a value to another by being brought to it.
struct ContactRule {
  enum class Trigger {
    kPour,     // tilted beyond pour_tilt with its lip above the receiver's mouth
    kInside,   // its lowest point lies in the receiver's cavity, and no hand holds it
    kDip,      // the tip of the tool lies in the source's cavity (scoop: the tool receives)
    kSqueeze,  // as kPour while two fingers press it
  };
  Trigger trigger = Trigger::kPour;
  std::string object;              // the giver (or the tool for kDip); empty: any
  std::string receiver;            // empty: any with a cavity
  std::string moves;               // content value that goes over; empty: all liquid contents
  std::string needs;               // value the giver must have; empty: none
  std::vector<std::string> gives;  // values the receiver gets besides
  std::vector<std::string> loses;  // values the giver loses besides
  double after = 0.5;              // [s]
};

// Something that two hands pull open: both press it between their fingers.
struct TearRule {
  std::string object;
  std::vector<std::string> gives;  // values it gets: IsOpen
  double after = 0.5;              // [s]
};

struct DeviceRules {
  std::vector<JointFact> joint_facts;
  std::vector<ButtonRule> buttons;
  std::vector<ClearRule> clears;
  std::vector<FillRule> fills;
  std::vector<RegionRule> regions;
  std::vector<ContactRule> contacts;
  std::vector<TearRule> tears;
  // The spot of that name on a movable thing; null if there is none.
  const ButtonRule* find_spot(std::string_view name) const;

  std::vector<std::string> contents;  // values that are liquid or loose and run out when tilted
};

}  // namespace goalnet::scene
