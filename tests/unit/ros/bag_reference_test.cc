// Against bags that `ros2 bag record` made (../shared/data/ros2; skipped where that is absent).
#include <sqlite3.h>
#include <unistd.h>

#include "components/ros/bag/bag_writer.h"
#include "tests/unit/ros/bag_support.h"

namespace goalnet::ros {
namespace {

const std::string kReference = GOALNET_SOURCE_DIR "/../shared/data/ros2/";

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
  if (distro() == Distro::kJazzy) ours = replaced(ours, "ros_distro: jazzy", "ros_distro: \"\"");
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

}  // namespace
}  // namespace goalnet::ros
