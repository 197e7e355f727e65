// Bags as files, without DDS: what is written is what others write, and whatever lies on the disk is read or
// refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "components/ros/bag/bag_reader.h"
#include "components/ros/bag/bag_repair.h"
#include "components/ros/bag/bag_writer.h"
#include "components/ros/bag/offered_qos.h"

namespace goalnet::ros {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kReference = GOALNET_SOURCE_DIR "/../shared/data/ros2/";

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// All rows of a query, columns joined by "|".
std::vector<std::string> query(const fs::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(("file:" + path.string() + "?immutable=1").c_str(), &database,
                            SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr),
            SQLITE_OK);
  std::vector<std::string> rows;
  const auto take = [](void* out, int count, char** values, char**) {
    std::string row;
    for (int i = 0; i < count; ++i)
      row += (i > 0 ? "|" : "") + std::string(values[i] != nullptr ? values[i] : "NULL");
    static_cast<std::vector<std::string>*>(out)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), take, &rows, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
  sqlite3_close(database);
  return rows;
}

BagTopic topic_named(const std::string& name) {
  BagTopic topic;
  topic.name = name;
  topic.type = "std_msgs/msg/String";
  topic.type_hash = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18";
  topic.offered = {{.qos = Qos::latched(), .history_known = true}};
  topic.definition = "string data\n";
  return topic;
}

std::vector<std::uint8_t> payload(int number) {
  const std::string text = "message " + std::to_string(number);
  std::vector<std::uint8_t> bytes(8 + text.size() + 1);
  bytes[1] = 1;  // little endian
  bytes[4] = static_cast<std::uint8_t>(text.size() + 1);
  std::copy(text.begin(), text.end(), bytes.begin() + 8);
  return bytes;
}

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

// Messages of a bag, or of what can be read before an error, which ends up in `error`.
std::vector<BagMessage> read_all(BagReader& bag, std::string& error) {
  std::vector<BagMessage> messages;
  BagMessage message;
  for (;;) {
    const auto more = bag.next(message);
    if (!more) error = more.error().message;
    if (!more || !*more) return messages;
    messages.push_back(message);
  }
}

std::vector<BagMessage> read_all(const std::string& path) {
  auto bag = BagReader::open(path);
  EXPECT_TRUE(bag) << bag.error().message;
  if (!bag) return {};
  std::string error;
  auto messages = read_all(**bag, error);
  EXPECT_EQ(error, "");
  return messages;
}

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

// ---- against bags that ros2 bag record made ----

struct ReferenceBag : testing::TestWithParam<const char*> {
  std::string directory() const { return kReference + "bag_" + GetParam() + "_sqlite"; }
  Distro distro() const { return GetParam() == std::string("humble") ? Distro::kHumble : Distro::kJazzy; }
  void SetUp() override {
    if (!fs::exists(kReference))
      GTEST_SKIP() << "../shared is absent: no bags of ros2 bag record to compare with";
  }
};

TEST_P(ReferenceBag, MetadataIsWrittenByteForByteAsRosbag2Does) {
  const std::string theirs = contents(directory() + "/metadata.yaml");
  const auto metadata = parse_bag_metadata(theirs);
  ASSERT_TRUE(metadata) << metadata.error().message;
  std::string ours = bag_metadata_yaml(*metadata, distro());
  // They were recorded where ROS_DISTRO was not set.
  ours = std::regex_replace(ours, std::regex("ros_distro: jazzy$"), "ros_distro: \"\"");
  EXPECT_EQ(ours, theirs);
}

TEST_P(ReferenceBag, IsReadWhole) {
  auto bag = BagReader::open(directory());
  ASSERT_TRUE(bag) << bag.error().message;
  std::string error;
  const auto messages = read_all(**bag, error);
  EXPECT_EQ(error, "");
  const auto metadata = read_bag_metadata(directory());
  EXPECT_EQ(messages.size(), metadata->message_count());
  EXPECT_EQ(messages.front().log_time, metadata->start());
  std::map<std::string, std::uint64_t> counts;
  for (const BagMessage& message : messages) {
    ++counts[(*bag)->topics()[message.topic].name];
    EXPECT_EQ(message.payload[1], 1) << "little-endian CDR";
  }
  for (const BagTopic& topic : metadata->topics)
    EXPECT_EQ(counts[topic.name], topic.message_count) << topic.name;
  EXPECT_TRUE((*bag)->topics()[0].offered.front().qos.transient_local) << "/rosout is latched";
  EXPECT_EQ((*bag)->topics()[0].offered.front().qos.lifespan, std::chrono::seconds(10));
}

TEST_P(ReferenceBag, HasTheTablesThatWeMake) {
  fs::path theirs;
  for (const auto& entry : fs::directory_iterator(directory())) {
    if (entry.path().extension() == ".db3") theirs = entry.path();
  }
  const fs::path folder = fs::path(testing::TempDir()) / ("reference_bag_" + std::to_string(getpid()));
  fs::remove_all(folder);
  BagWriterOptions options;
  options.directory = folder.string();
  options.storage = BagStorage::kSqlite;
  options.file.distro = distro();
  auto reader = BagReader::open(directory());
  ASSERT_TRUE(reader);
  {
    auto bag = BagWriter::create(options);
    ASSERT_TRUE(bag);
    for (const BagTopic& topic : (*reader)->topics()) ASSERT_TRUE((*bag)->add_topic(topic));
    BagMessage message;
    for (;;) {
      const auto more = (*reader)->next(message);
      ASSERT_TRUE(more);
      if (!*more) break;
      ASSERT_TRUE((*bag)->write(message.topic, message.log_time, message.publish_time, message.payload));
    }
  }
  const fs::path ours = folder / (folder.filename().string() + "_0.db3");
  EXPECT_EQ(query(ours, "SELECT type,name,tbl_name,sql FROM sqlite_master ORDER BY rootpage"),
            query(theirs, "SELECT type,name,tbl_name,sql FROM sqlite_master ORDER BY rootpage"));
  for (const std::string sql : {"SELECT schema_version FROM schema", "SELECT * FROM topics ORDER BY id",
                                "SELECT id,metadata_version FROM metadata",
                                "SELECT id,topic_id,timestamp,hex(data) FROM messages ORDER BY id",
                                "PRAGMA encoding", "PRAGMA page_size"}) {
    EXPECT_EQ(query(ours, sql), query(theirs, sql)) << sql;
  }
  if (distro() == Distro::kJazzy) {
    EXPECT_EQ(query(ours, "SELECT * FROM message_definitions ORDER BY id"),
              query(theirs, "SELECT * FROM message_definitions ORDER BY id"));
  }
  EXPECT_EQ(contents(ours).substr(18, 2), contents(theirs).substr(18, 2)) << "not left in write-ahead mode";
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Distributions, ReferenceBag, testing::Values("humble", "jazzy"),
                         [](const auto& one) { return std::string(one.param); });

// ---- quality of service ----

TEST(OfferedQosTest, RequestsWhatAllPublishersOffer) {
  const OfferedQos reliable{.qos = Qos::standard()}, latched{.qos = Qos::latched()},
      sensor{.qos = Qos::sensor_data()};
  const auto request = [](std::vector<OfferedQos> offered) { return request_for(offered); };
  EXPECT_TRUE(request({latched, latched}).transient_local);
  EXPECT_FALSE(request({latched, reliable}).transient_local);
  EXPECT_TRUE(request({latched, reliable}).reliable);
  EXPECT_FALSE(request({reliable, sensor}).reliable);
  EXPECT_FALSE(request({}).transient_local);
}

TEST(OfferedQosTest, OffersWhatWasRecordedWherePublishersAgreed) {
  const OfferedQos latched{.qos = Qos::latched(), .history_known = true},
      unknown{.qos = Qos::latched().keep_last(0)};
  const OfferedQos sensor{.qos = Qos::sensor_data()};
  EXPECT_EQ(offer_in_place_of(std::vector{latched}), Qos::latched());
  EXPECT_EQ(offer_in_place_of(std::vector{unknown}), Qos::latched().keep_last(10))
      << "history does not travel";
  EXPECT_EQ(offer_in_place_of(std::vector{latched, sensor}), Qos::standard())
      << "mixed: the default, as rosbag2";
}

TEST(OfferedQosTest, ReadsWordsAndNumbersAndRefusesTheRest) {
  for (const Distro distro : {Distro::kHumble, Distro::kJazzy}) {
    const std::vector<OfferedQos> offered{{.qos = Qos::rosout(), .history_known = true},
                                          {.qos = Qos::sensor_data().keep_last(0)}};
    const auto read = parse_offered_qos(offered_qos_yaml(offered, distro));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, offered);
  }
  EXPECT_TRUE(parse_offered_qos("")->empty());
  for (const char* bad : {"- history: 99", "{}", "- 1", "[", "- history: keep_last\n  depth: -1"})
    EXPECT_FALSE(parse_offered_qos(bad)) << bad;
}

// ---- metadata of strangers ----

TEST(BagMetadataTest, RefusesWhatItCannotTrust) {
  BagMetadata metadata;
  metadata.files.push_back({"a_0.mcap", 5, 6, 7});
  metadata.topics.push_back(topic_named("/odd: \"name\"\n"));
  const std::string good = bag_metadata_yaml(metadata, Distro::kJazzy);
  const auto read = parse_bag_metadata(good);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->topics[0].name, metadata.topics[0].name) << "no name breaks the file";
  const auto refused = [&](const std::string& what, const std::string& with) {
    std::string bad = good;
    bad = std::regex_replace(bad, std::regex(what), with);
    EXPECT_NE(bad, good);
    EXPECT_FALSE(parse_bag_metadata(bad)) << bad;
  };
  refused("version: 9", "version: 10");
  refused("storage_identifier: mcap", "storage_identifier: floppy");
  refused("path: a_0.mcap", "path: ../../etc/passwd");
  refused("path: a_0.mcap", "path: /etc/passwd");
  refused("history: keep_last", "history: keep_some");
  refused("rosbag2_bagfile_information", "something_else");
  refused("message_count: 7", "message_count: -7");
  EXPECT_FALSE(parse_bag_metadata(std::string(100'000, '[')));
  EXPECT_FALSE(parse_bag_metadata(""));
}

TEST(BagReaderTest, SaysWhatIsWrong) {
  const auto message = [](const std::string& path) {
    const auto bag = BagReader::open(path);
    return bag ? std::string("opened") : bag.error().message;
  };
  EXPECT_THAT(message("/nowhere/bag"), HasSubstr("does not exist"));
  EXPECT_THAT(message(testing::TempDir()), HasSubstr("no metadata.yaml"));
  EXPECT_THAT(message(GOALNET_SOURCE_DIR "/LICENSE"), HasSubstr("is no bag"));
  const std::string odd = testing::TempDir() + "/odd_" + std::to_string(getpid());
  write_file(odd + ".mcap", "hello");
  EXPECT_THAT(message(odd + ".mcap"), HasSubstr("is no MCAP file"));
  write_file(odd + ".db3", std::string(5000, 'x'));
  EXPECT_THAT(message(odd + ".db3"), HasSubstr("is no bag"));
  fs::remove(odd + ".mcap");
  fs::remove(odd + ".db3");
}

}  // namespace
}  // namespace goalnet::ros
