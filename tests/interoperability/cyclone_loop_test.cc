// The closed loop with a Cyclone DDS program beside it: what people's tools see while the robot works.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing_support::Process;

TEST(CycloneLoop, ReadsWhileTheRobotWorks) {
  const std::string domain = std::to_string(own_domain());
  const std::map<std::string, std::string> environment = {{"ROS_DOMAIN_ID", domain}};
  Process reader({testing_support::program("cyclone_peer"), "read", domain, "60"}, environment);
  ASSERT_TRUE(reader.wait_for_text("ready", 5s));
  Process robot(
      {testing_support::program("goalnet"), "run", "--goal", "(On Mug_1 Sink)", "--seed", "1", "--json"},
      environment);
  const auto result = robot.wait(90s);
  EXPECT_EQ(result.exit_code, 0) << result.err.substr(0, 2000);
  const std::string out = reader.out();
  EXPECT_THAT(out, HasSubstr("world_state "));
  EXPECT_THAT(out, HasSubstr(" map objects "));
  EXPECT_THAT(out, HasSubstr("(On Mug_1 Sink)")) << "the last world states show what was achieved";
  EXPECT_THAT(out, HasSubstr("joint_states "));
  EXPECT_THAT(out, HasSubstr(" base_x="));
  EXPECT_THAT(out, HasSubstr("SinkKnob_joint=")) << "fixtures are joints too";
  EXPECT_THAT(out, HasSubstr("rosout 20 "));
}

}  // namespace
}  // namespace goalnet::ros
