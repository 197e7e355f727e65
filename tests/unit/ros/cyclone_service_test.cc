// The header that rmw_cyclonedds puts in front of requests and replies, and whose reply reader is whose.
#include <gtest/gtest.h>

#include "components/ros/detail/cyclone_clients.h"
#include "components/ros/detail/cyclone_service.h"

namespace goalnet::ros::detail {
namespace {

using Bytes = std::vector<std::uint8_t>;

// As a Jazzy tool sent it (std_srvs/Trigger: four bytes of message).
const Bytes kRequest = {0,    1,    0,    0,                             //
                        0x65, 0x5f, 0xd5, 0x4a, 0x3d, 0x52, 0x86, 0x29,  //
                        1,    0,    0,    0,    0,    0,    0,    0,    7, 0, 0, 0};

TEST(CycloneHeader, IsTakenOutAndPutBack) {
  Bytes payload = kRequest;
  const auto header = take_cyclone_header(payload);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->client, 0x2986523d4ad55f65u);
  EXPECT_EQ(header->sequence, 1);
  EXPECT_EQ(payload, (Bytes{0, 1, 0, 0, 7, 0, 0, 0}));
  EXPECT_EQ(with_cyclone_header(payload, *header), kRequest);
}

TEST(CycloneHeader, IsReadInBothByteOrders) {
  Bytes payload = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xfe};
  const auto header = take_cyclone_header(payload);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->client, 0x0102030405060708u);
  EXPECT_EQ(header->sequence, -2);
  EXPECT_EQ(payload, (Bytes{0, 0, 0, 0}));
}

TEST(CycloneHeader, IsMissedWhereThePayloadIsTooShort) {
  for (std::size_t size = 0; size < 20; ++size) {
    Bytes payload(kRequest.begin(), kRequest.begin() + static_cast<std::ptrdiff_t>(size));
    const Bytes before = payload;
    EXPECT_FALSE(take_cyclone_header(payload)) << size;
    EXPECT_EQ(payload, before);
  }
}

TEST(CycloneClients, WaitForTheReaderOfTheSameClientAndService) {
  CycloneClients clients;
  const Gid writer{1, 0x10, 1}, other_service{1, 0x10, 2}, other_client{1, 0x10, 3}, own{1, 0x10, 4};
  const auto answerable = [&](std::vector<Gid> matched) {
    return clients.can_be_answered(writer, [&](const Gid& reader) {
      return std::find(matched.begin(), matched.end(), reader) != matched.end();
    });
  };
  EXPECT_TRUE(answerable({})) << "nothing is known of this client: nothing to wait for";
  clients.note_writer(writer, "rq/robot/get_stateRequest", " 1.10.a");
  EXPECT_FALSE(answerable({own}));
  clients.note_reader(other_service, "rr/robot/change_stateReply", " 1.10.a");
  clients.note_reader(other_client, "rr/robot/get_stateReply", " 1.10.b");
  EXPECT_FALSE(answerable({other_service, other_client}));
  clients.note_reader(own, "rr/robot/get_stateReply", " 1.10.a");
  EXPECT_FALSE(answerable({other_service, other_client})) << "discovered, not matched yet";
  EXPECT_TRUE(answerable({other_service, own}));
  clients.forget(own);
  EXPECT_FALSE(answerable({own}));
  clients.forget(writer);
  EXPECT_TRUE(answerable({}));
}

TEST(CycloneClients, HearNothingOfOtherTopics) {
  CycloneClients clients;
  const Gid writer{1, 0x10, 1};
  for (const char* topic : {"rt/robot/get_stateRequest", "rq/", "rq/Request", "Request", ""}) {
    clients.note_writer(writer, topic, "1.10.a");
    EXPECT_TRUE(clients.can_be_answered(writer, [](const Gid&) { return false; })) << topic;
  }
}

}  // namespace
}  // namespace goalnet::ros::detail
