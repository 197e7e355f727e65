// Quality of service and metadata of bags, and what is said about paths that are none.
#include <gmock/gmock-matchers.h>
#include <unistd.h>

#include "components/ros/bag/offered_qos.h"
#include "tests/unit/ros/bag_support.h"

namespace goalnet::ros {
namespace {

using testing::HasSubstr;

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

TEST(BagMetadataTest, RefusesWhatItCannotTrust) {
  BagMetadata metadata;
  metadata.files.push_back({"a_0.mcap", 5, 6, 7});
  metadata.topics.push_back(topic_named("/odd: \"name\"\n"));
  metadata.compression_format = ":\"\"";
  const std::string good = bag_metadata_yaml(metadata, Distro::kJazzy);
  const auto read = parse_bag_metadata(good);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->topics[0].name, metadata.topics[0].name) << "no name breaks the file";
  EXPECT_EQ(read->compression_format, metadata.compression_format);
  const auto refused = [&](const std::string& what, const std::string& with) {
    const std::string bad = replaced(good, what, with);
    EXPECT_FALSE(parse_bag_metadata(bad)) << bad;
  };
  refused("version: 9", "version: 10");
  refused("storage_identifier: mcap", "storage_identifier: floppy");
  refused("path: a_0.mcap", "path: ../../etc/passwd");
  refused("path: a_0.mcap", "path: /etc/passwd");
  refused("history: keep_last", "history: keep_some");
  refused("rosbag2_bagfile_information", "something_else");
  refused("      message_count: 7", "      message_count: -7");
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
