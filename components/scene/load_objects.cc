#include <algorithm>
#include <numbers>

#include "components/scene/load_parts.h"

namespace goalnet::scene {

bool ObjectModel::has_property(const std::string& property) const {
  return std::find(properties.begin(), properties.end(), property) != properties.end();
}

double ObjectModel::footprint_radius() const {
  const Bounds box = bounds(shapes);
  return std::max({-box.lower.x(), -box.lower.y(), box.upper.x(), box.upper.y(), 0.0});
}

double ObjectModel::height() const { return bounds(shapes).upper.z(); }

ObjectModel read_model(const std::string& name, YamlReader& reader) {
  ObjectModel model;
  model.name = name;
  model.properties = reader.texts("properties");
  model.mass = reader.number("mass", 0.001, 100.0);
  model.friction = reader.number("friction", 0.0, 2.0, 0.6);
  model.rolling_friction = reader.number("rolling_friction", 0.0, 0.1, 0.0005);
  model.grip_force = reader.number("grip_force", 0.0, 200.0, 15.0);
  model.shapes = read_shapes(reader, "shapes");
  if (model.shapes.empty()) reader.mistake("model '" + name + "' has no shapes; give it at least one");
  if (reader.has("center_of_mass")) model.center_of_mass = reader.vector3("center_of_mass");
  if (auto cavity = reader.map("cavity")) {
    Cavity hollow;
    hollow.mouth = read_pose(*cavity);
    hollow.radius = cavity->number("radius", 0.001, 1.0);
    hollow.depth = cavity->number("depth", 0.001, 2.0);
    hollow.pour_tilt = cavity->number("pour_tilt", 10.0, 170.0, 70.0) * std::numbers::pi / 180.0;
    hollow.liquid = cavity->flag("liquid", true);
    hollow.slot = cavity->flag("slot", false);
    cavity->finish();
    model.cavity = hollow;
  }
  model.grasps = read_grasps(reader);
  if (model.has_property("IsGraspable") && model.grasps.empty()) {
    reader.mistake("model '" + name + "' IsGraspable but has no grasps; add at least one");
  }
  reader.finish();
  return model;
}

}  // namespace goalnet::scene
