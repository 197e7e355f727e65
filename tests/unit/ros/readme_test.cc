// The example of components/ros/README.md, as it stands there.
#include <gtest/gtest.h>

#include "components/ros/node.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

TEST(Readme, TheExampleTalksToItself) {
  const std::vector<std::string> words = {"--ros-args", "-r", "__ns:=/kitchen", "-r", "echo:=chatter"};
  auto context = ros::Context::create({.domain_id = own_domain()});
  ASSERT_TRUE(context) << context.error().message;
  ros::EventLoop loop;
  auto arguments = ros::parse_arguments(words);
  ASSERT_TRUE(arguments) << arguments.error().message;
  ros::Node node(**context, loop, {.name = "talker", .arguments = *arguments});
  auto out = node.advertise<std_msgs::msg::String>("chatter", ros::Qos::standard());
  std::string heard;
  auto in = node.subscribe<std_msgs::msg::String>("echo", ros::Qos::standard(),
                                                  [&](const std_msgs::msg::String& m) {
                                                    heard = m.data();
                                                    loop.stop();
                                                  });
  EXPECT_EQ(in->topic(), "/kitchen/chatter");
  auto timer = node.create_timer(std::chrono::milliseconds(10), [&] {
    std_msgs::msg::String message;
    message.data("hello");
    out->publish(message);
  });
  loop.run();
  EXPECT_EQ(heard, "hello");
}

}  // namespace
}  // namespace goalnet::ros
