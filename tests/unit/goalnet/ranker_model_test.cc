// Training, writing, reading and asking a small ranker.
#include "components/goalnet/ranker/ranker_model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "components/goalnet/ranker/train.h"
#include "tests/unit/goalnet/played.h"

namespace goalnet::inference {
namespace {

const char* kObjects[] = {"Mug_1", "Kettle", "Glass_1", "Plate_1", "Spoon_1", "Bowl_1"};
const char* kWords[] = {"mug", "kettle", "glass", "plate", "spoon", "bowl"};

// Made-up people who take what they are told to take, or put it into the sink.
std::vector<Demonstration> takers_and_putters() {
  std::vector<Demonstration> all;
  for (int i = 0; i < 36; ++i) {
    const std::string object = kObjects[i % 6], word = kWords[i % 6];
    const bool put = i / 6 % 2 == 0;
    Demonstration d;
    d.scenario = std::to_string(i);
    d.id = d.scenario + "_1";
    d.sentence = put ? "put the " + word + " in the sink" : "grab the " + word;
    Symbols symbols;
    std::vector<Predicate> facts;
    for (const char* name : kObjects)
      facts.push_back({"IsGraspable", name, ""}), facts.push_back({"On", name, "StoveFire_1"});
    d.states.push_back({{"Counter_1", "Robot", "Sink", "SinkKnob", "StoveFire_1", "Mug_1", "Kettle",
                         "Glass_1", "Plate_1", "Spoon_1", "Bowl_1"},
                        FactSet(facts)});
    d.actions = {"moveto " + object, "grasp " + object};
    if (put) d.actions.insert(d.actions.end(), {"moveto Sink", "keep " + object + " On Sink"});
    play_actions(d, symbols);
    all.push_back(d);
  }
  return all;
}

RankerParts trained(bool rerank) {
  TrainingOptions options;
  options.language.household = household_words();
  options.command = "goalnet train people -o model";
  options.rerank = rerank;
  options.ranker.training.epochs = 8;
  options.ranker.samples = 10;
  options.progress = {};
  auto parts = train(takers_and_putters(), options);
  EXPECT_TRUE(parts) << parts.error().message;
  return std::move(*parts);
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class RankerFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("goalnet_ranker_" + std::to_string(::getpid()));
};

TEST_F(RankerFile, TrainingIsBitIdenticalAndSurvivesTheFile) {
  const auto a = folder / "a.safetensors", b = folder / "b.safetensors";
  ASSERT_TRUE(write_ranker(trained(true), a));
  ASSERT_TRUE(write_ranker(trained(true), b));
  EXPECT_EQ(bytes_of(a), bytes_of(b));
  const auto file = SafeTensors::load(a);
  ASSERT_TRUE(file);
  EXPECT_EQ(*file->metadata("goalnet.kind"), "ranker");
  EXPECT_EQ(*file->metadata("goalnet.command"), "goalnet train people -o model");
  EXPECT_EQ(file->metadata("goalnet.data_fingerprint")->size(), 16u);
  auto parts = read_ranker(*file);
  ASSERT_TRUE(parts) << parts.error().message;
  ASSERT_TRUE(write_ranker(*parts, b));
  const auto again = SafeTensors::load(b);
  ASSERT_TRUE(again);
  const std::uint64_t shape[] = {0};
  EXPECT_EQ(again->floats("none.policy", shape)->values, file->floats("none.policy", shape)->values);
}

TEST_F(RankerFile, LearnsWhatPeopleDo) {
  RankerModel model(trained(false), ModelUse::kBenchmark);
  const auto world = takers_and_putters()[0].states[0];
  std::vector<WorldState> states = {world};
  std::vector<Goal> goals;
  for (const char* want :
       {"(Near Robot Bowl_1)", "(Grasping Robot Bowl_1)", "(Near Robot Sink)", "(On Bowl_1 Sink)"}) {
    const auto goal = model.infer(
        {.sentence = "put the bowl in the sink", .grounding = nullptr, .states = states, .goals = goals});
    ASSERT_TRUE(goal);
    ASSERT_FALSE(goal->empty()) << want;
    FactSet facts = states.back().facts;
    for (const Predicate& fact : goal->negative) facts.erase(fact);
    for (const Predicate& fact : goal->positive) facts.insert(fact);
    EXPECT_TRUE(facts.contains(*parse_predicate(want))) << want;
    states.push_back({world.objects, facts});
    goals.push_back(*goal);
  }
  const auto rest = model.infer(
      {.sentence = "put the bowl in the sink", .grounding = nullptr, .states = states, .goals = goals});
  ASSERT_TRUE(rest);
  EXPECT_TRUE(rest->empty());
}

TEST_F(RankerFile, AnswersDoNotDependOnWhatWasAskedBefore) {
  const auto world = takers_and_putters()[0].states[0];
  const std::vector<WorldState> states = {world};
  const StepInput grab{.sentence = "grab the spoon", .grounding = nullptr, .states = states, .goals = {}};
  const StepInput put{
      .sentence = "put the mug in the sink", .grounding = nullptr, .states = states, .goals = {}};
  RankerModel one(trained(false), ModelUse::kBenchmark), other(trained(false), ModelUse::kBenchmark);
  const auto first = one.infer(grab);
  ASSERT_TRUE(other.infer(put));
  const auto second = other.infer(grab);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->positive, second->positive);
  EXPECT_EQ(first->confidence, second->confidence);
}

TEST_F(RankerFile, DamagedFilesAreRefusedWithOneMessage) {
  const auto path = folder / "model.safetensors";
  ASSERT_TRUE(write_ranker(trained(true), path));
  EXPECT_EQ(load_model(folder / "none.safetensors").error().outcome, Outcome::kInvalidRequest);
  const std::string good = bytes_of(path);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{100}, good.size() / 2, good.size() - 1}) {
    std::ofstream(path, std::ios::binary) << good.substr(0, length);
    const auto model = load_model(path);
    ASSERT_FALSE(model) << length;
    EXPECT_EQ(model.error().outcome, Outcome::kInvalidRequest);
  }
  // Every metadata key and tensor is needed: rename each in turn.
  for (const std::string& key : std::initializer_list<std::string>{
           "goalnet.kind", "goalnet.language", "goalnet.english", "goalnet.words", "goalnet.names",
           "goalnet.config", "none.policy", "none.memory.counts", "none.memory.layouts", "none.memory.steps",
           "none.trees.roots"}) {
    std::string bad = good;
    const std::size_t at = bad.find("\"" + key + "\"");
    ASSERT_NE(at, std::string::npos) << key;
    bad[at + key.size()] = 'Z';
    std::ofstream(path, std::ios::binary) << bad;
    const auto model = load_model(path);
    ASSERT_FALSE(model) << key;
    EXPECT_FALSE(model.error().message.empty());
  }
}

TEST_F(RankerFile, TrainingCanBeStopped) {
  TrainingOptions options;
  options.language.household = household_words();
  options.progress = [](const std::string&, double) { return false; };
  EXPECT_EQ(train(takers_and_putters(), options).error().outcome, Outcome::kCancelled);
}

}  // namespace
}  // namespace goalnet::inference
