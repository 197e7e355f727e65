#include "tests/interoperability/replay/captures.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace goalnet::ros {
namespace {

Gid to_gid(const Bytes& bytes) {
  Gid gid{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), gid.size()), gid.begin());
  return gid;
}

std::int64_t sequence_of(const Bytes& bytes) {  // high word first, each little endian
  const auto word = [&](std::size_t at) {
    return std::uint32_t{bytes.at(at)} | std::uint32_t{bytes.at(at + 1)} << 8 |
           std::uint32_t{bytes.at(at + 2)} << 16 | std::uint32_t{bytes.at(at + 3)} << 24;
  };
  return static_cast<std::int64_t>(std::uint64_t{word(16)} << 32 | word(20));
}

}  // namespace

Bytes from_hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

Bytes CapturedSample::as_sent() const {
  Bytes bytes = payload;
  bytes.insert(bytes.begin() + 4, header.begin(), header.end());
  return bytes;
}

std::filesystem::path captures_folder() {
  return std::filesystem::path(GOALNET_SOURCE_DIR) / ".." / "shared" / "data" / "ros2";
}

std::vector<CapturedSample> load_captures(const CaptureSet& set) {
  std::ifstream file(captures_folder() / (set.prefix + "_samples.json"));
  auto all = nlohmann::json::parse(file);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a["t"].template get<double>() < b["t"].template get<double>();
  });
  std::vector<CapturedSample> samples;
  for (const auto& one : all) {
    CapturedSample sample;
    sample.node = one["node"];
    sample.topic = one["topic"];
    sample.type = idl::ros_type_name(one["type"].get<std::string>());
    sample.id = {to_gid(from_hex(one["writer"])), one["sn"]};
    for (const auto& parameter : one["inline_qos"]) {
      if (parameter["pid"] != "0x800f") continue;
      const Bytes value = from_hex(parameter["hex"]);
      sample.related = SampleId{to_gid(value), sequence_of(value)};
    }
    sample.payload = from_hex(one["payload"]);
    if (set.distro == Distro::kJazzy && (sample.is_request() || sample.is_reply())) {
      const auto header = sample.payload.begin() + 4;
      sample.header.assign(header, header + 16);
      sample.payload.erase(header, header + 16);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

std::vector<std::string> load_endpoint_rows(const CaptureSet& set, const std::string& node) {
  std::ifstream file(captures_folder() / (set.prefix + "_endpoints_table.txt"));
  std::vector<std::string> rows;
  bool wanted = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("== ")) {
      wanted = line == "== " + node;
      continue;
    }
    if (!wanted) continue;
    std::istringstream words(line);
    std::string row;
    for (std::string word; words >> word;) row += (row.empty() ? "" : " ") + word;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace goalnet::ros
