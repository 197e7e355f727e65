#include "components/ros/detail/message_type.h"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <mutex>

namespace goalnet::ros::detail {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

constexpr std::uint32_t kEncapsulation = 4;  // [bytes]
// What histories reserve for a sample at first [bytes]; larger ones grow it.
constexpr std::uint32_t kTypicalSize = 256;

std::uint32_t encoded_size(const Outgoing& out) {
  const std::size_t size = out.support != nullptr ? out.support->serialized_size(out.message) + kEncapsulation
                                                  : out.payload.size();
  // Rounded up as rmw does: writers may pad the end to four bytes.
  return static_cast<std::uint32_t>(std::min(size + (4 - size % 4) % 4, kLargestPayload + 1));
}

}  // namespace

MessageType::MessageType(const std::string& dds_name) {
  setName(dds_name.c_str());
  m_typeSize = kTypicalSize;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool MessageType::serialize(void* data, Payload* payload) {
  const auto& out = *static_cast<const Outgoing*>(data);
  if (out.support == nullptr) {
    if (out.payload.size() > payload->max_size) return false;
    if (!out.payload.empty()) std::memcpy(payload->data, out.payload.data(), out.payload.size());
    payload->length = static_cast<std::uint32_t>(out.payload.size());
    payload->encapsulation = out.payload.size() > 1 && out.payload[1] == 0 ? CDR_BE : CDR_LE;
    return true;
  }
  try {
    FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    payload->encapsulation = CDR_LE;
    cdr.serialize_encapsulation();
    out.support->serialize(out.message, cdr);
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  } catch (const std::exception&) {
    return false;  // too large for the payload, or a string with a character that CDR cannot carry
  }
}

bool MessageType::deserialize(Payload* payload, void* data) {
  auto& in = *static_cast<Incoming*>(data);
  const std::span<const std::uint8_t> bytes(payload->data, payload->length);
  if (payload->length > kLargestPayload) {
    in.fault = "it is too large";
  } else if (in.support == nullptr) {
    in.payload.assign(bytes.begin(), bytes.end());
  } else {
    in.fault = decode(*in.support, *in.layout, bytes, in.message);
  }
  return true;
}

std::function<std::uint32_t()> MessageType::getSerializedSizeProvider(void* data) {
  return [data] { return encoded_size(*static_cast<const Outgoing*>(data)); };
}

std::vector<std::uint8_t> encode(const idl::TypeSupport& support, const void* message) {
  std::vector<std::uint8_t> bytes(support.serialized_size(message) + kEncapsulation);
  try {
    FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    cdr.serialize_encapsulation();
    support.serialize(message, cdr);
    bytes.resize(cdr.getSerializedDataLength());
    return bytes;
  } catch (const std::exception&) {
    return {};
  }
}

const char* decode(const idl::TypeSupport& support, const idl::CdrLayout& layout,
                   std::span<const std::uint8_t> payload, void* message) {
  if (const char* fault = layout.check(payload)) return fault;
  try {
    FastBuffer buffer(const_cast<char*>(reinterpret_cast<const char*>(payload.data())), payload.size());
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    support.deserialize(message, cdr);
    return nullptr;
  } catch (const std::exception&) {
    return "it does not decode";  // the check above should have found it; never let it end the process
  }
}

const idl::CdrLayout& layout_of(const idl::TypeSupport& support) {
  static std::mutex mutex;
  static std::map<const idl::TypeDescription*, std::unique_ptr<idl::CdrLayout>> layouts;
  std::lock_guard lock(mutex);
  auto& layout = layouts[support.description];
  if (!layout) layout = std::make_unique<idl::CdrLayout>(*support.description);
  return *layout;
}

}  // namespace goalnet::ros::detail
