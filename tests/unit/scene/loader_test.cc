// Every mistake in a scene file is answered with the file, the line and what to do.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/scene/scene.h"

namespace goalnet::scene {
namespace {

using testing::HasSubstr;

class Loader : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("goalnet_scene_test_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_ / "scenes");
    std::filesystem::create_directories(folder_ / "objects");
    write("objects/things.yaml",
          "models:\n"
          "  cup:\n"
          "    properties: [IsGraspable]\n"
          "    mass: 0.3\n"
          "    shapes: [{cylinder: [0.04, 0.1], at: [0, 0, 0.05]}]\n"
          "    grasps: [{name: side, kind: around, width: 0.08, span: [0.03, 0.07]}]\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  Expected<Scene> load(const std::string& text) const {
    write("scenes/test.yaml", text);
    return load_scene((folder_ / "scenes" / "test.yaml").string());
  }
  // The message of a file that must be refused.
  std::string refusal(const std::string& text) const {
    auto scene = load(text);
    if (scene) return "accepted";
    EXPECT_EQ(scene.error().outcome, Outcome::kInvalidRequest);
    return scene.error().message;
  }

  std::filesystem::path folder_;
};

constexpr const char* kGood =
    "scene: test\n"                                                                      // 1
    "libraries: [things]\n"                                                              // 2
    "floor: {x: [-2, 2], y: [-2, 2]}\n"                                                  // 3
    "fixtures:\n"                                                                        // 4
    "  - name: Table\n"                                                                  // 5
    "    at: [1, 0, 0]\n"                                                                // 6
    "    shapes: [{box: [0.6, 1.0, 0.8], at: [0.3, 0, 0.4]}]\n"                          // 7
    "    parts:\n"                                                                       // 8
    "      - name: Lid\n"                                                                // 9
    "        joint: {type: revolute, at: [0, 0, 1], axis: [0, 0, 1], range: [0, 90]}\n"  // 10
    "        mass: 1\n"                                                                  // 11
    "        shapes: [{box: [0.1, 0.1, 0.1]}]\n"                                         // 12
    "regions:\n"                                                                         // 13
    "  - name: Table\n"                                                                  // 14
    "    relation: On\n"                                                                 // 15
    "    fixture: Table\n"                                                               // 16
    "    supports: [{at: [0.3, 0, 0.8], size: [0.5, 0.9]}]\n"                            // 17
    "objects:\n"                                                                         // 18
    "  - {name: Cup_1, model: cup, on: Table, at: [0, 0.2, 0]}\n";                       // 19

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(Loader, ReadsAGoodScene) {
  auto scene = load(kGood);
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->objects.size(), 1u);
  EXPECT_NEAR(scene->objects[0].placement.pose.translation().x(), 1.3, 1e-12);
  EXPECT_NEAR(scene->objects[0].placement.pose.translation().z(), 0.8, 1e-12);
  EXPECT_EQ(scene->find_part("Lid").part->joint.name, "Lid_joint");
}

TEST_F(Loader, MissingKey) {
  EXPECT_THAT(
      refusal(with(kGood,
                   "    at: [1, 0, 0]\n    shapes: [{box: [0.6, 1.0, 0.8], at: [0.3, 0, 0.4]}]\n    parts:\n "
                   "     - name: Lid\n        joint",
                   "    parts:\n      - name: Lid\n        jiont")),
      testing::AllOf(HasSubstr("test.yaml:"), HasSubstr("'jiont' is not known here; did you mean 'joint'?")));
  EXPECT_THAT(refusal(with(kGood, "        mass: 1\n", "")), HasSubstr("key 'mass' is missing; add it"));
}

TEST_F(Loader, NamesTheLine) {
  EXPECT_THAT(refusal(with(kGood, "mass: 1", "mass: heavy")),
              HasSubstr("test.yaml:11: 'mass' must be a number"));
}

TEST_F(Loader, NotANumberAndInfinity) {
  EXPECT_THAT(refusal(with(kGood, "mass: 1", "mass: .nan")),
              HasSubstr("test.yaml:11: 'mass' must be a finite number"));
  EXPECT_THAT(refusal(with(kGood, "at: [1, 0, 0]", "at: [1, .inf, 0]")),
              HasSubstr("test.yaml:6: 'at' must be a finite number"));
}

TEST_F(Loader, NegativeMass) {
  EXPECT_THAT(refusal(with(kGood, "mass: 1", "mass: -1")),
              HasSubstr("test.yaml:11: 'mass' is -1 but must be between"));
  write("objects/things.yaml", "models:\n  cup:\n    mass: -0.3\n    shapes: [{sphere: [0.1]}]\n");
  EXPECT_THAT(refusal(kGood), HasSubstr("things.yaml:3: 'mass' is -0.3"));
}

TEST_F(Loader, ZeroSizedShape) {
  EXPECT_THAT(refusal(with(kGood, "{box: [0.1, 0.1, 0.1]}", "{box: [0.1, 0, 0.1]}")),
              HasSubstr("test.yaml:12: 'box' is 0 but must be"));
}

TEST_F(Loader, UnknownNamesComeWithTheNearestKnown) {
  EXPECT_THAT(refusal(with(kGood, "model: cup", "model: cub")),
              HasSubstr("unknown model 'cub'; did you mean 'cup'?"));
  EXPECT_THAT(refusal(with(kGood, "on: Table, at", "on: Tabel, at")), HasSubstr("did you mean 'Table'?"));
  EXPECT_THAT(refusal(with(kGood, "fixture: Table", "fixture: Chair")), HasSubstr("unknown fixture 'Chair'"));
  EXPECT_THAT(refusal(std::string(kGood) + "rules:\n  joint_facts: [{fact: (state Cup_1 Up), joint: "
                                           "Lit_joint, unit: deg, on_above: 4, off_below: 2}]\n"),
              HasSubstr("unknown joint 'Lit_joint'; did you mean 'Lid_joint'?"));
}

TEST_F(Loader, CyclesOfPartsCannotBeWritten) {
  EXPECT_THAT(refusal(with(kGood, "      - name: Lid\n", "      - name: Lid\n        parent: Lid\n")),
              HasSubstr("has the parent 'Lid', which is not a part listed before it"));
}

TEST_F(Loader, DuplicateNames) {
  EXPECT_THAT(refusal(std::string(kGood) + "  - {name: Cup_1, model: cup, on: Table, at: [0, -0.2, 0]}\n"),
              HasSubstr("object 'Cup_1' is defined twice"));
  EXPECT_THAT(refusal(std::string(kGood) + "scene: again\n"), HasSubstr("key 'scene' stands twice"));
}

TEST_F(Loader, JointsNeedASensibleAxisAndRange) {
  EXPECT_THAT(refusal(with(kGood, "axis: [0, 0, 1]", "axis: [0, 0, 0]")), HasSubstr("has no direction"));
  EXPECT_THAT(refusal(with(kGood, "range: [0, 90]", "range: [90, 0]")),
              HasSubstr("must be [least, greatest]"));
}

TEST_F(Loader, GraspableModelsNeedGrasps) {
  write("objects/things.yaml",
        "models:\n  cup:\n    properties: [IsGraspable]\n    mass: 0.3\n    shapes: [{sphere: [0.1]}]\n");
  EXPECT_THAT(refusal(kGood), HasSubstr("model 'cup' IsGraspable but has no grasps"));
}

TEST_F(Loader, ReportsAllMistakesAtOnce) {
  const std::string message = refusal(with(with(kGood, "mass: 1", "mass: -1"), "model: cup", "model: jar"));
  EXPECT_THAT(message, HasSubstr("'mass' is -1"));
  EXPECT_THAT(message, HasSubstr("unknown model 'jar'"));
}

TEST_F(Loader, BrokenYaml) {
  EXPECT_THAT(refusal("scene: [test\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(refusal("- a\n- b\n"), HasSubstr("must be a map"));
  EXPECT_THAT(refusal(""), HasSubstr("must be a map"));
  EXPECT_NE(refusal(std::string("scene: \0test", 12)), "accepted");
  EXPECT_NE(refusal("scene: &a {b: *a}\n"), "accepted");
}

TEST_F(Loader, FilesThatAreTooLargeAreRefusedQuickly) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(refusal(std::string(5u << 20, '#')), HasSubstr("larger than 4 MiB"));
  // A "billion laughs" bomb: aliases of aliases. Only the keys of the schema are read, nothing is expanded.
  std::string bomb = "a: &a [1,1,1,1,1,1,1,1,1]\n";
  for (char c = 'b'; c < 'k'; ++c) {
    bomb += std::string(1, c) + ": &" + c + " [";
    for (int i = 0; i < 9; ++i) bomb += std::string(i != 0 ? "," : "") + "*" + static_cast<char>(c - 1);
    bomb += "]\n";
  }
  EXPECT_NE(refusal(bomb), "accepted");
  EXPECT_NE(refusal(std::string(100'000, '[')), "accepted");
  std::string many = std::string(kGood);
  for (int i = 0; i < 11'000; ++i) many += "  - {name: C" + std::to_string(i) + ", model: cup}\n";
  EXPECT_THAT(refusal(many), HasSubstr("at most 10000 long"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

// A room of one's own, anywhere, with things of one's own beside it and the ones that ship.
TEST_F(Loader, LibrariesLieWithTheSceneBesideItOrInConfig) {
  std::filesystem::create_directories(folder_ / "elsewhere" / "deep");
  std::filesystem::copy_file(folder_ / "objects/things.yaml", folder_ / "elsewhere/deep/things.yaml");
  write("elsewhere/deep/kitchen.yaml", with(kGood, "libraries: [things]", "libraries: [things, kitchen]"));
  const auto scene = load_scene((folder_ / "elsewhere/deep/kitchen.yaml").string());
  ASSERT_TRUE(scene) << scene.error().message;
  const auto has = [&](const char* name) {
    return std::any_of(scene->models.begin(), scene->models.end(),
                       [&](const ObjectModel& model) { return model.name == name; });
  };
  EXPECT_TRUE(has("cup")) << "beside the scene";
  EXPECT_TRUE(has("mug")) << "of the library that ships, not of the scene of that name";
}

TEST_F(Loader, MissingFilesAndUnknownScenes) {
  EXPECT_THAT(load_scene("/nowhere/at/all.yaml").error().message, HasSubstr("cannot be opened"));
  EXPECT_THAT(load_scene(folder_.string() + "/").error().message, HasSubstr("cannot be read"));
  const std::string message = load_scene("kitchn").error().message;
  EXPECT_THAT(message, HasSubstr("unknown scene 'kitchn'; known: "));
  EXPECT_THAT(message, HasSubstr("kitchen"));
  EXPECT_THAT(refusal(with(kGood, "libraries: [things]", "libraries: [stuff]")),
              testing::AllOf(HasSubstr("library 'stuff': there is none of these: "),
                             HasSubstr((folder_ / "objects/stuff.yaml").string()),
                             HasSubstr((folder_ / "scenes/stuff.yaml").string())));

  setenv("GOALNET_CONFIG_DIR", "/no/such/folder", 1);
  const auto nowhere = load_scene("kitchen");
  unsetenv("GOALNET_CONFIG_DIR");
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("/no/such/folder/scenes holds no scenes"));
}

}  // namespace
}  // namespace goalnet::scene
