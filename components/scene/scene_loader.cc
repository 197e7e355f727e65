#include <algorithm>
#include <filesystem>

#include "components/core/config_path.h"
#include "components/scene/load_parts.h"
#include "components/scene/scene.h"

namespace goalnet::scene {
namespace {

// Where a library may lie: with the scene, as config has it or simply beside it, or in config itself, so that
// a room of one's own can lie anywhere and be furnished with the things that ship.
Expected<std::string> library_path(const std::string& library, const std::filesystem::path& scene) {
  const std::filesystem::path folder = scene.parent_path(), file = library + ".yaml";
  std::string looked;
  for (const auto& candidate : {folder / ".." / "objects" / file, folder / file,
                                std::filesystem::path(config_path("objects")) / file}) {
    const std::string path = candidate.lexically_normal().string();
    std::error_code ignored;
    if (path != scene.lexically_normal() && std::filesystem::exists(path, ignored)) return path;
    looked += (looked.empty() ? "" : ", ") + path;
  }
  return fail(Outcome::kInvalidRequest, "there is none of these: " + looked);
}

void read_libraries(YamlReader& root, const std::string& scene_path, Scene& scene) {
  for (const auto& library : root.texts("libraries")) {
    const auto found = library_path(library, scene_path);
    if (!found) {
      root.mistake_at("libraries", "library '" + library + "': " + found.error().message);
      continue;
    }
    const std::string& path = *found;
    auto node = read_yaml_file(path);
    if (!node) {
      root.mistake_at("libraries", "library '" + library + "': " + node.error().message);
      continue;
    }
    YamlReader reader(*node, path, root.mistakes());
    for (auto& [name, model] : reader.named_maps("models")) {
      const bool known = std::any_of(scene.models.begin(), scene.models.end(),
                                     [&name = name](const auto& m) { return m.name == name; });
      if (known) model.mistake("model '" + name + "' is defined twice; rename one");
      scene.models.push_back(read_model(name, model));
    }
    reader.finish();
  }
}

// Places an object on a support of its region, or at an absolute pose when it has no region.
Placement read_placement(const Scene& scene, const std::string& object, YamlReader& reader) {
  Placement placement;
  placement.on = reader.text("on", "");
  placement.jitter_xy = reader.number("jitter_xy", 0.0, 1.0, 0.0);
  placement.jitter_yaw = kDegree * reader.number("jitter_yaw", 0.0, 180.0, 0.0);
  const std::size_t support_index = static_cast<std::size_t>(reader.number("support", 0, 100, 0));
  const Pose local = read_pose(reader);
  if (placement.on.empty()) {
    placement.pose = local;
    return placement;
  }
  const Region* region = scene.find_region(placement.on);
  const Fixture* fixture = region != nullptr ? scene.find_fixture(region->fixture) : nullptr;
  if (fixture == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : scene.regions) names.push_back(known.name);
    const std::string near = nearest_word(placement.on, names);
    reader.mistake_at("on", "object '" + object + "' stands on '" + placement.on +
                                "', which is not a region" +
                                (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return placement;
  }
  if (support_index >= region->supports.size()) {
    reader.mistake_at("support", "region '" + placement.on + "' has only " +
                                     std::to_string(region->supports.size()) + " supports");
    return placement;
  }
  placement.pose = fixture->pose * region->supports[support_index].frame * local;
  return placement;
}

void read_objects(YamlReader& root, Scene& scene) {
  std::vector<std::string> model_names;
  for (const auto& model : scene.models) model_names.push_back(model.name);
  for (auto& reader : root.maps("objects")) {
    Object object;
    object.name = reader.text("name");
    const std::string model = reader.text("model");
    const auto found = std::find(model_names.begin(), model_names.end(), model);
    if (found == model_names.end()) {
      const std::string near = nearest_word(model, model_names);
      reader.mistake_at("model",
                        "object '" + object.name + "' has the unknown model '" + model + "'" +
                            (near.empty() ? "; define it in a library" : "; did you mean '" + near + "'?"));
    } else {
      object.model = static_cast<std::size_t>(found - model_names.begin());
    }
    object.placement = read_placement(scene, object.name, reader);
    object.states = reader.texts("states");
    std::sort(object.states.begin(), object.states.end());
    reader.finish();
    scene.objects.push_back(object);
  }
  std::sort(scene.objects.begin(), scene.objects.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
}

Scene read_scene(YamlReader& root, const std::string& path) {
  Scene scene;
  scene.file = path;
  scene.name = root.text("scene");
  if (auto floor = root.map("floor")) {
    const auto x = floor->numbers("x", 2, -100.0, 100.0);
    const auto y = floor->numbers("y", 2, -100.0, 100.0);
    floor->finish();
    scene.floor_x_min = x[0];
    scene.floor_x_max = x[1];
    scene.floor_y_min = y[0];
    scene.floor_y_max = y[1];
    if (x[0] >= x[1] || y[0] >= y[1])
      root.mistake_at("floor", "'floor' needs x: [least, greatest] and y: [least, greatest]");
  } else {
    root.mistake("key 'floor' is missing; add 'floor: {x: [-2, 2], y: [-2, 2]}'");
  }
  const auto start = root.numbers("robot_start", 3, -100.0, 360.0, std::vector<double>{0.0, 0.0, 0.0});
  scene.robot_start = {start[0], start[1], kDegree * start[2]};
  read_libraries(root, path, scene);
  for (auto& reader : root.maps("fixtures")) scene.fixtures.push_back(read_fixture(reader));
  for (auto& reader : root.maps("regions")) scene.regions.push_back(read_region(reader));
  read_objects(root, scene);
  if (auto rules = root.map("rules")) scene.rules = read_rules(*rules);
  scene.initial_facts = root.predicates("initial_facts");
  scene.symbols = root.texts("symbols");
  for (const auto& object : scene.objects) scene.symbols.push_back(object.name);
  std::sort(scene.symbols.begin(), scene.symbols.end());
  scene.symbols.erase(std::unique(scene.symbols.begin(), scene.symbols.end()), scene.symbols.end());
  check_references(scene, root);
  root.finish();
  return scene;
}

Expected<Scene> scene_of(const YAML::Node& node, const std::string& path) {
  Mistakes mistakes;
  try {
    YamlReader root(node, path, mistakes);
    Scene scene = read_scene(root, path);
    if (!mistakes.none()) return tl::unexpected(mistakes.error());
    return scene;
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest, path + ": " + error.what());
  }
}

}  // namespace

Expected<Scene> load_scene(const std::string& name_or_path) {
  std::string path = name_or_path;
  if (name_or_path.find('/') == std::string::npos && !name_or_path.ends_with(".yaml")) {
    path = config_path("scenes/" + name_or_path + ".yaml");
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
      std::string known;
      std::vector<std::string> names;
      for (const auto& entry : std::filesystem::directory_iterator(config_path("scenes"), ignored)) {
        if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
      }
      if (names.empty())
        return fail(Outcome::kInvalidRequest, config_path("scenes") +
                                                  " holds no scenes; is the environment variable "
                                                  "GOALNET_CONFIG_DIR right, or the installation complete?");
      std::sort(names.begin(), names.end());
      for (const auto& name : names) known += (known.empty() ? "" : ", ") + name;
      return fail(Outcome::kInvalidRequest, "unknown scene '" + name_or_path + "'; known: " + known +
                                                ", or give a path to a .yaml file");
    }
  }
  auto node = read_yaml_file(path);
  if (!node) return tl::unexpected(node.error());
  return scene_of(*node, path);
}

Expected<Scene> parse_scene(const std::string& text, const std::string& path) {
  auto node = read_yaml_text(text, path);
  if (!node) return tl::unexpected(node.error());
  return scene_of(*node, path);
}

}  // namespace goalnet::scene
