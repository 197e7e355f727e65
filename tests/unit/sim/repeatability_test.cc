// Same scene, seed and commands give the same bits: twice in one process, and in another process.
#include <array>
#include <cstdio>
#include <cstring>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/sim/puppet.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

// Bits of everything that moves, after pushing things about, grasping, and hitting the counter.
std::uint64_t fingerprint(std::uint64_t seed) {
  WorldOptions options;
  options.seed = seed;
  auto world = make_world(options);
  Puppet hand(*world, "right");
  const Eigen::Vector3d at =
      Eigen::Vector3d(world->object_pose(object_index(*world, "Coke_1")).translation()) +
      Eigen::Vector3d(0, 0, 0.07);
  const auto tool = [](const Eigen::Vector3d& p) {
    return Puppet::tool(p, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  };
  hand.place(at.x() - 0.75, at.y() + 0.3, 0, 0.25, tool(at - Eigen::Vector3d(0.12, 0, 0)), 0.053);
  hand.move(tool(at), 0.4);
  hand.fingers(0.029, 0.2);
  hand.wait(0.1);
  hand.move(tool(at + Eigen::Vector3d(0.02, 0.25, 0.02)), 0.6);  // sweeps the glass aside
  world->push_object(object_index(*world, "EnergyDrink_1"), {-300, 0, 50});
  run(*world, 0.6);
  std::uint64_t hash = 1469598103934665603ull;
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 1099511628211ull;
  };
  for (std::size_t i = 0; i < world->scene().objects.size(); ++i) {
    const scene::Pose pose = world->object_pose(i);
    for (int k = 0; k < 12; ++k) add(pose.matrix().topRows<3>()(k % 3, k / 3));
  }
  for (std::size_t i = 0; i < world->robot_joint_count(); ++i) add(world->robot_joint(i).position);
  for (std::size_t i = 0; i < world->fixture_joint_count(); ++i) add(world->fixture_joint(i).position);
  return hash;
}

TEST(Repeatability, TwiceInOneProcess) { EXPECT_EQ(fingerprint(5), fingerprint(5)); }

TEST(Repeatability, SeedsDiffer) { EXPECT_NE(fingerprint(5), fingerprint(6)); }

// Run by the test below in a process of its own; alone it only prints.
TEST(Repeatability, PrintsItsFingerprint) {
  std::printf("fingerprint=%016lx\n", static_cast<unsigned long>(fingerprint(5)));
}

TEST(Repeatability, InAnotherProcess) {
  std::array<char, 4096> self{};
  ASSERT_GT(::readlink("/proc/self/exe", self.data(), self.size() - 1), 0);
  const std::string command =
      std::string("'") + self.data() + "' --gtest_filter=Repeatability.PrintsItsFingerprint";
  FILE* pipe = ::popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  for (std::array<char, 256> line{}; std::fgets(line.data(), line.size(), pipe) != nullptr;)
    output += line.data();
  EXPECT_EQ(::pclose(pipe), 0);
  char expected[64];
  std::snprintf(expected, sizeof expected, "fingerprint=%016lx", static_cast<unsigned long>(fingerprint(5)));
  EXPECT_NE(output.find(expected), std::string::npos) << expected << "\n" << output;
}

}  // namespace
}  // namespace goalnet::sim
