// How Fast DDS sees our messages: one non-template type for all of them. What to encode from and decode into
// travels with each call, so that raw payloads, checked decoding and typed messages share one path.
#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "idl/cdr_check.h"
#include "idl/type_support.h"

namespace goalnet::ros::detail {

// Passed to DataWriter::write(): either a message or finished bytes.
struct Outgoing {
  const idl::TypeSupport* support = nullptr;
  const void* message = nullptr;
  std::span<const std::uint8_t> payload;  // with encapsulation; used where support is nullptr
};

// Passed to DataReader::take_next_sample(): where to decode to.
struct Incoming {
  const idl::TypeSupport* support = nullptr;
  const idl::CdrLayout* layout = nullptr;
  void* message = nullptr;
  std::vector<std::uint8_t> payload;  // filled where support is nullptr
  const char* fault = nullptr;        // set where the sample is malformed
};

// Payloads beyond this are refused on both sides [bytes].
inline constexpr std::size_t kLargestPayload = 64u << 20;

class MessageType : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit MessageType(const std::string& dds_name);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  // Always true: a malformed sample is reported in Incoming::fault, so that the reader goes on with the next.
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override { return new Incoming(); }
  void deleteData(void* data) override { delete static_cast<Incoming*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

// Encodes a message with its encapsulation, little endian. Empty if encoding fails.
std::vector<std::uint8_t> encode(const idl::TypeSupport& support, const void* message);

// Checks and decodes. nullptr on success, else what is wrong.
const char* decode(const idl::TypeSupport& support, const idl::CdrLayout& layout,
                   std::span<const std::uint8_t> payload, void* message);

// The layout of a type, made once per process. Thread-safe.
const idl::CdrLayout& layout_of(const idl::TypeSupport& support);

}  // namespace goalnet::ros::detail
