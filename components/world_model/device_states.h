// (state X Value): from joint positions where the scene says how, otherwise as perceived.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/scene/scene.h"
#include "components/world_model/observation.h"

namespace goalnet::world_model {

// Knobs and doors are read from their own joints with the scene's hysteresis (DeviceRules::joint_facts);
// contents, temperature and what buttons switch come with /object_states. A fact that follows a joint is not
// taken from /object_states once the joint has been seen.
class DeviceStates {
 public:
  explicit DeviceStates(const scene::Scene& scene);

  void set_joint(const std::string& name, double position);
  // Replaces what was perceived before. Names that the scene does not have, and values that are no words, are
  // left out; their number is returned.
  std::size_t set_states(const std::vector<ObservedState>& states);

  void add_facts(std::vector<Predicate>& facts) const;

 private:
  struct JointState {
    const scene::JointFact* rule = nullptr;
    bool seen = false;
    bool on = false;
  };
  std::vector<JointState> joints_;
  std::set<std::string> names_;
  std::vector<Predicate> perceived_;
};

}  // namespace goalnet::world_model
