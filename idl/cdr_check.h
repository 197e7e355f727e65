// Checks received bytes against the description of their type before anything is decoded, so that no sender
// can make the decoder allocate more than the message holds, read past its end or throw.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "idl/type_description.h"

namespace goalnet::idl {

// One type, resolved for walking over its bytes. Made once, then read by any thread.
class CdrLayout {
 public:
  // All nested types must be known (the generator guarantees it).
  explicit CdrLayout(const TypeDescription& type);

  // `payload` as received: 4 bytes of encapsulation (plain CDR, either byte order), then the message.
  // nullptr if it can be decoded; else what is wrong with it, as a static text. Surplus bytes at the end are
  // allowed, as ROS 2 writers leave some. Strings must be UTF-8, bounds must be kept, booleans be 0 or 1.
  // Allocates nothing; time is linear in the size of the payload.
  const char* check(std::span<const std::uint8_t> payload) const;

  // Where data is (ff) and where padding is (00), as long as the payload; for comparing payloads of writers
  // that leave their padding uninitialised. Empty if check() fails.
  std::vector<std::uint8_t> data_mask(std::span<const std::uint8_t> payload) const;

 private:
  enum class Kind : std::uint8_t { kPrimitive, kBool, kText, kStruct };
  struct Member {
    Kind kind = Kind::kPrimitive;
    std::uint8_t size = 0;              // [bytes] of a primitive, also its alignment
    std::uint8_t shape = 0;             // 0, kArray, kBoundedSequence or kSequence
    std::uint32_t capacity = 0;         // of array or bounded sequence
    std::uint32_t string_capacity = 0;  // 0: unbounded
    std::shared_ptr<const CdrLayout> nested;
  };
  struct Cursor;
  const char* walk(Cursor& cursor) const;
  static const char* walk_elements(const Member& member, std::uint32_t count, Cursor& cursor);

  std::vector<Member> members_;
  std::uint32_t smallest_ = 0;  // [bytes] no value of this type is shorter
};

// True for well-formed UTF-8 (no overlong forms, no surrogates).
bool is_utf8(std::span<const std::uint8_t> text);

}  // namespace goalnet::idl
