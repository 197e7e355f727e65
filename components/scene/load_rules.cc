
#include "components/scene/load_parts.h"

namespace goalnet::scene {
namespace {

Predicate read_fact(YamlReader& reader, const std::string& key) {
  const std::string text = reader.text(key);
  if (text.empty()) return {};
  auto fact = parse_predicate(text);
  if (fact) return *fact;
  reader.mistake_at(key, fact.error().message + "; write a fact like \"(state SinkKnob TapIsOn)\"");
  return {};
}

JointFact read_joint_fact(YamlReader& reader) {
  JointFact rule;
  rule.fact = read_fact(reader, "fact");
  rule.joint = reader.text("joint");
  const double unit = reader.choice("unit", {"deg", "m"}) == "deg" ? kDegree : 1.0;
  rule.on_above = unit * reader.number("on_above", -720.0, 720.0);
  rule.off_below = unit * reader.number("off_below", -720.0, 720.0);
  if (rule.off_below > rule.on_above)
    reader.mistake_at("off_below", "'off_below' must not be greater than 'on_above'");
  reader.finish();
  return rule;
}

ButtonRule read_button(YamlReader& reader) {
  ButtonRule rule;
  rule.object = reader.text("object", "");
  if (!rule.object.empty()) {
    rule.name = reader.text("name");
    rule.at = reader.vector3("at");
    rule.radius = reader.number("radius", 0.001, 1.0, 0.02);
  } else {
    rule.name = rule.joint = reader.text("joint");
    rule.pressed_above = reader.number("pressed_above", 0.0, 1.0);
    rule.released_below = reader.number("released_below", 0.0, 1.0);
  }
  rule.subject = reader.text("subject");
  const std::string effect =
      reader.choice("effect", {"toggle", "set", "clear", "next", "previous"}, "toggle");
  using Effect = ButtonRule::Effect;
  rule.effect = effect == "toggle"  ? Effect::kToggle
                : effect == "set"   ? Effect::kSet
                : effect == "clear" ? Effect::kClear
                : effect == "next"  ? Effect::kNext
                                    : Effect::kPrevious;
  rule.values = reader.texts("values");
  rule.when = reader.predicates("when");
  rule.unless = reader.predicates("unless");
  if (rule.values.empty())
    reader.mistake("the button rule of '" + rule.name + "' has no values; say what it changes");
  if (rule.released_below > rule.pressed_above) {
    reader.mistake_at("released_below", "'released_below' must not be greater than 'pressed_above'");
  }
  reader.finish();
  return rule;
}

FillRule read_fill(YamlReader& reader) {
  FillRule rule;
  rule.when = reader.predicates("when");
  rule.fixture = reader.text("fixture");
  rule.part = reader.text("part", "");
  rule.outlet = reader.vector3("outlet");
  rule.reach = reader.number("reach", 0.01, 5.0, 0.6);
  rule.after = reader.number("after", 0.0, 3600.0, 2.0);
  rule.adds = reader.texts("adds");
  rule.removes = reader.texts("removes");
  reader.finish();
  return rule;
}

RegionRule read_region_rule(YamlReader& reader) {
  RegionRule rule;
  rule.when = reader.predicates("when");
  rule.unless = reader.predicates("unless");
  rule.region = reader.text("region");
  rule.after = reader.number("after", 0.0, 3600.0, 2.0);
  rule.adds = reader.texts("adds");
  rule.removes = reader.texts("removes");
  reader.finish();
  return rule;
}

ContactRule read_contact_rule(YamlReader& reader) {
  ContactRule rule;
  const std::string trigger = reader.choice("trigger", {"pour", "inside", "dip", "squeeze"});
  using Trigger = ContactRule::Trigger;
  rule.trigger = trigger == "pour"     ? Trigger::kPour
                 : trigger == "inside" ? Trigger::kInside
                 : trigger == "dip"    ? Trigger::kDip
                                       : Trigger::kSqueeze;
  rule.object = reader.text("object", "");
  rule.receiver = reader.text("receiver", "");
  rule.moves = reader.text("moves", "");
  rule.needs = reader.text("needs", "");
  rule.gives = reader.texts("gives");
  rule.loses = reader.texts("loses");
  rule.after = reader.number("after", 0.0, 3600.0, 0.5);
  reader.finish();
  return rule;
}

TearRule read_tear(YamlReader& reader) {
  TearRule rule;
  rule.object = reader.text("object");
  rule.gives = reader.texts("gives");
  rule.after = reader.number("after", 0.0, 3600.0, 0.5);
  if (rule.gives.empty())
    reader.mistake("the tear rule of '" + rule.object + "' gives nothing; say what it changes");
  reader.finish();
  return rule;
}

}  // namespace

const ButtonRule* DeviceRules::find_spot(std::string_view name) const {
  for (const auto& rule : buttons)
    if (!rule.object.empty() && rule.name == name) return &rule;
  return nullptr;
}

DeviceRules read_rules(YamlReader& reader) {
  DeviceRules rules;
  rules.contents = reader.texts("contents");
  for (auto& entry : reader.maps("joint_facts")) rules.joint_facts.push_back(read_joint_fact(entry));
  for (auto& entry : reader.maps("buttons")) rules.buttons.push_back(read_button(entry));
  for (auto& entry : reader.maps("clears")) {
    ClearRule rule{entry.predicates("when"), entry.predicates("clears")};
    entry.finish();
    rules.clears.push_back(rule);
  }
  for (auto& entry : reader.maps("fills")) rules.fills.push_back(read_fill(entry));
  for (auto& entry : reader.maps("regions")) rules.regions.push_back(read_region_rule(entry));
  for (auto& entry : reader.maps("contacts")) rules.contacts.push_back(read_contact_rule(entry));
  for (auto& entry : reader.maps("tears")) rules.tears.push_back(read_tear(entry));
  reader.finish();
  return rules;
}

}  // namespace goalnet::scene
