// What every interface of idl/ looks like: names, fields and type hashes, generated from the .msg, .srv and
// .action files. Plain data without DDS; safe from any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace goalnet::idl {

// type_id counts as type_description_interfaces/msg/FieldType does.
struct FieldDescription {
  const char* name;
  std::uint8_t type_id;           // of the element, + kArray, kBoundedSequence or kSequence
  std::uint32_t capacity;         // array size or bound of a sequence, else 0
  std::uint32_t string_capacity;  // bound of a string, else 0
  const char* nested;             // "pkg/msg/Type", else ""
  const char* default_value;      // as ROS 2 writes it ("1.0", "True"), "" where the file gives none
};

inline constexpr std::uint8_t kNested = 1;
inline constexpr std::uint8_t kString = 17;
inline constexpr std::uint8_t kBoundedString = 21;
inline constexpr std::uint8_t kArray = 48;
inline constexpr std::uint8_t kBoundedSequence = 96;
inline constexpr std::uint8_t kSequence = 144;

struct TypeDescription {
  const char* name;  // pkg/msg/Type
  const char* hash;  // RIHS01_ and 64 hexadecimal digits, as ROS 2 Jazzy computes them
  const FieldDescription* fields;
  std::uint32_t field_count;
  const char* const* referenced;  // names of all types inside, sorted, ended by nullptr
  const char* encoding;           // msg, srv, action; implicit where no file of its own exists
  const char* source;             // text of the file

  std::span<const FieldDescription> all_fields() const { return {fields, field_count}; }
};

// All types, sorted by name.
std::span<const TypeDescription> all_types();

// The type of that name ("std_msgs/msg/String"); nullptr if there is none.
const TypeDescription* find_type(std::string_view name);

// "std_msgs::msg::dds_::String_" for "std_msgs/msg/String", and back; the latter gives "" for a name that
// does not look like a ROS type.
std::string dds_type_name(std::string_view ros_name);
std::string ros_type_name(std::string_view dds_name);

// Definition in ros2msg form with all dependencies, as bags carry it.
std::string full_definition(const TypeDescription& type);

}  // namespace goalnet::idl
