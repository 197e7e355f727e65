#include "components/ros/detail/cyclone_service.h"

#include <algorithm>

namespace goalnet::ros::detail {
namespace {

constexpr std::size_t kEncapsulationHeader = 4;  // [bytes]
constexpr std::size_t kServiceHeader = 16;       // [bytes]

std::uint64_t read_number(std::span<const std::uint8_t> bytes, bool big_endian) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < 8; ++i) number = number << 8 | bytes[big_endian ? i : 7 - i];
  return number;
}

void append_number(std::vector<std::uint8_t>& bytes, std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

}  // namespace

bool from_cyclone(const Gid& endpoint) { return endpoint[0] == 0x01 && endpoint[1] == 0x10; }

std::uint64_t cyclone_client_number(const Gid& endpoint) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const std::uint8_t byte : endpoint) hash = (hash ^ byte) * 0x100000001b3;
  return hash;
}

std::optional<CycloneHeader> take_cyclone_header(std::vector<std::uint8_t>& payload) {
  if (payload.size() < kEncapsulationHeader + kServiceHeader) return std::nullopt;
  const bool big_endian = payload[1] == 0;
  const std::span header =
      std::span<const std::uint8_t>(payload).subspan(kEncapsulationHeader, kServiceHeader);
  const CycloneHeader taken{read_number(header.first(8), big_endian),
                            static_cast<std::int64_t>(read_number(header.last(8), big_endian))};
  payload.erase(payload.begin() + kEncapsulationHeader,
                payload.begin() + kEncapsulationHeader + kServiceHeader);
  return taken;
}

std::vector<std::uint8_t> with_cyclone_header(std::span<const std::uint8_t> payload,
                                              const CycloneHeader& header) {
  std::vector<std::uint8_t> out;
  out.reserve(payload.size() + kServiceHeader);
  const auto encapsulation = payload.first(std::min(payload.size(), kEncapsulationHeader));
  out.assign(encapsulation.begin(), encapsulation.end());
  append_number(out, header.client);
  append_number(out, static_cast<std::uint64_t>(header.sequence));
  out.insert(out.end(), payload.begin() + static_cast<std::ptrdiff_t>(encapsulation.size()), payload.end());
  return out;
}

}  // namespace goalnet::ros::detail
