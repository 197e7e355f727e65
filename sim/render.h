// Pictures of the simulated room without a display: rays through the physics world, written as PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/world.h"

namespace goalnet::sim {

struct Camera {
  Eigen::Vector3d eye = {-2.6, 0.0, 2.6};    // [m] map frame
  Eigen::Vector3d target = {0.6, 0.0, 0.7};  // [m] looks here
  double vertical_view = 0.9;                // [rad] opening angle
  int width = 640;                           // [pixels]
  int height = 480;
};

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // rows from the top, 3 bytes a pixel
};

// A pixel takes about 5 us; a 640 x 480 picture 2 s.
Image render(const World& world, const Camera& camera);

// Uncompressed PNG. Fails with kInvalidRequest if the file cannot be written or the image is empty.
Expected<void> write_png(const Image& image, const std::string& path);

}  // namespace goalnet::sim
