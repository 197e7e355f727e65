// What is drawn, when, and for whom. (That shapes stand where the scene says:
// tests/closed_loop/recording_test.cc.)
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>

#include "components/messages/conversions.h"
#include "components/visualization/visualization_node.h"
#include "tests/unit/ros/support.h"

namespace goalnet::visualization {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;
namespace marker = visualization_msgs::msg::Marker_Constants;

const int kDomain = ros::own_domain();

const scene::Scene& kitchen() {
  static const scene::Scene scene = *scene::load_scene("kitchen");
  return scene;
}

Poses nominal_poses() {
  Poses poses;
  const auto places = scene::initial_poses(kitchen(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) poses[kitchen().objects[i].name] = places[i];
  for (const auto& fixture : kitchen().fixtures) {
    for (const auto& part : fixture.parts)
      poses[part.name] = scene::part_pose(fixture, part, [](const std::string&) { return 0.0; });
  }
  return poses;
}

const Drawing* find(const std::vector<Drawing>& drawings, const std::string& group, const std::string& text) {
  for (const Drawing& one : drawings) {
    if (one.group == group && one.text.find(text) != std::string::npos) return &one;
  }
  return nullptr;
}

TEST(Drawings, IdsNameTheSameThingWhateverIsSeen) {
  std::vector<Drawing> all, some;
  draw_shapes(kitchen(), nominal_poses(), all);
  Poses fewer = nominal_poses();
  fewer.erase("Mug_1");
  draw_shapes(kitchen(), fewer, some);
  const std::size_t mug = kitchen().find_model_of("Mug_1")->shapes.size();
  EXPECT_EQ(some.size() + mug, all.size());
  std::map<std::pair<std::string, int>, Eigen::Vector3d> places;
  for (const Drawing& one : all)
    EXPECT_TRUE(places.emplace(std::pair(one.group, one.id), one.pose.translation()).second);
  for (const Drawing& one : some) {
    const auto& place = places.at({one.group, one.id});
    EXPECT_EQ(place, one.pose.translation()) << one.group << " " << one.id;
  }
}

TEST(Drawings, FactsStandAboveTheirSubjectAndGoalsShowWhetherTheyAreReached) {
  const Poses poses = nominal_poses();
  const FactSet facts({{"On", "Mug_1", "Counter_1"},
                       {"state", "Mug_1", "Water"},
                       {"Near", "Robot", "Mug_1"},
                       {"IsGraspable", "Mug_1", ""},
                       {"Grasping", "Robot", "Kettle"}});
  Task task;
  task.instruction = "fill the mug";
  task.stage = "acting";
  task.goal.positive = {{"state", "Mug_1", "Water"}, {"On", "Mug_1", "Sink"}};
  task.goal.negative = {{"state", "SinkKnob", "TapIsOn"}};
  task.plan = {{"moveto", {"Sink"}}, {"turn-on", {"SinkKnob"}}};
  task.current = task.plan[1];
  std::vector<Drawing> out;
  draw_facts(kitchen(), poses, facts, out);
  draw_task(kitchen(), poses, facts, task, out);

  const Drawing* mug = find(out, "facts", "On Counter_1");
  ASSERT_NE(mug, nullptr);
  EXPECT_EQ(mug->text, "On Counter_1\nWater") << "no Near, no properties";
  const Eigen::Vector3d place = poses.at("Mug_1").translation();
  EXPECT_LT((mug->pose.translation() - place).head<2>().norm(), 0.06);
  EXPECT_GT(mug->pose.translation().z(), place.z() + kitchen().find_model_of("Mug_1")->height());

  const Drawing* reached = find(out, "goals", "Water");
  const Drawing* open = find(out, "goals", "On Sink");
  const Drawing* absent = find(out, "goals", "not TapIsOn");
  ASSERT_TRUE(reached != nullptr && open != nullptr && absent != nullptr);
  EXPECT_GT(reached->color[1], reached->color[0]) << "green";
  EXPECT_GT(open->color[0], open->color[1]) << "orange";
  EXPECT_GT(absent->color[1], absent->color[0]) << "what should not hold does not";
  EXPECT_GT(open->pose.translation().z(), reached->pose.translation().z()) << "not one over the other";

  const Drawing* what = find(out, "task", "fill the mug");
  ASSERT_NE(what, nullptr);
  EXPECT_THAT(what->text, HasSubstr("\n  moveto Sink\n> turn-on SinkKnob\nRobot: Grasping Kettle"));
}

TEST(Drawings, ALongTextEndsWithAWholeCharacter) {
  Task task;
  task.instruction =
      std::string(1998, 'a') + "\u00e4\u00e4";  // the quote before it makes the cut hit the first
  std::vector<Drawing> drawings;
  draw_task(kitchen(), nominal_poses(), {}, task, drawings);
  ASSERT_FALSE(drawings.empty());
  EXPECT_EQ(drawings.back().text, "\"" + std::string(1998, 'a'));
}

TEST(Drawings, PathFollowsBaseAndHand) {
  const auto robot = *robot::load_robot("default");
  const robot::Kinematics kinematics(robot);
  PlannedMotion motion{{"base_x", "base_y", "nobody_knows"}, {}};
  for (int i = 0; i <= 1000; ++i) motion.points.push_back({0.001 * i, -0.0005 * i, 1e9});
  std::vector<Drawing> out;
  draw_path(robot, kinematics, robot.home(), motion, out);
  ASSERT_EQ(out.size(), 3u) << "the hands go with the base";
  EXPECT_EQ(out[0].id, 0);
  EXPECT_LE(out[0].points.size(), 201u);
  EXPECT_NEAR((out[0].points.back() - out[0].points.front() - Eigen::Vector3d(1.0, -0.5, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((out[1].points.back() - out[1].points.front() - Eigen::Vector3d(1.0, -0.5, 0)).norm(), 0, 1e-9);
  EXPECT_GT(out[1].points.front().z(), 0.3);

  out.clear();
  draw_path(robot, kinematics, robot.home(), {{"base_x"}, {{0.0}, {0.001}}}, out);
  EXPECT_TRUE(out.empty()) << "too short to see";
  draw_path(robot, kinematics, robot.home(), {{"base_x"}, {{0.0}, {NAN}}}, out);
  draw_path(robot, kinematics, robot.home(), {{"base_x", "base_y"}, {{0.0}}}, out);
  draw_path(robot, kinematics, {}, {{"base_x"}, {{0.0}, {1.0}}}, out);
  EXPECT_TRUE(out.empty()) << "what makes no sense is not drawn";
}

TEST(MarkerWriter, EveryMessageIsCompleteAndNamesWhatIsGone) {
  MarkerWriter writer;
  Drawing a, b;
  a.group = b.group = "objects";
  a.id = 1;
  b.id = 2;
  const builtin_interfaces::msg::Time stamp = messages::to_stamp(42);
  const auto actions = [&](const std::vector<Drawing>& drawings) {
    std::map<int, int> out;
    const MarkerArray message = writer.write(drawings, stamp);
    for (const Marker& one : message.markers()) {
      EXPECT_EQ(one.header().frame_id(), "map");
      EXPECT_EQ(messages::to_nanoseconds(one.header().stamp()), 42);
      EXPECT_EQ(one.pose().orientation().w(), 1.0);
      out[one.id()] = one.action();
    }
    return out;
  };
  using Actions = std::map<int, int>;
  EXPECT_EQ(actions({a, b}), (Actions{{1, marker::ADD}, {2, marker::ADD}}));
  EXPECT_EQ(actions({a}), (Actions{{1, marker::ADD}, {2, marker::DELETE}}));
  EXPECT_EQ(actions({a}), (Actions{{1, marker::ADD}, {2, marker::DELETE}}))
      << "also for who missed the last one";
  EXPECT_EQ(actions({a, b}), (Actions{{1, marker::ADD}, {2, marker::ADD}}));
}

struct NodeTest : testing::Test {
  std::unique_ptr<ros::Context> context = ros::make_context(kDomain);
  ros::EventLoop loop;
  ros::Node world{*context, loop, ros::plain("world")};
  ros::Node node{*context, loop, ros::plain("visualization")};
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ObjectPoses>> poses =
      world.advertise<goalnet_msgs::msg::ObjectPoses>("object_poses");
  std::vector<MarkerArray> seen;

  goalnet_msgs::msg::ObjectPoses message(double x, std::int64_t stamp) {
    goalnet_msgs::msg::ObjectPoses out;
    out.header().stamp(messages::to_stamp(stamp));
    for (const char* name : {"Mug_1", "Nobody_1"}) {
      goalnet_msgs::msg::ObjectPose one;
      one.name(name);
      one.pose().position().x(x);
      one.pose().orientation().w(1.0);
      out.objects().push_back(one);
    }
    out.objects()[1].pose().position().y(NAN);
    return out;
  }
  std::shared_ptr<ros::Subscription<MarkerArray>> watch() {
    return world.subscribe<MarkerArray>("markers", ros::Qos::latched().keep_last(100),
                                        [this](const MarkerArray& m) { seen.push_back(m); });
  }
  double mug_x(const MarkerArray& message) {
    double sum = 0;
    int count = 0;
    for (const Marker& one : message.markers()) {
      if (one.ns() != "objects" || one.action() != marker::ADD) continue;
      sum += one.pose().position().x();
      ++count;
    }
    return count > 0 ? sum / count : NAN;
  }
};

TEST_F(NodeTest, DrawsOnChangeAndOnlyWhileSomebodyWatches) {
  auto made = VisualizationNode::create(node);
  ASSERT_TRUE(made) << made.error().message;
  loop.run_for(250ms);
  EXPECT_EQ(poses->subscriber_count(), 0u) << "nobody watches, so it does not listen";
  {
    auto viewer = watch();
    loop.run_for(3s, [&] { return poses->subscriber_count() > 0; });
    poses->publish(message(1.0, 5));
    loop.run_for(3s, [&] { return !seen.empty(); });
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_NEAR(mug_x(seen[0]), 1.0, 0.1);
    EXPECT_EQ(messages::to_nanoseconds(seen[0].markers()[0].header().stamp()), 5);
    for (int i = 0; i < 5; ++i) {
      poses->publish(message(1.0 + 1e-5 * i, 6 + i));
      loop.run_for(60ms);
    }
    EXPECT_EQ(seen.size(), 1u) << "nothing moved";
    poses->publish(message(2.0, 20));
    loop.run_for(3s, [&] { return seen.size() > 1; });
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_NEAR(mug_x(seen[1]), 2.0, 0.1);
    // A second viewer gets the picture at once: it is latched.
    std::vector<MarkerArray> late;
    auto second = world.subscribe<MarkerArray>("markers", ros::Qos::latched(),
                                               [&](const MarkerArray& m) { late.push_back(m); });
    loop.run_for(3s, [&] { return !late.empty(); });
    ASSERT_FALSE(late.empty());
    EXPECT_NEAR(mug_x(late[0]), 2.0, 0.1);
  }
  loop.run_for(3s, [&] { return poses->subscriber_count() == 0; });
  EXPECT_EQ(poses->subscriber_count(), 0u);
}

TEST_F(NodeTest, RefusesBadParameters) {
  ros::NodeOptions options = ros::plain("bad");
  options.arguments = *ros::parse_arguments({"--ros-args", "-p", "scene:=nowhere"});
  options.arguments.console = false;
  ros::Node bad(*context, loop, std::move(options));
  const auto made = VisualizationNode::create(bad);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(made.error().message, HasSubstr("nowhere"));
}

// The topics and groups that RViz is told to show are those that there are.
TEST(RvizConfiguration, ShowsWhatIsPublished) {
  const YAML::Node file = YAML::LoadFile(GOALNET_SOURCE_DIR "/config/rviz/goalnet.rviz");
  const YAML::Node manager = file["Visualization Manager"];
  EXPECT_EQ(manager["Global Options"]["Fixed Frame"].as<std::string>(), "map");
  std::map<std::string, YAML::Node> displays;
  for (const YAML::Node& display : manager["Displays"])
    displays[display["Class"].as<std::string>()] = display;
  const YAML::Node markers = displays["rviz_default_plugins/MarkerArray"];
  EXPECT_EQ(markers["Topic"]["Value"].as<std::string>(), "/markers");
  EXPECT_EQ(markers["Topic"]["Durability Policy"].as<std::string>(), "Transient Local");
  EXPECT_EQ(markers["Topic"]["Reliability Policy"].as<std::string>(), "Reliable");
  std::set<std::string> groups;
  for (const auto& entry : markers["Namespaces"]) groups.insert(entry.first.as<std::string>());
  EXPECT_EQ(groups,
            (std::set<std::string>{"facts", "fixtures", "goals", "objects", "parts", "path", "task"}));
  const YAML::Node robot = displays["rviz_default_plugins/RobotModel"];
  EXPECT_EQ(robot["Description Source"].as<std::string>(), "Topic");
  EXPECT_EQ(robot["Description Topic"]["Value"].as<std::string>(), "/robot_description");
  EXPECT_EQ(robot["Description Topic"]["Durability Policy"].as<std::string>(), "Transient Local");
  EXPECT_TRUE(displays.contains("rviz_default_plugins/TF"));
}

}  // namespace
}  // namespace goalnet::visualization
