// Connects a generated C++ message class with its name, its description and its encoding, so that
// Publisher<M> and Subscription<M> find all three. No DDS header is needed to use it.
#pragma once

#include <cstddef>

#include "idl/type_description.h"

namespace eprosima::fastcdr {
class Cdr;
}

namespace goalnet::idl {

// Handles messages of one type without knowing it. Functions are safe from any thread.
struct TypeSupport {
  const char* ros_name;  // std_msgs/msg/String
  const char* dds_name;  // std_msgs::msg::dds_::String_
  const TypeDescription* description;
  void* (*create)();
  void (*destroy)(void* message);
  void (*serialize)(const void* message, eprosima::fastcdr::Cdr& cdr);  // may throw what Fast CDR throws
  void (*deserialize)(void* message, eprosima::fastcdr::Cdr& cdr);      // same
  std::size_t (*serialized_size)(const void* message);  // [bytes] without the 4 of the encapsulation
};

// Defined in the generated PKG_support.cc for every message of idl/; for another type the link fails.
template <class Message>
const TypeSupport& type_support();

// The same for a name known only when running ("std_msgs/msg/String"); nullptr if idl/ has no such message.
const TypeSupport* find_type_support(std::string_view name);

}  // namespace goalnet::idl
