// rosbag2's own compression, laid out as rosbag2 does: whole files by the zstd program, messages one by one.
#include <gmock/gmock-matchers.h>
#include <unistd.h>

#include "components/ros/bag/bag_writer.h"
#include "components/ros/bag/compressed_file.h"
#include "components/ros/bag/compression.h"
#include "tests/unit/ros/bag_support.h"

namespace goalnet::ros {
namespace {

using testing::HasSubstr;

struct CompressedBag : testing::TestWithParam<BagStorage> {
  fs::path folder = fs::path(testing::TempDir()) / ("compressed_bag_test_" + std::to_string(getpid()));
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }

  // 300 messages in several files.
  void record(bool compress_messages) {
    BagWriterOptions options;
    options.directory = folder.string();
    options.storage = GetParam();
    options.split_duration = std::chrono::milliseconds(100);
    auto bag = BagWriter::create(options);
    ASSERT_TRUE(bag) << bag.error().message;
    ASSERT_TRUE((*bag)->add_topic(topic_named("/a")));
    for (int i = 0; i < 300; ++i) {
      const std::uint64_t time = 1'000'000'000u + static_cast<std::uint64_t>(i) * 1'000'000u;
      ASSERT_TRUE((*bag)->write(0, time, time, compress_messages ? compress_zstd(payload(i)) : payload(i)));
    }
    ASSERT_TRUE((*bag)->close());
  }
  std::string metadata() const { return contents(folder / "metadata.yaml"); }
  static void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
      text.replace(at, from.size(), to);
  }
  void declare(const std::string& mode, const std::string& format = "zstd") {
    std::string text = metadata();
    replace_all(text, "compression_format: \"\"", "compression_format: " + format);
    replace_all(text, "compression_mode: \"\"", "compression_mode: " + mode);
    if (mode == "FILE") {
      const std::string extension(bag_file_extension(GetParam()));
      replace_all(text, extension, extension + ".zstd");
    }
    write_file(folder / "metadata.yaml", text);
  }
  int compress_files() {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string path = entry.path().string();
      if (!path.ends_with(bag_file_extension(GetParam()))) continue;
      EXPECT_EQ(std::system(("zstd -q --rm '" + path + "' -o '" + path + ".zstd'").c_str()), 0) << path;
      ++count;
    }
    return count;
  }
  static int temporary_files() {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path()))
      count += entry.path().filename().string().starts_with("goalnet_bag_") ? 1 : 0;
    return count;
  }
  void comes_back() {
    auto bag = BagReader::open(folder.string());
    ASSERT_TRUE(bag) << bag.error().message;
    EXPECT_EQ((*bag)->topics().size(), 1u);
    for (int round = 0; round < 2; ++round) {
      BagMessage message;
      for (int i = 0; i < 300; ++i) {
        const auto more = (*bag)->next(message);
        ASSERT_TRUE(more) << more.error().message;
        ASSERT_TRUE(*more);
        EXPECT_EQ(message.payload, payload(i)) << i;
      }
      EXPECT_FALSE((*bag)->next(message).value());
      ASSERT_TRUE((*bag)->rewind());
    }
  }
};

TEST_P(CompressedBag, WholeFilesAreRead) {
  record(false);
  ASSERT_GT(compress_files(), 1);
  declare("FILE");
  const int before = temporary_files();
  comes_back();
  EXPECT_EQ(temporary_files(), before) << "nothing is left behind";
}

TEST_P(CompressedBag, MessagesAreRead) {
  record(true);
  declare("MESSAGE");
  comes_back();
}

TEST_P(CompressedBag, WhatIsBrokenOrUnknownIsRefused) {
  record(false);
  declare("FILE", "lz4");
  EXPECT_THAT(BagReader::open(folder.string()).error().message,
              HasSubstr("compression_format \"lz4\" is not read"));
  std::string text = metadata();
  replace_all(text, "compression_format: lz4", "compression_format: zstd");
  write_file(folder / "metadata.yaml", text);
  EXPECT_FALSE(BagReader::open(folder.string())) << "the compressed files are not there";
  ASSERT_GT(compress_files(), 1);
  ASSERT_TRUE(BagReader::open(folder.string()));
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".zstd") continue;
    fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  }
  const auto cut = BagReader::open(folder.string());
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(cut.error().message, HasSubstr("cut short"));
}

TEST_P(CompressedBag, MessagesThatAreNotCompressedAreRefused) {
  record(false);
  declare("MESSAGE");
  auto bag = BagReader::open(folder.string());
  ASSERT_TRUE(bag) << bag.error().message;
  BagMessage message;
  const auto more = (*bag)->next(message);
  ASSERT_FALSE(more);
  EXPECT_THAT(more.error().message, HasSubstr("a message of /a: it is not compressed with zstd"));
}

TEST(CompressedFile, GrowsNoFurtherThanAllowed) {
  const std::string path = testing::TempDir() + "/bomb.zstd";
  const auto compressed = compress_zstd(std::vector<std::uint8_t>(10'000'000, 0));
  write_file(path, std::string(compressed.begin(), compressed.end()));
  EXPECT_TRUE(decompress_file(path, ".mcap", 10'000'000));
  const auto bomb = decompress_file(path, ".mcap", 5 << 20);
  ASSERT_FALSE(bomb);
  EXPECT_THAT(bomb.error().message, HasSubstr("decompresses to more than 5 MB"));
  fs::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Storages, CompressedBag, testing::Values(BagStorage::kMcap, BagStorage::kSqlite),
                         [](const auto& chosen) { return std::string(to_string(chosen.param)); });

}  // namespace
}  // namespace goalnet::ros
