// Body of type_support<>; only the generated PKG_support.cc include it.
#pragma once

#include <fastcdr/Cdr.h>

#include <vector>

#include "idl/type_support.h"

namespace goalnet::idl {

template <class Message>
struct NameOf;  // kRos and kDds, specialised in the generated files

template <class Message>
const TypeSupport& type_support() {
  static const TypeSupport support{
      NameOf<Message>::kRos,
      NameOf<Message>::kDds,
      find_type(NameOf<Message>::kRos),
      []() -> void* { return new Message(); },
      [](void* message) { delete static_cast<Message*>(message); },
      [](const void* message, eprosima::fastcdr::Cdr& cdr) {
        static_cast<const Message*>(message)->serialize(cdr);
      },
      [](void* message, eprosima::fastcdr::Cdr& cdr) { static_cast<Message*>(message)->deserialize(cdr); },
      [](const void* message) {
        return Message::getCdrSerializedSize(*static_cast<const Message*>(message));
      }};
  return support;
}

}  // namespace goalnet::idl
