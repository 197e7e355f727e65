#include "components/ros/bag/mcap_format.h"

#include <zlib.h>

namespace goalnet::ros::mcap {

void text(Bytes& out, const std::string& value) {
  number<std::uint32_t>(out, static_cast<std::uint32_t>(value.size()));
  out.insert(out.end(), value.begin(), value.end());
}

void texts(Bytes& out, const std::map<std::string, std::string>& values) {
  Bytes content;
  for (const auto& [key, value] : values) {
    text(content, key);
    text(content, value);
  }
  number<std::uint32_t>(out, static_cast<std::uint32_t>(content.size()));
  out.insert(out.end(), content.begin(), content.end());
}

void record(Bytes& out, Opcode opcode, const Bytes& content) {
  out.push_back(opcode);
  number<std::uint64_t>(out, content.size());
  out.insert(out.end(), content.begin(), content.end());
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t so_far) {
  return static_cast<std::uint32_t>(::crc32_z(so_far, bytes.data(), bytes.size()));
}

bool Parser::need(std::uint64_t count) {
  ok_ = ok_ && count <= bytes_.size();
  return ok_;
}

std::span<const std::uint8_t> Parser::bytes(std::uint64_t count) {
  if (!need(count)) return {};
  const auto part = bytes_.first(static_cast<std::size_t>(count));
  bytes_ = bytes_.subspan(part.size());
  return part;
}

std::string Parser::text() {
  const auto part = bytes(number<std::uint32_t>());
  return std::string(part.begin(), part.end());
}

std::map<std::string, std::string> Parser::texts() {
  std::map<std::string, std::string> out;
  Parser inside(bytes(number<std::uint32_t>()));
  while (ok_ && !inside.rest().empty()) {
    std::string key = inside.text();
    out[std::move(key)] = inside.text();
    ok_ = ok_ && inside.ok();
  }
  return out;
}

}  // namespace goalnet::ros::mcap
