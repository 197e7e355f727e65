// goalnet-picture: a PNG of a scene with the robot at its start, without a display.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "components/setting/setting.h"
#include "sim/render.h"
#include "sim/world.h"

namespace {

using namespace goalnet;

int refuse(const Error& error) {
  std::fprintf(stderr, "goalnet-picture: %s\n", error.message.c_str());
  return static_cast<int>(error.outcome);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws a scene with the robot at its start into a PNG file.", "goalnet-picture");
  std::string scene_name = "kitchen", robot_name = "default", file = "scene.png";
  std::uint64_t seed = 0;
  std::vector<double> eye = {-2.7, -0.4, 2.9}, target = {0.8, 0.1, 0.7};
  std::vector<int> size = {800, 600};
  app.add_option("--scene", scene_name, "name in config/scenes or a file")->capture_default_str();
  app.add_option("--robot", robot_name, "name in config/robots or a file")->capture_default_str();
  app.add_option("--seed", seed, "varies where objects stand; 0: exactly as the scene says")
      ->capture_default_str();
  app.add_option("-o,--output", file, "PNG file to write")->capture_default_str();
  app.add_option("--eye", eye, "x y z of the camera [m]")->expected(3)->capture_default_str();
  app.add_option("--target", target, "x y z of the middle of the picture [m]")
      ->expected(3)
      ->capture_default_str();
  app.add_option("--size", size, "width height [pixels]")
      ->expected(2)
      ->check(CLI::Range(1, 8192))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(Outcome::kInvalidRequest);
  }
  const auto setting = load_setting(scene_name, robot_name);
  if (!setting) return refuse(setting.error());
  sim::WorldOptions options;
  options.seed = seed;
  auto world = sim::World::create(setting->scene, setting->robot, options);
  if (!world) return refuse(world.error());
  sim::Camera camera;
  camera.eye = {eye[0], eye[1], eye[2]};
  camera.target = {target[0], target[1], target[2]};
  camera.vertical_view = 1.1;
  camera.width = size[0];
  camera.height = size[1];
  if (auto written = sim::write_png(sim::render(**world, camera), file); !written)
    return refuse(written.error());
  std::fprintf(stderr, "goalnet-picture: wrote %s\n", file.c_str());
  return 0;
}
