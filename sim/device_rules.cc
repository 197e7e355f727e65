#include "sim/device_rules.h"

#include <algorithm>
#include <cmath>

#include "sim/device_geometry.h"

namespace goalnet::sim {
namespace {

// Which clock: kind of rule, its index, and the objects concerned.
enum class Clock : std::uint64_t { kFill = 1, kRegion, kContact, kSpill, kTear };
std::uint64_t clock_key(Clock kind, std::size_t rule, std::size_t i, std::size_t j = 0) {
  return (static_cast<std::uint64_t>(kind) << 56) | (rule << 40) | (i << 20) | j;
}

Predicate state(const std::string& subject, const std::string& value) { return {"state", subject, value}; }

}  // namespace

DeviceRules::DeviceRules(const scene::Scene& scene) : scene_(&scene) {
  for (const auto& object : scene.objects) {
    for (const auto& value : object.states) facts_.insert(state(object.name, value));
  }
  for (const auto& fact : scene.initial_facts) facts_.insert(fact);
}

void DeviceRules::set_fact(const Predicate& fact, bool holds) {
  if (holds) {
    facts_.insert(fact);
  } else {
    facts_.erase(fact);
  }
}

void DeviceRules::disable(const std::string& subject, bool dead) {
  if (dead) {
    dead_.insert(subject);
  } else {
    dead_.erase(subject);
  }
}

bool DeviceRules::holds(const std::vector<Predicate>& when, const std::vector<Predicate>& unless) const {
  const auto true_now = [&](const Predicate& fact) { return facts_.contains(fact); };
  return std::all_of(when.begin(), when.end(), true_now) &&
         std::none_of(unless.begin(), unless.end(), true_now);
}

void DeviceRules::set(const std::string& subject, const std::string& value, bool holds) {
  if (!dead_.contains(subject)) set_fact(state(subject, value), holds);
}

bool DeviceRules::elapsed(std::uint64_t key, bool active, double after, double dt) {
  if (!active) {
    clocks_.erase(key);
    return false;
  }
  double& clock = clocks_[key];
  if (clock < 0.0) return false;
  clock += dt;
  if (clock + 1e-9 < after) return false;
  clock = -1.0;
  return true;
}

void DeviceRules::update(const DeviceInput& input, double dt) {
  update_joint_facts(input);
  update_buttons(input);
  for (const auto& rule : scene_->rules.clears) {
    if (!holds(rule.when)) continue;
    for (const auto& fact : rule.clears) set(fact.subject, fact.object, false);
  }
  update_fills(input, dt);
  update_regions(input, dt);
  update_contacts(input, dt);
  update_tears(input, dt);
  update_spills(input, dt);
}

void DeviceRules::update_joint_facts(const DeviceInput& input) {
  for (const auto& rule : scene_->rules.joint_facts) {
    const double q = input.joint(rule.joint);
    if (q >= rule.on_above) set(rule.fact.subject, rule.fact.object, true);
    if (q <= rule.off_below) set(rule.fact.subject, rule.fact.object, false);
  }
}

DeviceRules::Button DeviceRules::state_of(const scene::ButtonRule& rule, const DeviceInput& input) const {
  constexpr double kPress = 0.5;  // [N] a rubber key
  if (rule.object.empty()) {
    const double q = input.joint(rule.joint);
    if (q >= rule.pressed_above) return Button::kPressed;
    return q <= rule.released_below ? Button::kReleased : Button::kBetween;
  }
  for (const Touch& touch : input.touches) {
    if (scene_->objects[touch.object].name != rule.object || touch.force < kPress) continue;
    const double off = (touch.point - rule.at).norm();
    const bool nearest = std::none_of(
        scene_->rules.buttons.begin(), scene_->rules.buttons.end(), [&](const scene::ButtonRule& other) {
          return other.object == rule.object && (touch.point - other.at).norm() < off;
        });
    return nearest && off < rule.radius ? Button::kPressed : Button::kBetween;
  }
  return Button::kReleased;
}

void DeviceRules::update_buttons(const DeviceInput& input) {
  std::set<std::string> pressed;
  for (const auto& rule : scene_->rules.buttons) {
    const Button now = state_of(rule, input);
    auto armed = armed_.try_emplace(rule.name, now == Button::kReleased).first;
    if (now == Button::kReleased) armed->second = true;
    if (now != Button::kPressed || !armed->second) continue;
    pressed.insert(rule.name);  // several rules may share a button: all act on one press
    if (holds(rule.when, rule.unless)) press(rule);
  }
  for (const auto& name : pressed) armed_[name] = false;
}

void DeviceRules::press(const scene::ButtonRule& rule) {
  using Effect = scene::ButtonRule::Effect;
  const std::string& subject = rule.subject;
  if (rule.effect == Effect::kSet || rule.effect == Effect::kClear) {
    for (const auto& value : rule.values) set(subject, value, rule.effect == Effect::kSet);
    return;
  }
  if (rule.effect == Effect::kToggle) {
    for (const auto& value : rule.values) set(subject, value, !facts_.contains(state(subject, value)));
    return;
  }
  const std::size_t count = rule.values.size();
  std::size_t current = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (facts_.contains(state(subject, rule.values[i]))) current = i;
  }
  const std::size_t next = (current + (rule.effect == Effect::kNext ? 1 : count - 1)) % count;
  set(subject, rule.values[current], false);
  set(subject, rule.values[next], true);
}

void DeviceRules::update_fills(const DeviceInput& input, double dt) {
  for (std::size_t r = 0; r < scene_->rules.fills.size(); ++r) {
    const scene::FillRule& rule = scene_->rules.fills[r];
    const bool flows = holds(rule.when);
    const Eigen::Vector3d outlet = outlet_position(*scene_, rule, input.joint);
    const int filled = flows ? vessel_below(*scene_, input.objects, outlet, rule.reach) : -1;
    for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
      if (!elapsed(clock_key(Clock::kFill, r, i), static_cast<int>(i) == filled, rule.after, dt)) continue;
      for (const auto& value : rule.adds) set(scene_->objects[i].name, value, true);
      for (const auto& value : rule.removes) set(scene_->objects[i].name, value, false);
    }
  }
}

void DeviceRules::update_regions(const DeviceInput& input, double dt) {
  for (std::size_t r = 0; r < scene_->rules.regions.size(); ++r) {
    const scene::RegionRule& rule = scene_->rules.regions[r];
    const scene::Region* region = scene_->find_region(rule.region);
    const bool works = region != nullptr && holds(rule.when, rule.unless);
    for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
      const bool there = works && in_region(*scene_, *region, input.objects[i]);
      if (!elapsed(clock_key(Clock::kRegion, r, i), there, rule.after, dt)) continue;
      for (const auto& value : rule.adds) set(scene_->objects[i].name, value, true);
      for (const auto& value : rule.removes) set(scene_->objects[i].name, value, false);
    }
  }
}

// The part of a trigger that only the giver decides: most things stand upright or are far from giving
// anything.
bool DeviceRules::gives(const scene::ContactRule& rule, const DeviceInput& input, std::size_t giver) const {
  using Trigger = scene::ContactRule::Trigger;
  const scene::ObjectModel& model = scene_->model_of(scene_->objects[giver]);
  switch (rule.trigger) {
    case Trigger::kPour:
      return pours(model, input.objects[giver]);
    case Trigger::kSqueeze:
      return input.held[giver] && pours(model, input.objects[giver]);
    case Trigger::kInside:  // let go of: a spoon that a hand dips into something is not put there
      return !input.held[giver];
    case Trigger::kDip:
      return true;
  }
  return false;
}

bool DeviceRules::reaches(const scene::ContactRule& rule, const DeviceInput& input, std::size_t giver,
                          const Eigen::Vector3d& point, std::size_t receiver) const {
  using Trigger = scene::ContactRule::Trigger;
  const scene::ObjectModel& to = scene_->model_of(scene_->objects[receiver]);
  if (rule.trigger == Trigger::kInside || rule.trigger == Trigger::kDip)
    return inside_cavity(to, input.objects[receiver], point);
  const scene::ObjectModel& from = scene_->model_of(scene_->objects[giver]);
  return pours_into(from, input.objects[giver], to, input.objects[receiver]);
}

void DeviceRules::transfer(const scene::ContactRule& rule, const std::string& giver,
                           const std::string& receiver) {
  if (rule.trigger == scene::ContactRule::Trigger::kDip) {
    for (const auto& value : rule.gives) set(giver, value, true);
    return;
  }
  if (rule.gives.empty()) {
    for (const auto& content : scene_->rules.contents) {
      if (!facts_.contains(state(giver, content)) || (!rule.moves.empty() && rule.moves != content)) continue;
      set(receiver, content, true);
      set(giver, content, false);
    }
  }
  for (const auto& value : rule.gives) set(receiver, value, true);
  for (const auto& value : rule.loses) set(giver, value, false);
}

void DeviceRules::update_contacts(const DeviceInput& input, double dt) {
  const auto& rules = scene_->rules.contacts;
  const auto& objects = scene_->objects;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!rules[r].object.empty() && rules[r].object != objects[i].name) continue;
      // A rule that names its object also speaks for things without a cavity; the general pouring rule is for
      // vessels.
      const auto& cavity = scene_->model_of(objects[i]).cavity;
      if (rules[r].object.empty() && !(cavity && cavity->liquid)) continue;
      if (!gives(rules[r], input, i)) {
        clocks_.erase(clocks_.lower_bound(clock_key(Clock::kContact, r, i)),
                      clocks_.lower_bound(clock_key(Clock::kContact, r, i + 1)));
        continue;
      }
      const scene::ObjectModel& model = scene_->model_of(objects[i]);
      const bool dips = rules[r].trigger == scene::ContactRule::Trigger::kDip;
      const Eigen::Vector3d point =
          dips ? tool_tip(model, input.objects[i]) : lowest_point(model, input.objects[i]);
      for (std::size_t j = 0; j < objects.size(); ++j) {
        if (i == j || (!rules[r].receiver.empty() && rules[r].receiver != objects[j].name)) continue;
        if (!scene_->model_of(objects[j]).cavity) continue;
        const std::string& needed_of = dips ? objects[j].name : objects[i].name;
        const bool active = reaches(rules[r], input, i, point, j) &&
                            (rules[r].needs.empty() || facts_.contains(state(needed_of, rules[r].needs)));
        if (!elapsed(clock_key(Clock::kContact, r, i, j), active, rules[r].after, dt)) continue;
        transfer(rules[r], objects[i].name, objects[j].name);
      }
    }
  }
}

void DeviceRules::update_tears(const DeviceInput& input, double dt) {
  for (std::size_t r = 0; r < scene_->rules.tears.size(); ++r) {
    const scene::TearRule& rule = scene_->rules.tears[r];
    for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
      if (scene_->objects[i].name != rule.object) continue;
      const bool pulled = i < input.hands.size() && input.hands[i] >= 2;
      if (!elapsed(clock_key(Clock::kTear, r, i), pulled, rule.after, dt)) continue;
      for (const auto& value : rule.gives) set(rule.object, value, true);
    }
  }
}

void DeviceRules::update_spills(const DeviceInput& input, double dt) {
  for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
    const scene::ObjectModel& model = scene_->model_of(scene_->objects[i]);
    if (!model.cavity || !model.cavity->liquid) continue;
    const bool tilted = mouth_tilt(model, input.objects[i]) > model.cavity->pour_tilt;
    // A second longer than pouring takes, so that what runs into another vessel is not lost first.
    if (!elapsed(clock_key(Clock::kSpill, 0, i), tilted, 1.5, dt)) continue;
    for (const auto& content : scene_->rules.contents) set(scene_->objects[i].name, content, false);
  }
}

}  // namespace goalnet::sim
