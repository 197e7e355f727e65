// The parts of the loader: each reads one kind of entry from YAML. Used by scene_loader.cc only.
#pragma once

#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "components/scene/scene.h"
#include "components/scene/yaml_reader.h"

namespace goalnet::scene {

inline constexpr double kDegree = std::numbers::pi / 180.0;

// `at: [x, y, z]` and `rpy: [degrees]`, both optional.
Pose read_pose(YamlReader& reader);
// `shapes: [{box: …}, {cylinder: …}, {sphere: …}, {ring: …}]`; a ring becomes boxes.
std::vector<Shape> read_shapes(YamlReader& reader, const std::string& key);
std::vector<Grasp> read_grasps(YamlReader& reader);
ObjectModel read_model(const std::string& name, YamlReader& reader);
Fixture read_fixture(YamlReader& reader);
Region read_region(YamlReader& reader);
DeviceRules read_rules(YamlReader& reader);

// Cross-references: every name used must exist. Notes mistakes.
void check_references(const Scene& scene, YamlReader& root);

}  // namespace goalnet::scene
