// Our types and decoders against what real ROS 2 nodes sent (../shared/data/ros2; skipped where that is
// absent).
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "components/ros/detail/graph.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/type_messages.h"
#include "idl/type_support.h"

namespace goalnet::ros {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::filesystem::path data_folder() {
  return std::filesystem::path(GOALNET_SOURCE_DIR) / ".." / "shared" / "data" / "ros2";
}

Bytes from_hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

// Equal wherever `mask` is not zero; what trails in `reference` beyond `ours` must be padding.
testing::AssertionResult equal_under(const Bytes& mask, const Bytes& ours, const Bytes& reference) {
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const bool counts = i < mask.size() && mask[i] != 0;
    if (counts && (i >= ours.size() || ours[i] != reference[i])) {
      return testing::AssertionFailure() << "differs at byte " << i << " of " << reference.size();
    }
  }
  return testing::AssertionSuccess();
}

// Decodes and encodes again.
Bytes round_trip(const idl::TypeSupport& support, const Bytes& payload, const char** fault) {
  const std::shared_ptr<void> message(support.create(), support.destroy);
  *fault = detail::decode(support, detail::layout_of(support), payload, message.get());
  return *fault == nullptr ? detail::encode(support, message.get()) : Bytes();
}

struct Reference : testing::Test {
  void SetUp() override {
    if (!std::filesystem::exists(data_folder())) GTEST_SKIP() << "no reference data at " << data_folder();
  }
  static nlohmann::json load(const std::string& name) {
    std::ifstream file(data_folder() / name);
    return nlohmann::json::parse(file);
  }
};

TEST(TypeHash, PublishedValue) {
  const auto* type = idl::find_type("std_msgs/msg/String");
  ASSERT_NE(type, nullptr);
  EXPECT_STREQ(type->hash, "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
}

TEST(TypeHash, EveryMessageHasSupportUnderItsOwnName) {
  int messages = 0;
  for (const auto& type : idl::all_types()) {
    const auto* support = idl::find_type_support(type.name);
    if (support == nullptr) continue;  // services, actions and events as a whole are never sent
    ++messages;
    EXPECT_EQ(support->description, &type);
    EXPECT_EQ(idl::dds_type_name(type.name), support->dds_name);
    EXPECT_EQ(idl::ros_type_name(support->dds_name), type.name);
  }
  EXPECT_GT(messages, 100);
}

TEST_F(Reference, TypeHashesEqualJazzys) {
  const auto hashes = load("type_hashes_jazzy.json");
  int compared = 0;
  for (const auto& type : idl::all_types()) {
    if (!hashes.contains(type.name)) continue;
    EXPECT_EQ(hashes[type.name], type.hash) << type.name;
    ++compared;
  }
  EXPECT_GE(compared, 151);
}

// What ~/get_type_description answers, hashed as REP-2011 says, gives the type's hash: nothing is missing in
// it.
std::string hash_of(const type_description_interfaces::msg::TypeDescription& message) {
  const auto individual = [](const type_description_interfaces::msg::IndividualTypeDescription& type) {
    std::string text = "{\"type_name\": \"" + type.type_name().to_string() + "\", \"fields\": [";
    for (const auto& field : type.fields()) {
      if (text.back() != '[') text += ", ";
      text += "{\"name\": \"" + field.name() +
              "\", \"type\": {\"type_id\": " + std::to_string(field.type().type_id()) +
              ", \"capacity\": " + std::to_string(field.type().capacity()) +
              ", \"string_capacity\": " + std::to_string(field.type().string_capacity()) +
              ", \"nested_type_name\": \"" + field.type().nested_type_name().to_string() + "\"}}";
    }
    return text + "]}";
  };
  std::string text = "{\"type_description\": " + individual(message.type_description()) +
                     ", \"referenced_type_descriptions\": [";
  for (const auto& part : message.referenced_type_descriptions()) {
    if (text.back() != '[') text += ", ";
    text += individual(part);
  }
  text += "]}";
  unsigned char digest[32];
  EVP_Digest(text.data(), text.size(), digest, nullptr, EVP_sha256(), nullptr);
  std::string hash = "RIHS01_";
  for (const unsigned char byte : digest) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    hash += digits;
  }
  return hash;
}

TEST(TypeHash, FollowsFromWhatGetTypeDescriptionAnswers) {
  int compared = 0;
  for (const auto& type : idl::all_types()) {
    type_description_interfaces::srv::GetTypeDescription_Request request;
    type_description_interfaces::srv::GetTypeDescription_Response response;
    request.type_name(type.name);
    request.type_hash(type.hash);
    request.include_type_sources(true);
    describe_type(request, response);
    ASSERT_TRUE(response.successful()) << response.failure_reason();
    EXPECT_EQ(hash_of(response.type_description()), type.hash) << type.name;
    EXPECT_EQ(response.type_sources().size(),
              1 + response.type_description().referenced_type_descriptions().size());
    ++compared;
  }
  EXPECT_GE(compared, 151);
}

// Jazzy's generated descriptions hold default values as Python prints them.
TEST(TypeDescriptions, CarryDefaultValues) {
  const auto default_of = [](const char* name, const std::string& field) -> std::string {
    const auto described = to_message(*idl::find_type(name));
    for (const auto& one : described.type_description().fields()) {
      if (one.name() == field) return one.default_value();
    }
    return "no such field";
  };
  EXPECT_EQ(default_of("geometry_msgs/msg/Quaternion", "x"), "0.0");
  EXPECT_EQ(default_of("geometry_msgs/msg/Quaternion", "w"), "1.0");
  EXPECT_EQ(default_of("rcl_interfaces/msg/ParameterDescriptor", "read_only"), "False");
  EXPECT_EQ(default_of("type_description_interfaces/srv/GetTypeDescription_Request", "include_type_sources"),
            "True");
  EXPECT_EQ(default_of("type_description_interfaces/msg/FieldType", "type_id"), "0");
  EXPECT_EQ(default_of("std_msgs/msg/String", "data"), "");
}

TEST_F(Reference, CdrEqualsThatOfBothDistributions) {
  for (const char* file : {"cdr_vectors_humble_fastrtps.json", "cdr_vectors_jazzy_cyclonedds.json"}) {
    int compared = 0;
    const auto vectors = load(file);
    for (const auto& [name, vector] : vectors.items()) {
      const auto* support = idl::find_type_support(name);
      if (support == nullptr) continue;
      // Humble's Gid has 24 bytes: detail/graph.h handles both.
      if (std::string(file).find("humble") != std::string::npos && name.starts_with("rmw_dds_common"))
        continue;
      const Bytes filled = from_hex(vector["filled_cdr"]);
      Bytes mask = from_hex(vector["filled_mask"]);
      mask.insert(mask.begin(), {0xff, 0xff, 0, 0});  // the mask covers the body only
      const char* fault = nullptr;
      const Bytes again = round_trip(*support, filled, &fault);
      ASSERT_EQ(fault, nullptr) << file << " " << name << ": " << fault;
      EXPECT_TRUE(equal_under(mask, again, filled)) << file << " " << name;
      round_trip(*support, from_hex(vector["default_cdr"]), &fault);
      EXPECT_EQ(fault, nullptr) << file << " " << name << " (defaults)";
      ++compared;
    }
    EXPECT_GT(compared, 35) << file;
  }
}

// Every capture of a type we have decodes and encodes to the same bytes.
TEST_F(Reference, CapturedSamplesRoundTrip) {
  for (const std::string distro : {"hf", "jc"}) {
    int compared = 0;
    const auto samples = load(distro + "_samples.json");
    for (const auto& sample : samples) {
      const std::string topic = sample["topic"];
      const auto* support = idl::find_type_support(idl::ros_type_name(sample["type"].get<std::string>()));
      if (support == nullptr || topic == "ros_discovery_info") continue;
      Bytes payload = from_hex(sample["payload"]);
      const bool service = topic.starts_with("rq/") || topic.starts_with("rr/");
      if (distro == "jc" && service)
        payload.erase(payload.begin() + 4, payload.begin() + 20);  // Cyclone's header
      const char* fault = nullptr;
      const Bytes again = round_trip(*support, payload, &fault);
      ASSERT_EQ(fault, nullptr) << distro << " " << topic << ": " << fault;
      EXPECT_TRUE(equal_under(detail::layout_of(*support).data_mask(payload), again, payload))
          << distro << " " << topic;
      ++compared;
    }
    EXPECT_GT(compared, 80) << distro;
  }
}

// The same nodes in our Graph encode to the very bytes that the real participants sent.
TEST_F(Reference, RosDiscoveryInfoIsByteEqualInBothLayouts) {
  const std::pair<std::string, Distro> kinds[] = {{"hf", Distro::kHumble}, {"jc", Distro::kJazzy}};
  for (const auto& [prefix, distro] : kinds) {
    int compared = 0;
    std::set<std::string> names;
    const auto samples = load(prefix + "_samples.json");
    for (const auto& sample : samples) {
      if (sample["topic"] != "ros_discovery_info") continue;
      const Bytes payload = from_hex(sample["payload"]);
      const auto message = detail::decode_graph(payload, distro);
      ASSERT_TRUE(message) << message.error().message;
      detail::Graph graph(message->participant);
      for (const auto& node : message->nodes) {
        names.insert(node.name);
        graph.add_node(node.node_namespace, node.name);
        const std::string full = (node.node_namespace == "/" ? "" : node.node_namespace) + "/" + node.name;
        for (const auto& gid : node.readers) EXPECT_TRUE(graph.add(full, gid, false));
        for (const auto& gid : node.writers) EXPECT_TRUE(graph.add(full, gid, true));
      }
      // Padding is uninitialised memory in real payloads; all else must be equal, and as long.
      const Bytes ours = graph.encode(distro, 0);
      const Bytes other_padding = graph.encode(distro, 0xff);
      Bytes mask(ours.size());
      for (std::size_t i = 0; i < ours.size(); ++i) mask[i] = ours[i] == other_padding[i] ? 0xff : 0;
      EXPECT_TRUE(equal_under(mask, ours, payload));
      EXPECT_LE(payload.size() - ours.size(), 3u) << "rmw rounds payloads up to four bytes";
      ++compared;
      // Each prefix of a real message must be refused, not read beyond.
      for (std::size_t size = 0; size < ours.size(); ++size) {
        EXPECT_FALSE(detail::decode_graph(std::span(payload).first(size), distro)) << size;
      }
    }
    EXPECT_GT(compared, 20) << prefix;
    EXPECT_TRUE(names.contains("golden_node")) << prefix;
  }
}

}  // namespace
}  // namespace goalnet::ros
