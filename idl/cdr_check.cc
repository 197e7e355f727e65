#include "idl/cdr_check.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace goalnet::idl {
namespace {

// Bytes of a primitive by FieldType number; 0 for what ROS 2 interfaces here do not use.
std::uint8_t primitive_size(std::uint8_t id) {
  static constexpr std::uint8_t kSizes[] = {0, 0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0, 1, 0, 1, 1};
  return id < sizeof(kSizes) ? kSizes[id] : 0;
}

}  // namespace

struct CdrLayout::Cursor {
  const std::uint8_t* data;  // after the encapsulation: alignment counts from here
  std::size_t size;          // [bytes]
  bool swap;                 // byte order differs from this machine's
  std::size_t at = 0;        // next byte
  std::uint8_t* mask = nullptr;

  std::size_t left() const { return size - at; }
  // Skips padding; false past the end.
  bool align(std::size_t alignment) {
    at += (alignment - at % alignment) % alignment;
    return at <= size;
  }
  bool take(std::size_t bytes) {
    if (bytes > left()) return false;
    if (mask != nullptr) std::memset(mask + at, 0xff, bytes);
    at += bytes;
    return true;
  }
  bool read_length(std::uint32_t& value) {
    if (!align(4) || left() < 4) return false;
    std::memcpy(&value, data + at, 4);
    if (swap) value = __builtin_bswap32(value);
    return take(4);
  }
};

CdrLayout::CdrLayout(const TypeDescription& type) {
  for (const FieldDescription& field : type.all_fields()) {
    Member member;
    member.shape = field.type_id >= kSequence          ? kSequence
                   : field.type_id >= kBoundedSequence ? kBoundedSequence
                   : field.type_id >= kArray           ? kArray
                                                       : 0;
    const std::uint8_t id = field.type_id - member.shape;
    member.capacity = field.capacity;
    member.string_capacity = field.string_capacity;
    if (id == kNested) {
      const TypeDescription* nested = find_type(field.nested);
      if (nested == nullptr) throw std::logic_error(std::string("unknown type ") + field.nested);
      member.kind = Kind::kStruct;
      member.nested = std::make_shared<CdrLayout>(*nested);
    } else if (id == kString || id == kBoundedString) {
      member.kind = Kind::kText;
    } else {
      member.kind = id == 15 ? Kind::kBool : Kind::kPrimitive;
      member.size = primitive_size(id);
      if (member.size == 0) throw std::logic_error(std::string("unsupported field type in ") + type.name);
    }
    const std::uint32_t one = member.kind == Kind::kStruct ? member.nested->smallest_
                              : member.kind == Kind::kText ? 4
                                                           : member.size;
    smallest_ += member.shape == 0 ? one : member.shape == kArray ? one * member.capacity : 4;
    members_.push_back(std::move(member));
  }
}

const char* CdrLayout::walk_elements(const Member& member, std::uint32_t count, Cursor& cursor) {
  if (count == 0) return nullptr;
  switch (member.kind) {
    case Kind::kPrimitive:
    case Kind::kBool: {
      if (!cursor.align(member.size) || count > cursor.left() / member.size) return "it ends too early";
      const std::uint8_t* first = cursor.data + cursor.at;
      cursor.take(std::size_t{count} * member.size);
      if (member.kind == Kind::kBool) {
        for (std::uint32_t i = 0; i < count; ++i) {
          if (first[i] > 1) return "a boolean is neither 0 nor 1";
        }
      }
      return nullptr;
    }
    case Kind::kText:
      if (count > cursor.left() / 4) return "a sequence is longer than the message";
      for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t length = 0;
        if (!cursor.read_length(length)) return "it ends too early";
        if (length > cursor.left()) return "a string is longer than the message";
        if (length == 0) continue;
        const std::uint8_t* text = cursor.data + cursor.at;
        const std::uint32_t used = text[length - 1] == 0 ? length - 1 : length;
        if (member.string_capacity != 0 && used > member.string_capacity) return "a string exceeds its bound";
        if (!is_utf8({text, used})) return "a string is not UTF-8";
        cursor.take(length);
      }
      return nullptr;
    case Kind::kStruct:
      if (count > cursor.left() / std::max<std::uint32_t>(member.nested->smallest_, 1)) {
        return "a sequence is longer than the message";
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        if (const char* fault = member.nested->walk(cursor)) return fault;
      }
      return nullptr;
  }
  return nullptr;
}

const char* CdrLayout::walk(Cursor& cursor) const {
  for (const Member& member : members_) {
    std::uint32_t count = member.shape == kArray ? member.capacity : 1;
    if (member.shape == kSequence || member.shape == kBoundedSequence) {
      if (!cursor.read_length(count)) return "it ends too early";
      if (member.shape == kBoundedSequence && count > member.capacity) return "a sequence exceeds its bound";
    }
    if (const char* fault = walk_elements(member, count, cursor)) return fault;
  }
  return nullptr;
}

const char* CdrLayout::check(std::span<const std::uint8_t> payload) const {
  if (payload.size() < 4) return "it has no encapsulation";
  if (payload[0] != 0 || payload[1] > 1) return "its encoding is not plain CDR";
  const bool little = payload[1] == 1;
  Cursor cursor{payload.data() + 4, payload.size() - 4,
                little != (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)};
  return walk(cursor);
}

std::vector<std::uint8_t> CdrLayout::data_mask(std::span<const std::uint8_t> payload) const {
  if (check(payload) != nullptr) return {};
  std::vector<std::uint8_t> mask(payload.size(), 0);
  std::memset(mask.data(), 0xff, 2);
  const bool little = payload[1] == 1;
  Cursor cursor{payload.data() + 4, payload.size() - 4,
                little != (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)};
  cursor.mask = mask.data() + 4;
  walk(cursor);
  return mask;
}

bool is_utf8(std::span<const std::uint8_t> text) {
  std::size_t i = 0;
  while (i < text.size()) {
    // Most text is ASCII: eight bytes at a time.
    std::uint64_t eight = 0;
    if (text.size() - i >= 8) {
      std::memcpy(&eight, text.data() + i, 8);
      if ((eight & 0x8080808080808080ull) == 0) {
        i += 8;
        continue;
      }
    }
    const std::uint8_t lead = text[i];
    if (lead < 0x80) {
      ++i;
      continue;
    }
    const int more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
    if (lead < 0xc2 || lead > 0xf4 || i + more >= text.size()) return false;
    for (int k = 1; k <= more; ++k) {
      if ((text[i + k] & 0xc0) != 0x80) return false;
    }
    const std::uint8_t second = text[i + 1];
    if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
        (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f)) {
      return false;
    }
    i += more + 1;
  }
  return true;
}

}  // namespace goalnet::idl
