// Testing with other sentences than the recorded ones: the table, what is tested with it, what training
// hears.
#include "components/goalnet/other_sentences.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <functional>

#include "components/core/config_path.h"
#include "components/goalnet/evaluation.h"
#include "components/goalnet/ranker/cross_validation.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet/played.h"

namespace goalnet::inference {
namespace {

const std::filesystem::path kTables = GOALNET_SOURCE_DIR "/tests/data/generalisation";
const std::filesystem::path kShared = GOALNET_SOURCE_DIR "/../shared";

// A file that is gone after the test.
class Table {
 public:
  explicit Table(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("goalnet_sentences_" + std::to_string(::getpid()) + ".tsv")) {
    std::ofstream(path_) << text;
  }
  ~Table() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string problem(const std::string& text) {
  const Table table(text);
  const auto read = read_other_sentences(table.path());
  return read ? "none" : read.error().message.substr(table.path().string().size());
}

TEST(OtherSentences, AreReadFromATable) {
  const Table table("# file, sentence\n1_2.json\tgrab it\r\n\n3_4.json\tput it down\n");
  const auto read = read_other_sentences(table.path());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, (OtherSentences{{"1_2", "grab it"}, {"3_4", "put it down"}}));
}

TEST(OtherSentences, SayWhichLineIsWrongAndHow) {
  EXPECT_EQ(problem("1_2.json\ttake it\n3_4.json take it\n"),
            ":2: should be the file name of a demonstration, a tab and a sentence");
  EXPECT_EQ(problem("1_2\ttake it\n"),
            ":1: \"1_2\" should be the file name of a demonstration, like 263_450.json");
  EXPECT_EQ(problem(".json\ttake it\n").substr(0, 9), ":1: \".jso");
  EXPECT_EQ(problem("1_2.json\t \n"), ":1: the sentence is missing");
  EXPECT_EQ(problem("1_2.json\ttake\tit\n"), ":1: has more than one tab");
  EXPECT_EQ(problem("1_2.json\ttake it\n1_2.json\tgrab it\n"), ":2: 1_2.json has a sentence already");
  EXPECT_EQ(problem("1_2.json\ttake \xff it\n"), ":1: the instruction is not valid UTF-8 at byte 5");
  EXPECT_EQ(problem("\n# nothing\n"), ": holds no sentences");
  EXPECT_EQ(read_other_sentences("/nowhere/at/all.tsv").error().message,
            "/nowhere/at/all.tsv: cannot be read");
  EXPECT_FALSE(read_other_sentences(std::filesystem::temp_directory_path())) << "a folder";
}

// People who take what they are told to take.
std::vector<Demonstration> people() {
  const std::vector<Thing> things = {{"Mug_1", "mug"}, {"Kettle", "kettle"}, {"Plate_1", "plate"}};
  std::vector<Demonstration> all;
  for (int i = 0; i < 24; ++i) {
    const Thing& thing = things[static_cast<std::size_t>(i % 3)];
    all.push_back(taken(things, thing, i / 2, i, "take " + thing.word));
    all.back().grounding = {{thing.word, {thing.name}}};
  }
  return all;
}

TEST(OtherSentences, MustFitTheDemonstrations) {
  auto all = people();
  EXPECT_TRUE(check_other_sentences({{"0_0", "grab it"}}, all));
  EXPECT_EQ(check_other_sentences({{"0_0", "grab it"}, {"7_7", "x"}, {"8_8", "x"}}, all).error().message,
            "7_7.json: has a sentence, but is no demonstration of the folder (and 1 more)");
  EXPECT_EQ(count_left_out({{"0_0", "grab it"}}, all), 23u);
  all.front().perturbed = true;
  EXPECT_EQ(count_left_out({{"0_1", "grab it"}}, all), 22u) << "perturbed ones are never tested";
  EXPECT_NE(check_other_sentences({{"0_0", "grab it"}}, all).error().message.find("perturbed"),
            std::string::npos);
  const Demonstration other = with_sentence(all[0], {{"0_0", "grab it"}});
  EXPECT_EQ(other.sentence, "grab it");
  EXPECT_EQ(other.grounding, all[0].grounding);
  EXPECT_EQ(with_sentence(all[1], {{"0_0", "grab it"}}).sentence, all[1].sentence);
}

// Mean SJI by cross-validation when `sentence` makes something of every recorded word.
double tested_with(bool grounding, const std::function<std::string(const std::string& word)>& sentence) {
  const auto all = people();
  CrossValidationOptions options;
  options.grounding = grounding;
  options.training.language = {household_words(), "", ""};
  options.training.rerank = false;
  options.training.ranker.training.epochs = 8;
  options.training.ranker.samples = 8;
  for (const Demonstration& d : all) options.sentences[d.id] = sentence(d.sentence.substr(5));
  const auto folds = make_folds(all, FoldBy::kScenario, 2, 7, options.training.language);
  const auto scores = cross_validate(all, *folds, options);
  EXPECT_TRUE(scores);
  double sum = 0, runs = 0;
  for (const FoldScores& fold : *scores)
    for (const ModelRun& run : fold.runs) sum += run.scores.sji, ++runs;
  return sum / runs;
}

TEST(OtherSentences, AreWhatIsTestedWhileTrainingHearsTheRecordedOnes) {
  EXPECT_GT(tested_with(false, [](const std::string& word) { return "seize the " + word; }), 0.9);
  EXPECT_LT(tested_with(false,
                        [](const std::string& word) {
                          return word == "mug" ? "take plate" : word == "plate" ? "take kettle" : "take mug";
                        }),
            0.1)
      << "another thing is named than was recorded";
}

TEST(OtherSentences, GroundingTellsObjectsThatTheNewWordsDoNotName) {
  EXPECT_GT(tested_with(true, [](const std::string&) { return "take this thing"; }), 0.9);
  EXPECT_LT(tested_with(false, [](const std::string&) { return "take this thing"; }), 0.6);
}

TEST(GeneralisationTables, NameDemonstrationsAndSayThemInOtherWords) {
  if (!std::filesystem::exists(kShared / "data/goalnet/train"))
    GTEST_SKIP() << "needs ../shared/data/goalnet";
  const auto all = read_demonstrations(kShared / "data/goalnet/train");
  ASSERT_TRUE(all) << all.error().message;
  for (const char* name : {"verbs.tsv", "paraphrased.tsv"}) {
    const auto table = read_other_sentences(kTables / name);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_TRUE(check_other_sentences(*table, *all));
    EXPECT_GT(table->size(), 700u);
    for (const Demonstration& d : *all) {
      if (const auto other = table->find(d.id); other != table->end()) {
        EXPECT_NE(*tokenize(other->second), *tokenize(d.sentence)) << name << " " << d.id;
      }
    }
  }
}

// A small part of the tables, by the shipped model. It has met these scenarios, so that its scores say how
// far other words lead it away from what it remembers, not how good it is.
TEST(GeneralisationTables, ARunWithOtherSentencesIsScoredAsTheIndependentScorerDoes) {
  const auto data = kShared / "data/goalnet/train", script = kShared / "tools/score.py";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "needs ../shared/data/goalnet";
  if (std::system("python3 -c 0") != 0) GTEST_SKIP() << "needs python3";
  const auto all = read_demonstrations(data);
  ASSERT_TRUE(all) << all.error().message;
  const auto table = read_other_sentences(kTables / "verbs.tsv");
  ASSERT_TRUE(table) << table.error().message;
  const auto folder = std::filesystem::temp_directory_path() / ("goalnet_part_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::vector<Demonstration> part;
  for (const Demonstration& d : *all) {
    if (part.size() >= 30 || !table->contains(d.id)) continue;
    std::filesystem::copy_file(data / (d.id + ".json"), folder / (d.id + ".json"));
    part.push_back(with_sentence(d, *table));
  }
  Symbols symbols;
  const auto lexicon = Lexicon::load(config_path("language/household.json"), symbols);
  ASSERT_TRUE(lexicon);
  const auto result =
      evaluate([] { return load_model(config_path("models/goalnet.safetensors"), ModelUse::kBenchmark); },
               part, *lexicon, {.grounding = true, .threads = 1, .progress = {}});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_GT(result->mean.sji, 0.6);
  ASSERT_TRUE(write_runs(result->runs, folder / "runs.jsonl"));
  const std::string command =
      "python3 " + script.string() + " " + folder.string() + " " + (folder / "runs.jsonl").string();
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output(4096, '\0');
  output.resize(std::fread(output.data(), 1, output.size(), pipe));
  EXPECT_EQ(pclose(pipe), 0);
  std::filesystem::remove_all(folder);
  const auto value = [&](const std::string& key) {
    const std::size_t at = output.find("\"" + key + "\":");
    EXPECT_NE(at, std::string::npos) << key << " in " << output;
    return at == std::string::npos ? -1 : std::atof(output.c_str() + at + key.size() + 3);
  };
  EXPECT_EQ(value("missing"), 0);
  EXPECT_NEAR(value("sji"), result->mean.sji, 5.1e-5);
  EXPECT_NEAR(value("ied"), result->mean.ied, 5.1e-5);
  EXPECT_NEAR(value("f1"), result->mean.f1, 5.1e-5);
  EXPECT_NEAR(value("grr"), result->mean.grr, 5.1e-5);
}

}  // namespace
}  // namespace goalnet::inference
