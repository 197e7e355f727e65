// What people get wrong on the command line: one clear message, the documented exit code, nothing left
// behind.
#include <gmock/gmock-more-matchers.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"

namespace goalnet {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing_support::ProcessResult;

constexpr int kDomain = 81;

ProcessResult run(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"run"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return testing_support::run_goalnet(all, kDomain, {}, std::chrono::seconds(60));
}

// A folder that goes with the test.
class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("goalnet-bad-input-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    EXPECT_THAT(testing_support::shared_memory_of_domain(kDomain), testing::IsEmpty()) << "left behind";
  }
  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return (folder_ / name).string();
  }
  static void expect_refused(const ProcessResult& result, const std::string& part) {
    EXPECT_EQ(result.exit_code, 13) << result.err;
    EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_EQ(result.out, "");
    EXPECT_LT(result.err.size(), 2000u) << "one message, not a flood";
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(BadInput, EmptyInstruction) {
  expect_refused(run({""}), "the instruction is empty");
  expect_refused(run({"  \t"}), "the instruction is empty");
  expect_refused(run({}), "the instruction is empty");
}

TEST_F(BadInput, InstructionThatIsNoText) {
  expect_refused(run({"open \xff\xfe"}), "UTF-8");
  expect_refused(run({"open \x01 the fridge"}), "control characters");
  expect_refused(run({std::string(100'000, 'a')}), "100000 bytes");
}

TEST_F(BadInput, RefusalAsJson) {
  const ProcessResult result = run({"--json", ""});
  EXPECT_EQ(result.exit_code, 13);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["outcome"], "invalid_request");
  EXPECT_THAT(json["message"].get<std::string>(), HasSubstr("empty"));
}

// "--json prints one JSON object on standard output": also when nothing can be done, and when what is to be
// repeated in it is not UTF-8.
TEST_F(BadInput, EveryCommandRefusesAsJson) {
  const std::string state = file("state.json", R"~({"objects": [], "facts": ["(On Mug_1 Sink)"]})~");
  const std::vector<std::vector<std::string>> cases = {{"run", "open \xff\xfe"},
                                                       {"run", "--seed", "-1", "open the microwave"},
                                                       {"infer", state, "open \xff\xfe"},
                                                       {"infer", state},
                                                       {"infer", "/no/such", "open it"},
                                                       {"plan", "/no/such.pddl", "/no/such.pddl"},
                                                       {"plan", "--no-such-option"},
                                                       {"eval", "/no/such/folder"},
                                                       {"eval", "/no/such/folder", "--physics"},
                                                       {"train", "/no/such/folder", "-o", state},
                                                       {"bench", "no-such-benchmark"}};
  for (std::vector<std::string> words : cases) {
    words.push_back("--json");
    const ProcessResult result = testing_support::run_goalnet(words, kDomain, {}, std::chrono::seconds(60));
    EXPECT_EQ(result.exit_code, 13) << words[0] << ": " << result.err;
    EXPECT_THAT(result.err, testing::StartsWith("goalnet " + words[0] + ": "));
    const auto json = nlohmann::json::parse(result.out, nullptr, false);
    ASSERT_TRUE(json.is_object()) << words[0] << " " << words[1] << ": " << result.out;
    EXPECT_EQ(json["outcome"], "invalid_request");
    EXPECT_NE(json["message"], "");
  }
}

TEST_F(BadInput, AModelThatCannotBeWrittenIsToldBeforeTheTraining) {
  const ProcessResult result =
      testing_support::run_goalnet({"train", "/no/such/folder", "-o", "/tmp"}, kDomain);
  EXPECT_EQ(result.exit_code, 13);
  EXPECT_THAT(result.err, HasSubstr("/tmp is a folder"));
}

TEST_F(BadInput, SeedThatIsNone) {
  expect_refused(run({"--seed", "-1", "open the microwave"}), "--seed");
  expect_refused(run({"--seed", "99999999999999999999999", "open the microwave"}), "--seed");
}

TEST_F(BadInput, FilesWithoutAnEnd) {
  const std::chrono::seconds limit(20);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"run", "--robot", "/dev/zero", "open it"},
                                             {"run", "--scene", "/dev/zero", "open it"},
                                             {"run", "--model", "/dev/zero", "open it"},
                                             {"run", "open it", "--ros-args", "--params-file", "/dev/zero"},
                                             {"infer", "/dev/zero", "open it"},
                                             {"plan", "/dev/zero", "/dev/zero"},
                                             {"launch", "/dev/zero"}}) {
    const ProcessResult result = testing_support::run_goalnet(words, kDomain, {}, limit);
    EXPECT_EQ(result.exit_code, 13) << words[1] << ": " << result.err;
    EXPECT_THAT(result.err, HasSubstr("/dev/zero")) << words[0] << " " << words[1];
  }
}

TEST_F(BadInput, StateThatIsNone) {
  for (const std::string content :
       {R"({"facts": 3})", R"({"facts": [3]})", R"({"facts": [], "objects": {}})", "[]"}) {
    const std::string state = file("state.json", content);
    const ProcessResult result =
        testing_support::run_goalnet({"infer", state, "open it"}, kDomain, {}, std::chrono::seconds(20));
    expect_refused(result, "should be");
  }
}

TEST_F(BadInput, PicturesThatCannotBeWritten) {
  expect_refused(run({"--render", "/proc/pictures", "open the microwave"}), "/proc/pictures");
}

TEST_F(BadInput, UnknownScene) { expect_refused(run({"--scene", "garage", "open the microwave"}), "garage"); }

TEST_F(BadInput, UnknownRobot) {
  expect_refused(run({"--robot", "/no/such/robot.yaml", "open the microwave"}), "/no/such/robot.yaml");
}

TEST_F(BadInput, UnknownModel) {
  expect_refused(run({"--model", "/no/such/model.safetensors", "open the microwave"}),
                 "/no/such/model.safetensors");
}

TEST_F(BadInput, TruncatedModel) {
  // A header that promises more than there is.
  std::string header = R"({"a":{"dtype":"F32","shape":[1000],"data_offsets":[0,4000]}})";
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>((header.size() >> (8 * i)) & 0xff));
  const std::string path = file("truncated.safetensors", bytes + header + std::string(100, '\0'));
  expect_refused(run({"--model", path, "open the microwave"}), "truncated.safetensors");
}

TEST_F(BadInput, HostileModel) {
  // A header length near 2^64.
  const std::string huge = file("huge.safetensors", std::string(8, '\xff') + "{}");
  expect_refused(run({"--model", huge, "open the microwave"}), "huge.safetensors");
  const std::string nonsense = file("nonsense.safetensors", std::string(5000, '['));
  expect_refused(run({"--model", nonsense, "open the microwave"}), "nonsense.safetensors");
}

TEST_F(BadInput, MalformedSceneYaml) {
  const std::string broken = file("broken.yaml", "scene: kitchen\nfixtures: [ {name: ");
  expect_refused(run({"--scene", broken, "open the microwave"}), "broken.yaml");
  const std::string wrong = file("wrong.yaml", "scene: kitchen\nfixtures: 7\n");
  expect_refused(run({"--scene", wrong, "open the microwave"}), "wrong.yaml");
}

TEST_F(BadInput, MalformedUrdf) {
  file("robot.urdf", "<robot name='broken'><link name='a'><joint></robot>");
  const std::string yaml = file("robot.yaml", "urdf: robot.urdf\n");
  const ProcessResult result = run({"--robot", yaml, "open the microwave"});
  EXPECT_EQ(result.exit_code, 13) << result.err;
  EXPECT_THAT(result.err, AnyOf(HasSubstr("robot.urdf"), HasSubstr("robot.yaml")));
}

TEST_F(BadInput, MalformedPddl) {
  const std::string path = file("broken.pddl", "(define (domain broken) (:predicates (On ?a ?b)");
  const ProcessResult result = run({"open the microwave", "--ros-args", "-p", "domain:=" + path});
  EXPECT_EQ(result.exit_code, 13) << result.err;
  EXPECT_THAT(result.err, HasSubstr("broken.pddl:"));
}

TEST_F(BadInput, MalformedRosArguments) {
  expect_refused(run({"open the microwave", "--ros-args", "-p", "no-value"}), "no-value");
  expect_refused(run({"open the microwave", "--ros-args", "-p", "node_limitt:=5"}),
                 "did you mean node_limit (of planner)?");
  expect_refused(run({"open the microwave", "--ros-args", "-p", "plannr:node_limit:=5"}),
                 "there is no node 'plannr' (did you mean planner?)");
  expect_refused(run({"open the microwave", "--ros-args", "-p", "coordinator:node_limit:=5"}),
                 "coordinator has no such parameter");
}

TEST_F(BadInput, MalformedGoal) {
  expect_refused(run({"--goal", "(On Mug_1 Sink"}), "unbalanced");
  expect_refused(run({"--goal", "(On Mug_1 Sink)", "--goal", "not (On Mug_1 Sink)"}), "excludes it at once");
}

TEST_F(BadInput, UnknownComponent) {
  const ProcessResult result = testing_support::run_goalnet({"component", "planer"}, kDomain);
  EXPECT_EQ(result.exit_code, 13);
  EXPECT_THAT(result.err, HasSubstr("planer"));
}

TEST_F(BadInput, UnknownCommand) {
  const ProcessResult result = testing_support::run_goalnet({"rum"}, kDomain);
  EXPECT_EQ(result.exit_code, 13);
  EXPECT_THAT(result.err, HasSubstr("did you mean \"run\""));
}

}  // namespace
}  // namespace goalnet
