#include "components/robot/robot_model.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

namespace goalnet::robot {
namespace {

using testing::HasSubstr;

const std::string kDirectory = GOALNET_SOURCE_DIR "/config/robots";

std::string read(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// Loads the default robot with one slip in its YAML.
Error slip(const std::string& from, const std::string& to) {
  const auto result =
      parse_robot(replaced(read(kDirectory + "/default.yaml"), from, to), "robot.yaml", kDirectory);
  return result ? Error{Outcome::kDone, "no error"} : result.error();
}

// Loads the default robot with one slip in its URDF.
Error urdf_slip(const std::string& from, const std::string& to) {
  const auto directory = std::filesystem::path(testing::TempDir()) / "goalnet_robot_test";
  std::filesystem::create_directories(directory);
  std::ofstream(directory / "default.urdf") << replaced(read(kDirectory + "/default.urdf"), from, to);
  const auto result = parse_robot(read(kDirectory + "/default.yaml"), "robot.yaml", directory.string());
  return result ? Error{Outcome::kDone, "no error"} : result.error();
}

TEST(RobotModel, DefaultRobotIsComplete) {
  const auto model = load_robot("default");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->joints.size(), 22u);
  EXPECT_EQ(model->arms.size(), 2u);
  ASSERT_NE(model->arm("left"), nullptr);
  EXPECT_EQ(model->arm("left")->joints.size(), 7u);
  EXPECT_EQ(model->arm("third"), nullptr);
  EXPECT_EQ(model->lift, "lift");
  ASSERT_TRUE(model->tray);
  EXPECT_EQ(model->tray->slots.size(), 4u);
  EXPECT_EQ(model->home().size(), 22u);
  EXPECT_EQ(model->joints[static_cast<std::size_t>(model->index_of("base_yaw"))].kind,
            JointKind::kContinuous);
  for (const auto& joint : model->joints) {
    EXPECT_GT(joint.limits.velocity, 0) << joint.name;
    EXPECT_GT(joint.limits.acceleration, 0) << joint.name;
    EXPECT_GE(joint.home, joint.limits.lower) << joint.name;
    EXPECT_LE(joint.home, joint.limits.upper) << joint.name;
  }
}

TEST(RobotModel, UnknownRobotSaysWhereItLooked) {
  const auto model = load_robot("no_such_robot");
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(model.error().message, HasSubstr("config/robots/no_such_robot.yaml"));
}

TEST(RobotModel, YamlSlipsNameTheLine) {
  EXPECT_THAT(slip("lift: lift", "lift: elevator").message, HasSubstr("'elevator'"));
  EXPECT_THAT(slip("lift: lift", "lift: base_x").message, HasSubstr("used twice"));
  EXPECT_THAT(slip("urdf: default.urdf", "urdf: absent.urdf").message, HasSubstr("robot.yaml:3"));
  EXPECT_THAT(slip("base_x: 1.0", "base_x: -1.0").message, HasSubstr("robot.yaml:14"));
  EXPECT_THAT(slip("base_x: 1.0", "base_x: .nan").message, HasSubstr("finite"));
  EXPECT_THAT(slip("base_x: 1.0", "base_w: 1.0").message, HasSubstr("base_x"));
  EXPECT_THAT(slip("lift: 0.40", "lift: 3.0").message, HasSubstr("outside"));
  EXPECT_THAT(slip("tool_link: left_tcp", "tool_link: right_tcp").message,
              HasSubstr("exactly those between"));
  EXPECT_THAT(slip("tool_link: left_tcp", "tool_link: claw").message, HasSubstr("'claw'"));
  EXPECT_THAT(slip("[left_arm_1, left_arm_2,", "[left_arm_2, left_arm_1,").message,
              HasSubstr("in that order"));
  EXPECT_THAT(slip("size: [0.21, 0.10]", "size: [0.21]").message, HasSubstr("list of 2"));
  EXPECT_THAT(slip("base:", "base: [").message, HasSubstr("malformed YAML"));
  EXPECT_THAT(slip("arms:", "legs:").message, HasSubstr("'arms' is missing"));
}

TEST(RobotModel, HostileYamlIsRefused) {
  for (const std::string text : {"", "[]", "3", "{", "name: x", "&a [*a]", "name: {a: b}", "\x01\x02"}) {
    const auto result = parse_robot(text, "hostile.yaml", kDirectory);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.error().outcome, Outcome::kInvalidRequest);
    EXPECT_THAT(result.error().message, HasSubstr("hostile.yaml:"));
  }
  EXPECT_THAT(parse_robot(std::string(2 << 20, ' '), "big.yaml", kDirectory).error().message,
              HasSubstr("1 MB"));
}

TEST(RobotModel, UrdfSlipsNameTheElement) {
  EXPECT_THAT(urdf_slip("<robot", "<robo").message, HasSubstr("not a valid URDF"));
  EXPECT_THAT(urdf_slip("</robot>", "").message, HasSubstr("not a valid URDF"));
  EXPECT_THAT(urdf_slip("<link name=\"odom\"/>", "").message, HasSubstr("not a valid URDF"));
  EXPECT_THAT(urdf_slip("name=\"lift\" type=\"prismatic\"", "name=\"lift\" type=\"floating\"").message,
              HasSubstr("'lift'"));
  EXPECT_THAT(urdf_slip("<axis xyz=\"1 0 0\"/>", "<axis xyz=\"2 0 0\"/>").message, HasSubstr("unit length"));
  EXPECT_THAT(urdf_slip("<mass value=\"55\"/>", "<mass value=\"-55\"/>").message, HasSubstr("'base_link'"));
  EXPECT_THAT(urdf_slip("velocity=\"0.8\"", "velocity=\"0\"").message, HasSubstr("above zero"));
  EXPECT_THAT(urdf_slip("lower=\"-20\"", "lower=\"nan\"").message, testing::Not(HasSubstr("no error")));
  EXPECT_THAT(
      urdf_slip("<origin xyz=\"0 0 0\"/>\n    <axis", "<origin xyz=\"0 0 1e300\"/>\n    <axis").message,
      HasSubstr("within 1 km"));
}

// A loop of joints, and links that have two parents each: both would be followed for ever.
TEST(RobotModel, LinksThatFormNoTreeAreRefused) {
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
           child + "\"/></joint>";
  };
  const std::string loop = "<link name=\"a\"/><link name=\"b\"/>" + joint("to_a", "tray", "a") +
                           joint("to_b", "a", "b") + joint("back", "b", "a");
  EXPECT_THAT(urdf_slip("</robot>", loop + "</robot>").message, HasSubstr("'a' is the child of two joints"));
  std::string doubled = "<link name=\"n0\"/>" + joint("to_n0", "tray", "n0");
  for (int i = 0; i < 60; ++i) {
    const std::string from = "n" + std::to_string(i), to = "n" + std::to_string(i + 1);
    doubled += "<link name=\"" + to + "\"/>" + joint("one_" + to, from, to) + joint("two_" + to, from, to);
  }
  EXPECT_THAT(urdf_slip("</robot>", doubled + "</robot>").message, HasSubstr("is the child of two joints"));
}

TEST(RobotModel, UrdfThatIsNestedWithoutEndIsRefused) {
  std::string begins, ends;
  for (int i = 0; i < 50000; ++i) begins += "<a>", ends += "</a>";
  EXPECT_THAT(urdf_slip("</robot>", begins + ends + "</robot>").message, HasSubstr("1000 deep"));
}

// urdfdom leaves out what it cannot read and goes on: the robot would be planned for without that shape.
TEST(RobotModel, NoShapeOrMassIsLeftOutSilently) {
  EXPECT_THAT(urdf_slip("<mass value=\"55\"/>", "<mass value=\"heavy\"/>").message,
              testing::AllOf(HasSubstr("heavy"), HasSubstr("base_link")));
  const std::string urdf = read(kDirectory + "/default.urdf");
  const std::size_t begin = urdf.find("<collision>"), end = urdf.find("</collision>");
  const std::string shape = urdf.substr(begin, end - begin);
  EXPECT_THAT(urdf_slip(shape, "<collision><geometry><box size=\"1 .inf 1\"/></geometry>").message,
              HasSubstr("collision"));
  EXPECT_THAT(urdf_slip(shape, "<collision><geometry><box size=\"1 -1 1\"/></geometry>").message,
              HasSubstr("size"));
  EXPECT_THAT(urdf_slip(shape, "<collision><geometry><mesh filename=\"a.stl\"/></geometry>").message,
              HasSubstr("approximate"));
}

}  // namespace
}  // namespace goalnet::robot
