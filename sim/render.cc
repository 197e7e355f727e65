#include "sim/render.h"

#include <algorithm>
#include <cmath>

namespace goalnet::sim {
namespace {

// Sunlight from behind the robot's left shoulder plus an even sky, so that all faces differ.
std::array<double, 3> shade(const World::RayHit& hit, const Eigen::Vector3d& direction, bool shadow) {
  const Eigen::Vector3d sun = Eigen::Vector3d(-0.45, 0.35, 0.82).normalized();
  const double sunlight = shadow ? 0.0 : std::max(0.0, hit.normal.dot(sun));
  const double facing = std::abs(hit.normal.dot(direction));
  const double light = 0.35 + 0.15 * facing + 0.55 * sunlight;
  return {hit.color[0] * light, hit.color[1] * light, hit.color[2] * light};
}

}  // namespace

Image render(const World& world, const Camera& camera) {
  Image image;
  if (camera.width <= 0 || camera.height <= 0 || camera.width > 8192 || camera.height > 8192) return image;
  image.width = camera.width;
  image.height = camera.height;
  image.rgb.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height) * 3);
  const Eigen::Vector3d forward = (camera.target - camera.eye).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
  right = right.norm() < 1e-6 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(right.normalized());
  const Eigen::Vector3d up = right.cross(forward);
  const double scale = std::tan(camera.vertical_view / 2.0) / (camera.height / 2.0);
  const Eigen::Vector3d sun = Eigen::Vector3d(-0.45, 0.35, 0.82).normalized();
  std::size_t at = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double across = (x + 0.5 - camera.width / 2.0) * scale;
      const double along = (camera.height / 2.0 - y - 0.5) * scale;
      const Eigen::Vector3d direction = (forward + across * right + along * up).normalized();
      const World::RayHit hit = world.ray(camera.eye, camera.eye + 20.0 * direction);
      std::array<double, 3> color = {0.78, 0.84, 0.9};
      if (!hit.name.empty()) {
        const Eigen::Vector3d start = hit.point + 0.003 * hit.normal;
        const bool shadow = !world.ray(start, start + 4.0 * sun, true).name.empty();
        color = shade(hit, direction, shadow);
      }
      for (double channel : color) {
        image.rgb[at++] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(channel, 0.0, 1.0)));
      }
    }
  }
  return image;
}

}  // namespace goalnet::sim
