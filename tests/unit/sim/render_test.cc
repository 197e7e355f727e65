#include "sim/render.h"

#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

TEST(Render, RaysNameWhatTheyMeet) {
  auto world = make_world();
  const Eigen::Vector3d mug = world->object_pose(object_index(*world, "Mug_1")).translation();
  const auto hit = world->ray(mug + Eigen::Vector3d(-0.5, 0, 0.05), mug + Eigen::Vector3d(0.5, 0, 0.05));
  EXPECT_EQ(hit.name, "Mug_1");
  EXPECT_LT(hit.normal.x(), -0.9);
  EXPECT_EQ(world->ray({0, 0, 5}, {0, 0, 4}).name, "");
  EXPECT_EQ(world->ray({-1.5, 1.0, 1}, {-1.5, 1.0, -1}).name, "floor");
}

TEST(Render, PictureShowsMoreThanOneColour) {
  auto world = make_world();
  Camera camera;
  camera.width = 48;
  camera.height = 36;
  const Image image = render(*world, camera);
  ASSERT_EQ(image.rgb.size(), 48u * 36u * 3u);
  EXPECT_GT(std::set<std::uint8_t>(image.rgb.begin(), image.rgb.end()).size(), 20u);
  EXPECT_EQ(image.rgb, render(*world, camera).rgb);
}

TEST(Render, PngHasItsSignatureAndSize) {
  Image image;
  image.width = 2;
  image.height = 1;
  image.rgb = {255, 0, 0, 0, 255, 0};
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("goalnet_render_test_" + std::to_string(::getpid()) + ".png"))
                               .string();
  ASSERT_TRUE(write_png(image, path));
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  std::filesystem::remove(path);
  ASSERT_GT(bytes.size(), 50u);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
  EXPECT_EQ(bytes[19], 2);
  EXPECT_EQ(bytes[23], 1);
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Render, RefusesWhatCannotBeWritten) {
  EXPECT_FALSE(write_png(Image{}, "/tmp/x.png"));
  Image image;
  image.width = image.height = 1;
  image.rgb = {1, 2, 3};
  EXPECT_FALSE(write_png(image, "/nowhere/x.png"));
}

}  // namespace
}  // namespace goalnet::sim
