// The check that stands before every decoder: right on good payloads, never wrong on any bytes.
#include "idl/cdr_check.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "components/ros/detail/message_type.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "idl/type_support.h"
#include "rcl_interfaces/msg/ParameterDescriptor.h"
#include "std_msgs/msg/String.h"

namespace goalnet::idl {
namespace {

using Bytes = std::vector<std::uint8_t>;

bool utf8(const std::string& text) {
  return is_utf8({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Utf8, WellFormedOnly) {
  for (const char* good : {"", "a", "plain text longer than eight bytes", "Straße", "日本語のテキスト",
                           "🙂", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf"}) {
    EXPECT_TRUE(utf8(good)) << good;
  }
  for (const char* bad :
       {"\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "12345678\xc3", "\xe2\x82", "abc\xc3\x28"}) {
    EXPECT_FALSE(utf8(bad)) << bad;
  }
}

goalnet_msgs::msg::InstructionStatus rich() {
  goalnet_msgs::msg::InstructionStatus message;
  message.instruction("fülle den Becher");
  message.stage("acting");
  goalnet_msgs::msg::Predicate predicate;
  predicate.relation("On");
  predicate.subject("Mug_1");
  message.positive({predicate, predicate});
  goalnet_msgs::msg::SymbolicAction action;
  action.name("grasp");
  action.arguments({"Mug_1", "Sink"});
  message.actions({action});
  message.finished(true);
  return message;
}

TEST(CdrCheck, AcceptsWhatWeWriteAndMarksItsPadding) {
  const auto& support = type_support<goalnet_msgs::msg::InstructionStatus>();
  const auto message = rich();
  Bytes payload = ros::detail::encode(support, &message);
  const CdrLayout layout(*support.description);
  EXPECT_EQ(layout.check(payload), nullptr);
  const Bytes mask = layout.data_mask(payload);
  ASSERT_EQ(mask.size(), payload.size());
  // Padding may hold anything; the message stays the same.
  for (std::size_t i = 4; i < payload.size(); ++i) {
    if (mask[i] == 0) payload[i] = 0xa5;
  }
  goalnet_msgs::msg::InstructionStatus again;
  EXPECT_EQ(ros::detail::decode(support, layout, payload, &again), nullptr);
  EXPECT_EQ(again, message);
  payload.insert(payload.end(), {1, 2, 3});
  EXPECT_EQ(layout.check(payload), nullptr) << "what trails is ignored";
}

TEST(CdrCheck, EveryTruncationIsRefused) {
  const auto& support = type_support<goalnet_msgs::msg::InstructionStatus>();
  const auto message = rich();
  const Bytes payload = ros::detail::encode(support, &message);
  const CdrLayout layout(*support.description);
  for (std::size_t size = 0; size < payload.size(); ++size) {
    EXPECT_NE(layout.check(std::span(payload).first(size)), nullptr) << size << " of " << payload.size();
  }
}

TEST(CdrCheck, BigEndianIsRead) {
  const Bytes payload = {0, 0, 0, 0, 0, 0, 0, 3, 'h', 'i', 0};
  const auto& support = type_support<std_msgs::msg::String>();
  std_msgs::msg::String message;
  EXPECT_EQ(ros::detail::decode(support, CdrLayout(*support.description), payload, &message), nullptr);
  EXPECT_EQ(message.data(), "hi");
}

TEST(CdrCheck, BoundsAndBooleans) {
  const auto& support = type_support<rcl_interfaces::msg::ParameterDescriptor>();
  rcl_interfaces::msg::ParameterDescriptor message;
  message.integer_range().resize(1);
  const CdrLayout layout(*support.description);
  Bytes payload = ros::detail::encode(support, &message);
  EXPECT_EQ(layout.check(payload), nullptr);
  message.integer_range().resize(2);
  EXPECT_STREQ(layout.check(ros::detail::encode(support, &message)), "a sequence exceeds its bound");
  message.integer_range().clear();
  message.read_only(true);
  payload = ros::detail::encode(support, &message);
  // name, type, description, additional_constraints: 4+1 .. the boolean follows the third text.
  const auto at = std::find(payload.rbegin(), payload.rend(), 1).base() - payload.begin() - 1;
  payload[static_cast<std::size_t>(at)] = 2;
  EXPECT_NE(layout.check(payload), nullptr);
}

// Random damage to real payloads of every type: the decoder agrees with the check and never throws or
// crashes.
TEST(CdrCheck, RandomDamageNeverReachesTheDecoder) {
  std::mt19937 random(42);
  int accepted = 0;
  int refused = 0;
  for (const TypeDescription& type : all_types()) {
    const TypeSupport* support = find_type_support(type.name);
    if (support == nullptr) continue;
    const CdrLayout layout(type);
    const std::shared_ptr<void> message(support->create(), support->destroy);
    Bytes original = ros::detail::encode(*support, message.get());
    original.resize(original.size() + 64);
    for (int round = 0; round < 300; ++round) {
      Bytes payload = original;
      for (int hits = 1 + static_cast<int>(random() % 6); hits > 0; --hits) {
        payload[4 + random() % (payload.size() - 4)] =
            static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 5);
      }
      payload.resize(4 + random() % (payload.size() - 3));
      const std::shared_ptr<void> target(support->create(), support->destroy);
      const char* fault = ros::detail::decode(*support, layout, payload, target.get());
      if (fault == nullptr) {
        ++accepted;
        ASSERT_EQ(layout.check(payload), nullptr);
      } else {
        ++refused;
        ASSERT_STRNE(fault, "it does not decode") << type.name << ": the check missed something";
      }
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace goalnet::idl
