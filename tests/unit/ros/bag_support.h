// What the tests of bag files share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "components/ros/bag/bag_reader.h"

namespace goalnet::ros {

namespace fs = std::filesystem;

inline std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline BagTopic topic_named(const std::string& name) {
  BagTopic topic;
  topic.name = name;
  topic.type = "std_msgs/msg/String";
  topic.type_hash = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18";
  topic.offered = {{.qos = Qos::latched(), .history_known = true}};
  topic.definition = "string data\n";
  return topic;
}

inline std::vector<std::uint8_t> payload(int number) {
  const std::string text = "message " + std::to_string(number);
  std::vector<std::uint8_t> bytes(8 + text.size() + 1);
  bytes[1] = 1;  // little endian
  bytes[4] = static_cast<std::uint8_t>(text.size() + 1);
  std::copy(text.begin(), text.end(), bytes.begin() + 8);
  return bytes;
}

// Messages of a bag, or of what can be read before an error, which ends up in `error`.
inline std::vector<BagMessage> read_all(BagReader& bag, std::string& error) {
  std::vector<BagMessage> messages;
  BagMessage message;
  for (;;) {
    const auto more = bag.next(message);
    if (!more) error = more.error().message;
    if (!more || !*more) return messages;
    messages.push_back(message);
  }
}

inline std::vector<BagMessage> read_all(const std::string& path) {
  auto bag = BagReader::open(path);
  EXPECT_TRUE(bag) << bag.error().message;
  if (!bag) return {};
  std::string error;
  auto messages = read_all(**bag, error);
  EXPECT_EQ(error, "");
  return messages;
}

// `text` with the first `what` replaced; must be there.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  if (at != std::string::npos) text.replace(at, what.size(), with);
  return text;
}

}  // namespace goalnet::ros
