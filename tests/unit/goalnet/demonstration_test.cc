#include "components/goalnet/demonstration.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace goalnet::inference {
namespace {

constexpr const char* kGood =
    R"json({"sent": "grasp the mug", "filename": "7", "arg_mapping": {"mug": ["(Mug_1)"]},
  "initial_states": [["(IsGraspable Mug_1)", "(Near Robot Mug_1)"], ["(IsGraspable Mug_1)", "(Grasping Robot Mug_1)"]],
  "action_seq": ["grasp Mug_1", "noop"]})json";

TEST(Demonstration, ReadsAllParts) {
  const auto d = parse_demonstration(kGood, "7_12.json");
  ASSERT_TRUE(d) << d.error().message;
  EXPECT_EQ(d->id, "7_12");
  EXPECT_EQ(d->scenario, "7");
  EXPECT_FALSE(d->perturbed);
  EXPECT_EQ(d->grounding.at("mug"), std::vector<std::string>{"Mug_1"});
  ASSERT_EQ(d->states.size(), 2u);
  EXPECT_EQ(d->actions, std::vector<std::string>{"grasp Mug_1"});
  ASSERT_EQ(d->steps.size(), 1u);
  EXPECT_EQ(d->steps[0].positive, (std::vector<Predicate>{{"Grasping", "Robot", "Mug_1"}}));
  EXPECT_EQ(d->steps[0].negative, (std::vector<Predicate>{{"Near", "Robot", "Mug_1"}}));
}

TEST(Demonstration, PerturbedFilesBelongToTheirScenario) {
  const auto d = parse_demonstration(kGood, "a_3.json");
  ASSERT_TRUE(d);
  EXPECT_TRUE(d->perturbed);
  EXPECT_EQ(d->scenario, "7");
}

// What is wrong, and the word that the message must hold.
struct Fault {
  const char* json;
  const char* word;
};

class BadDemonstration : public testing::TestWithParam<Fault> {};

TEST_P(BadDemonstration, IsRefusedWithItsNameAndReason) {
  const auto d = parse_demonstration(GetParam().json, "some/1_2.json");
  ASSERT_FALSE(d);
  EXPECT_EQ(d.error().outcome, Outcome::kInvalidRequest);
  EXPECT_NE(d.error().message.find("1_2.json"), std::string::npos) << d.error().message;
  EXPECT_NE(d.error().message.find(GetParam().word), std::string::npos) << d.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadDemonstration,
    testing::Values(
        Fault{"", "JSON"}, Fault{"[1, 2]", "object"}, Fault{"{\"sent\": 3}", "sent"},
        Fault{"{\"sent\": \"a\"}", "initial_states"},
        Fault{"{\"sent\": \"a\", \"initial_states\": []}", "empty"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [3]}", "initial_states[0]"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [[3]]}", "On Mug_1 Sink"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [[\"(On Mug_1\"]]}", "parentheses"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [[]]}", "action_seq"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [[]], \"action_seq\": [1]}", "action_seq"},
        Fault{"{\"sent\": \"a\", \"initial_states\": [[]], \"action_seq\": [\"fly Mug_1\"]}", "states"},
        Fault{"{\"sent\": \"a\", \"arg_mapping\": [], \"initial_states\": [[]], \"action_seq\": []}",
              "arg_mapping"},
        Fault{"{\"sent\": \"a\", \"arg_mapping\": {\"x\": 1}, \"initial_states\": [[]], \"action_seq\": []}",
              "arg_mapping.x"}));

TEST(Demonstration, OneStateAndNoActionIsFine) {
  const auto d =
      parse_demonstration(R"({"sent": "", "initial_states": [[]], "action_seq": ["noop"]})", "1_1.json");
  ASSERT_TRUE(d) << d.error().message;
  EXPECT_TRUE(d->steps.empty());
}

TEST(Demonstrations, FolderFaultsAreTold) {
  EXPECT_FALSE(read_demonstrations("/nowhere/at/all"));
  const auto folder =
      std::filesystem::temp_directory_path() / ("goalnet_demonstrations_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  EXPECT_NE(read_demonstrations(folder).error().message.find("no demonstrations"), std::string::npos);
  std::ofstream(folder / "2_1.json") << kGood;
  std::ofstream(folder / "1_1.json") << kGood;
  const auto both = read_demonstrations(folder);
  ASSERT_TRUE(both);
  EXPECT_EQ((*both)[0].id, "1_1");
  std::filesystem::remove_all(folder);
}

TEST(Demonstrations, FingerprintSeesEveryChange) {
  const auto one = *parse_demonstration(kGood, "7_12.json");
  auto other = one;
  other.sentence += "s";
  EXPECT_EQ(fingerprint({one}), fingerprint({one}));
  EXPECT_NE(fingerprint({one}), fingerprint({other}));
  EXPECT_NE(fingerprint({one}), fingerprint({one, one}));
}

}  // namespace
}  // namespace goalnet::inference
