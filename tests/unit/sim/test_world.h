// A kitchen with the default robot in it, for tests of the simulator.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "sim/world.h"

namespace goalnet::sim {

inline const scene::Scene& test_scene() {
  static const scene::Scene scene = [] {
    auto loaded = scene::load_scene("kitchen");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
  }();
  return scene;
}

inline const robot::RobotModel& test_robot() {
  static const robot::RobotModel robot = [] {
    auto loaded = robot::load_robot("default");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
  }();
  return robot;
}

inline std::unique_ptr<World> make_world(WorldOptions options = {}) {
  auto world = World::create(test_scene(), test_robot(), options);
  if (!world) throw std::runtime_error(world.error().message);
  return std::move(*world);
}

inline std::size_t object_index(const World& world, const std::string& name) {
  for (std::size_t i = 0; i < world.scene().objects.size(); ++i) {
    if (world.scene().objects[i].name == name) return i;
  }
  throw std::runtime_error("no object " + name);
}

inline void run(World& world, double seconds) {
  const double end = world.time() + seconds - 1e-9;
  while (world.time() < end) world.step();
}

inline bool holds(const World& world, const std::string& fact) {
  return world.facts().contains(*parse_predicate(fact));
}

}  // namespace goalnet::sim
