// Bags as files, without DDS: what was written comes back, also from what a killed recorder left.
#include <gmock/gmock-matchers.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "components/ros/bag/bag_repair.h"
#include "components/ros/bag/bag_writer.h"
#include "tests/unit/ros/bag_support.h"

namespace goalnet::ros {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Kind {
  BagStorage storage;
  Distro distro;
  bool compress = false;
};

struct BagFolder : testing::Test {
  fs::path folder = fs::path(testing::TempDir()) / ("bag_file_test_" + std::to_string(getpid()));
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }

  BagWriterOptions options(Kind kind) const {
    BagWriterOptions out;
    out.directory = folder.string();
    out.storage = kind.storage;
    out.file = {kind.distro, kind.compress};
    return out;
  }
  // 2 topics, `count` messages of each, 1 ms apart.
  void fill(BagWriter& bag, int count) {
    for (const char* name : {"/a", "/b"}) ASSERT_TRUE(bag.add_topic(topic_named(name)));
    for (int i = 0; i < count; ++i) {
      for (std::size_t topic : {0u, 1u}) {
        const auto time = 1'000'000'000u + static_cast<std::uint64_t>(i) * 1'000'000u + topic;
        const auto written = bag.write(topic, time, time - 7, payload(i));
        ASSERT_TRUE(written) << written.error().message;
      }
    }
  }
  void record(Kind kind, int count = 1000) {
    auto bag = BagWriter::create(options(kind));
    ASSERT_TRUE(bag) << bag.error().message;
    fill(**bag, count);
    const auto closed = (*bag)->close();
    ASSERT_TRUE(closed) << closed.error().message;
  }
  fs::path file(Kind kind, int number = 0) const {
    return folder / (folder.filename().string() + "_" + std::to_string(number) +
                     std::string(bag_file_extension(kind.storage)));
  }
};

struct BagFileTest : BagFolder, testing::WithParamInterface<Kind> {};
struct UnfinishedMcap : BagFolder {};

TEST_P(BagFileTest, ComesBackInOrderWithAllThatIsKnown) {
  record(GetParam());
  auto bag = BagReader::open(folder.string());
  ASSERT_TRUE(bag) << bag.error().message;
  EXPECT_TRUE((*bag)->finished());
  ASSERT_EQ((*bag)->topics().size(), 2u);
  EXPECT_EQ((*bag)->topics()[1].name, "/b");
  EXPECT_EQ((*bag)->topics()[1].type, "std_msgs/msg/String");
  ASSERT_EQ((*bag)->topics()[1].offered.size(), 1u);
  EXPECT_EQ((*bag)->topics()[1].offered[0], topic_named("").offered[0]);
  if (GetParam().distro == Distro::kJazzy) {
    EXPECT_EQ((*bag)->topics()[1].type_hash, topic_named("").type_hash);
    EXPECT_EQ((*bag)->topics()[1].definition, "string data\n");
  }
  std::string error;
  for (int round = 0; round < 2; ++round) {
    const auto messages = read_all(**bag, error);
    ASSERT_EQ(error, "");
    ASSERT_EQ(messages.size(), 2000u);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      ASSERT_EQ(messages[i].topic, i % 2);
      ASSERT_EQ(messages[i].log_time, 1'000'000'000u + i / 2 * 1'000'000u + i % 2);
      ASSERT_EQ(messages[i].payload, payload(static_cast<int>(i / 2)));
      if (GetParam().storage == BagStorage::kMcap) {
        ASSERT_EQ(messages[i].publish_time, messages[i].log_time - 7);
      }
    }
    ASSERT_TRUE((*bag)->rewind());
  }
  const auto metadata = read_bag_metadata(folder.string());
  ASSERT_TRUE(metadata) << metadata.error().message;
  EXPECT_EQ(metadata->message_count(), 2000u);
  EXPECT_EQ(metadata->start(), 1'000'000'000u);
  EXPECT_EQ(metadata->duration(), 999'000'001u);
  EXPECT_EQ(metadata->topics[0].message_count, 1000u);
}

TEST_P(BagFileTest, SplitsBySizeAndByTime) {
  for (const bool by_size : {true, false}) {
    fs::remove_all(folder);
    BagWriterOptions split = options(GetParam());
    if (by_size) split.split_bytes = 100'000;
    if (!by_size) split.split_duration = std::chrono::milliseconds(300);
    auto bag = BagWriter::create(split);
    ASSERT_TRUE(bag);
    fill(**bag, 1000);
    ASSERT_TRUE((*bag)->close());
    const auto metadata = read_bag_metadata(folder.string());
    ASSERT_TRUE(metadata);
    if (!by_size) {
      ASSERT_EQ(metadata->files.size(), 4u);
      EXPECT_EQ(metadata->files[1].start, 1'300'000'000u);
      EXPECT_EQ(metadata->files[1].message_count, 600u);
    }
    EXPECT_GT(metadata->files.size(), 1u);
    EXPECT_EQ(metadata->message_count(), 2000u);
    EXPECT_EQ(read_all(folder.string()).size(), 2000u);
  }
}

// The process dies by SIGKILL right after a flush and some more messages: what was flushed is there at once,
// and whole after a repair.
TEST_P(BagFileTest, SurvivesTheDeathOfItsRecorder) {
  const pid_t child = fork();
  if (child == 0) {
    auto bag = BagWriter::create(options(GetParam()));
    if (!bag) _exit(1);
    for (const char* name : {"/a", "/b"}) static_cast<void>((*bag)->add_topic(topic_named(name)));
    for (int i = 0; i < 1000; ++i)
      static_cast<void>(
          (*bag)->write(static_cast<std::size_t>(i % 2), 1000u + static_cast<unsigned>(i), 0, payload(i)));
    if (!(*bag)->flush()) _exit(1);
    for (int i = 0; i < 10; ++i) static_cast<void>((*bag)->write(0, 5000u, 0, payload(i)));
    ::kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << "the recorder could not record";
  const auto early = read_bag_metadata(folder.string());
  ASSERT_TRUE(early) << early.error().message;
  EXPECT_EQ(early->message_count(), 1000u) << "metadata.yaml is as old as the last flush";
  {
    auto bag = BagReader::open(folder.string());
    ASSERT_TRUE(bag) << bag.error().message;
    EXPECT_FALSE((*bag)->finished());
    std::string error;
    EXPECT_EQ(read_all(**bag, error).size(), 1000u) << "readable as it lies";
    EXPECT_EQ(error, "");
  }
  fs::remove(folder / "metadata.yaml");
  const auto repaired = repair_bag(folder.string(), GetParam().distro);
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_EQ(repaired->message_count(), 1000u);
  auto bag = BagReader::open(folder.string());
  ASSERT_TRUE(bag) << bag.error().message;
  EXPECT_TRUE((*bag)->finished());
  std::string error;
  const auto messages = read_all(**bag, error);
  EXPECT_EQ(messages.size(), 1000u);
  EXPECT_EQ(messages.back().payload, payload(999));
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_THAT(names, ElementsAre(file(GetParam()).filename().string(), "metadata.yaml")) << "no leftovers";
}

TEST_P(BagFileTest, IsNotRepairedWhileItIsRecorded) {
  auto bag = BagWriter::create(options(GetParam()));
  ASSERT_TRUE(bag);
  fill(**bag, 10);
  const auto repaired = repair_bag(folder.string(), GetParam().distro);
  ASSERT_FALSE(repaired);
  EXPECT_THAT(repaired.error().message, HasSubstr("still being recorded"));
  ASSERT_TRUE((*bag)->close());
  EXPECT_EQ(read_all(folder.string()).size(), 20u) << "and no harm was done";
}

TEST_P(BagFileTest, IsNeverOverwritten) {
  record(GetParam(), 1);
  const auto again = BagWriter::create(options(GetParam()));
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("exists already"));
}

// Cut off anywhere: what comes before is read, or there is one message that names the file.
TEST_P(BagFileTest, IsReadOrRefusedWhereverItIsCutOff) {
  record(GetParam(), 50);
  const std::string whole = contents(file(GetParam()));
  std::size_t refused = 0, most = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
    write_file(file(GetParam()), whole.substr(0, size));
    auto bag = BagReader::open(folder.string());
    std::string error;
    if (!bag) {
      error = bag.error().message;
    } else {
      most = std::max(most, read_all(**bag, error).size());
    }
    if (error.empty()) continue;
    ++refused;
    EXPECT_THAT(error, HasSubstr(file(GetParam()).filename().string())) << "cut at " << size;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_GT(refused, 0u);
  if (GetParam().storage == BagStorage::kMcap) {
    EXPECT_EQ(most, 100u) << "without its summary everything is there";
  }
}

TEST_P(BagFileTest, SurvivesDamage) {
  record(GetParam(), 50);
  const std::string whole = contents(file(GetParam()));
  // A few places here; the fuzzers do this thoroughly.
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 50) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] == '\xff' ? 0 : '\xff');
    write_file(file(GetParam()), damaged);
    auto bag = BagReader::open(folder.string());
    std::string error;
    if (!bag) continue;
    EXPECT_LE(read_all(**bag, error).size(), 200u);
  }
}

TEST_F(UnfinishedMcap, IsKeptUpToTheFirstDamage) {
  const Kind kind{BagStorage::kMcap, Distro::kJazzy};
  auto bag = BagWriter::create(options(kind));
  ASSERT_TRUE(bag);
  fill(**bag, 10);
  ASSERT_TRUE((*bag)->flush());
  const std::size_t first = contents(file(kind)).size();
  ASSERT_TRUE((*bag)->write(0, 2'000'000'000u, 0, payload(99)));
  ASSERT_TRUE((*bag)->flush());
  std::string cut = contents(file(kind));  // as a killed process leaves it
  ASSERT_TRUE((*bag)->close());
  cut[first + 70] ^= 1;
  write_file(file(kind), cut);
  EXPECT_EQ(read_all(folder.string()).size(), 20u);
  const auto repaired = repair_bag(folder.string(), kind.distro);
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_EQ(repaired->message_count(), 20u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BagFileTest,
                         testing::Values(Kind{BagStorage::kMcap, Distro::kJazzy},
                                         Kind{BagStorage::kMcap, Distro::kHumble},
                                         Kind{BagStorage::kMcap, Distro::kJazzy, true},
                                         Kind{BagStorage::kSqlite, Distro::kJazzy},
                                         Kind{BagStorage::kSqlite, Distro::kHumble}),
                         [](const auto& one) {
                           return std::string(to_string(one.param.storage)) +
                                  (one.param.distro == Distro::kJazzy ? "_jazzy" : "_humble") +
                                  (one.param.compress ? "_zstd" : "");
                         });

}  // namespace
}  // namespace goalnet::ros
