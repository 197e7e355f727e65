// Runs beside a robot of the same names on the same ROS_DOMAIN_ID.
#include <gmock/gmock-matchers.h>

#include <cstdlib>

#include "tests/closed_loop/run_json.h"
#include "tools/goalnet/lockstep_loop.h"

namespace goalnet {
namespace {

constexpr int kDomain = 85;

TEST(SideBySide, WhoeverComesSecondIsRefusedUnlessApart) {
  setenv("ROS_DOMAIN_ID", std::to_string(kDomain).c_str(), 1);
  const auto robot = tools::LockstepLoop::create({}, {});
  ASSERT_TRUE(robot) << robot.error().message;
  ASSERT_TRUE((*robot)->settle());
  const double time = (*robot)->sim_time();

  const std::vector<std::string> words = {"run", "--json", "--goal", "(Near Robot Fridge)"};
  const auto run = [&](std::vector<std::string> first, const std::vector<std::string>& last) {
    first.insert(first.begin(), words.begin(), words.end());
    first.insert(first.end(), last.begin(), last.end());
    const auto result = testing_support::run_goalnet(first, kDomain);
    EXPECT_TRUE((*robot)->settle(0.1)) << "who is alone again goes on";
    return std::pair(result.exit_code, nlohmann::json::parse(result.out, nullptr, false));
  };
  const auto [refused, why] = run({}, {});
  EXPECT_EQ(refused, 14);
  EXPECT_THAT(why["message"].get<std::string>(),
              testing::AllOf(testing::HasSubstr("ROS_DOMAIN_ID 85"), testing::HasSubstr("--private")));

  auto [private_code, alone] = run({"--private"}, {});
  EXPECT_EQ(private_code, 0) << alone;
  auto [space_code, elsewhere] = run({}, {"--ros-args", "-r", "__ns:=/other"});
  EXPECT_EQ(space_code, 0) << elsewhere;
  alone.erase("wall_time_s");
  elsewhere.erase("wall_time_s");
  EXPECT_EQ(alone, elsewhere) << "the same run, whoever listens";
  EXPECT_LT((*robot)->sim_time(), time + 1.0) << "the others' clocks are not the robot's";
}

}  // namespace
}  // namespace goalnet
