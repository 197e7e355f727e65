#include <cmath>

#include "components/scene/load_parts.h"

namespace goalnet::scene {
namespace {

Joint read_joint(const std::string& part, YamlReader& reader) {
  Joint joint;
  joint.name = reader.text("name", part + "_joint");
  joint.kind = reader.choice("type", {"revolute", "prismatic"}) == "revolute" ? JointKind::kRevolute
                                                                              : JointKind::kPrismatic;
  const double unit = joint.kind == JointKind::kRevolute ? kDegree : 1.0;
  joint.origin = read_pose(reader);
  const Eigen::Vector3d axis = reader.vector3("axis");
  if (axis.norm() < 1e-6) {
    reader.mistake_at("axis",
                      "the axis of joint '" + joint.name + "' has no direction; for example [0, 0, 1]");
  } else {
    joint.axis = axis.normalized();
  }
  const auto range = reader.numbers("range", 2, -720.0, 720.0);
  joint.lower = unit * range[0];
  joint.upper = unit * range[1];
  if (joint.lower > 0.0 || joint.upper < 0.0 || joint.lower >= joint.upper) {
    reader.mistake_at("range",
                      "'range' of joint '" + joint.name + "' must be [least, greatest] and contain 0");
  }
  joint.friction = reader.number("friction", 0.0, 100.0, 0.1);
  joint.damping = reader.number("damping", 0.0, 100.0, 0.01);
  joint.return_force = reader.number("return_force", 0.0, 200.0, 0.0);
  joint.rest = unit * reader.number("rest", -720.0, 720.0, 0.0);
  reader.finish();
  return joint;
}

Part read_part(const Fixture& fixture, YamlReader& reader) {
  Part part;
  part.name = reader.text("name");
  part.action_object = reader.text("action_object", part.name);
  if (reader.has("parent")) {
    const std::string parent = reader.text("parent");
    for (std::size_t i = 0; i < fixture.parts.size(); ++i) {
      if (fixture.parts[i].name == parent) part.parent = static_cast<int>(i);
    }
    if (part.parent < 0) {
      reader.mistake_at(
          "parent",
          "part '" + part.name + "' has the parent '" + parent +
              "', which is not a part listed before it; list parents first (cycles are not possible)");
    }
  }
  const std::string use = reader.choice("use", {"none", "door", "knob", "button"}, "none");
  part.use = use == "door"     ? PartUse::kDoor
             : use == "knob"   ? PartUse::kKnob
             : use == "button" ? PartUse::kButton
                               : PartUse::kNone;
  if (auto joint = reader.map("joint")) {
    part.joint = read_joint(part.name, *joint);
  } else {
    reader.mistake("part '" + part.name + "' has no joint; add 'joint: {type: …, axis: …, range: …}'");
  }
  part.mass = reader.number("mass", 0.001, 200.0);
  part.friction = reader.number("friction", 0.0, 2.0, 0.6);
  part.shapes = read_shapes(reader, "shapes");
  if (part.shapes.empty()) reader.mistake("part '" + part.name + "' has no shapes; give it at least one");
  part.grasps = read_grasps(reader);
  if (auto push = reader.map("push")) {
    part.push = read_pose(*push);
    push->finish();
  }
  const double unit = part.joint.kind == JointKind::kRevolute ? kDegree : 1.0;
  part.on_position = unit * reader.number("on", -720.0, 720.0, part.joint.upper / unit);
  part.off_position = unit * reader.number("off", -720.0, 720.0, 0.0);
  if ((part.use == PartUse::kDoor || part.use == PartUse::kKnob) && part.grasps.empty()) {
    reader.mistake("part '" + part.name + "' is a " + use + " without grasps; say where the hand takes it");
  }
  if (part.use == PartUse::kButton && !part.push) {
    reader.mistake("part '" + part.name + "' is a button without 'push'; say where the finger presses");
  }
  reader.finish();
  return part;
}

}  // namespace

Fixture read_fixture(YamlReader& reader) {
  Fixture fixture;
  fixture.name = reader.text("name");
  fixture.pose = read_pose(reader);
  fixture.friction = reader.number("friction", 0.0, 2.0, 0.6);
  fixture.shapes = read_shapes(reader, "shapes");
  for (auto& part : reader.maps("parts")) fixture.parts.push_back(read_part(fixture, part));
  if (fixture.shapes.empty() && fixture.parts.empty()) {
    reader.mistake("fixture '" + fixture.name + "' has neither shapes nor parts");
  }
  reader.finish();
  return fixture;
}

Region read_region(YamlReader& reader) {
  Region region;
  region.name = reader.text("name");
  region.relation =
      reader.choice("relation", {"On", "In"}) == "On" ? RegionRelation::kOn : RegionRelation::kIn;
  region.fixture = reader.text("fixture");
  region.within = reader.text("within", "");
  region.door = reader.text("door", "");
  for (auto& support_reader : reader.maps("supports")) {
    Support support;
    support.frame = read_pose(support_reader);
    const auto size = support_reader.numbers("size", 2, 0.001, 20.0);
    support.size_x = size[0];
    support.size_y = size[1];
    support.clearance = support_reader.number("clearance", 0.01, 10.0, 1.0);
    support.reserved = support_reader.flag("reserved", false);
    support_reader.finish();
    region.supports.push_back(support);
  }
  if (region.supports.empty())
    reader.mistake("region '" + region.name + "' has no supports; add the surface that carries");
  for (auto& spot_reader : reader.maps("spots")) {
    Spot spot;
    spot.name = spot_reader.text("name");
    spot.frame = read_pose(spot_reader);
    spot.prefer_for = spot_reader.texts("for");
    spot_reader.finish();
    region.spots.push_back(spot);
  }
  reader.finish();
  return region;
}

}  // namespace goalnet::scene
