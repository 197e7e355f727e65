// The records of MCAP files (https://mcap.dev/spec): what the writer and the reader have in common.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace goalnet::ros::mcap {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t kMagic[] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead = 1 + 8;           // [bytes] opcode and length
inline constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;  // [bytes] channel, sequence, log and publish time

enum Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

// Appending, little endian.
template <class T>
void number(Bytes& out, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
}
void text(Bytes& out, const std::string& value);
void texts(Bytes& out, const std::map<std::string, std::string>& values);
void record(Bytes& out, Opcode opcode, const Bytes& content);
template <class Key, class Value>
void table(Bytes& out, const std::map<Key, Value>& values) {
  number<std::uint32_t>(out, static_cast<std::uint32_t>(values.size() * (sizeof(Key) + sizeof(Value))));
  for (const auto& [key, value] : values) {
    number<Key>(out, key);
    number<Value>(out, value);
  }
}

// CRC-32 as zlib computes it; give the result of one call to the next to go on.
std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t so_far = 0);

// Takes a record apart. After the first thing that is not there all further answers are empty and ok() is
// false.
class Parser {
 public:
  explicit Parser(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class T>
  T number() {
    T value{};
    if (!need(sizeof(T))) return value;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = static_cast<T>(value | (static_cast<std::uint64_t>(bytes_[i]) << (8 * i)));
    bytes_ = bytes_.subspan(sizeof(T));
    return value;
  }
  std::string text();
  std::map<std::string, std::string> texts();
  std::span<const std::uint8_t> bytes(std::uint64_t count);
  std::span<const std::uint8_t> rest() const { return bytes_; }
  bool ok() const { return ok_; }

 private:
  bool need(std::uint64_t count);
  std::span<const std::uint8_t> bytes_;
  bool ok_ = true;
};

}  // namespace goalnet::ros::mcap
