#include "components/world_model/device_states.h"

#include <algorithm>
#include <cmath>

namespace goalnet::world_model {
namespace {

// A value goes into facts, logs and files: it must be a word.
bool is_word(const std::string& text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

}  // namespace

DeviceStates::DeviceStates(const scene::Scene& scene) {
  for (const scene::JointFact& rule : scene.rules.joint_facts) joints_.push_back({&rule, false, false});
  names_.insert(scene.symbols.begin(), scene.symbols.end());
  for (const scene::Object& object : scene.objects) names_.insert(object.name);
  for (const scene::Fixture& fixture : scene.fixtures) names_.insert(fixture.name);
}

void DeviceStates::set_joint(const std::string& name, double position) {
  if (!std::isfinite(position)) return;
  for (JointState& joint : joints_) {
    if (joint.rule->joint != name) continue;
    joint.seen = true;
    joint.on = joint.on ? position > joint.rule->off_below : position >= joint.rule->on_above;
  }
}

std::size_t DeviceStates::set_states(const std::vector<ObservedState>& states) {
  std::size_t ignored = 0;
  perceived_.clear();
  for (const ObservedState& state : states) {
    if (!names_.contains(state.name)) {
      ++ignored;
      continue;
    }
    for (const std::string& value : state.values) {
      if (is_word(value))
        perceived_.push_back({"state", state.name, value});
      else
        ++ignored;
    }
  }
  return ignored;
}

void DeviceStates::add_facts(std::vector<Predicate>& facts) const {
  for (const JointState& joint : joints_)
    if (joint.on) facts.push_back(joint.rule->fact);
  for (const Predicate& fact : perceived_) {
    const bool by_joint = std::any_of(joints_.begin(), joints_.end(), [&](const JointState& joint) {
      return joint.seen && joint.rule->fact == fact;
    });
    if (!by_joint) facts.push_back(fact);
  }
}

}  // namespace goalnet::world_model
