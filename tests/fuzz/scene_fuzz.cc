// The scene reader against any text: it answers with a scene or with a message, and a scene that it accepts
// has only finite numbers and names that exist.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "components/scene/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scene = scene::parse_scene(text, "config/scenes/fuzz.yaml");
  if (!scene) {
    if (scene.error().message.empty()) std::abort();
    return 0;
  }
  for (const auto& pose : scene::initial_poses(*scene, 1)) {
    if (!pose.matrix().allFinite()) std::abort();
  }
  for (const auto& region : scene->regions) {
    if (scene->find_fixture(region.fixture) == nullptr) std::abort();
  }
  for (const auto& fixture : scene->fixtures) {
    for (const auto& part : fixture.parts) {
      const scene::Pose pose = scene::part_pose(fixture, part, [](const std::string&) { return 0.5; });
      if (!pose.matrix().allFinite()) std::abort();
    }
  }
  return 0;
}
