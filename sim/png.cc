// A minimal PNG writer: deflate with stored blocks needs no compression library.
#include <array>
#include <fstream>

#include "sim/render.h"

namespace goalnet::sim {
namespace {

void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 0xff));
}

std::uint32_t crc32(const std::string& data) {
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : data) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

void append_chunk(std::string& out, const std::string& type, const std::string& data) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  out += type + data;
  append_u32(out, crc32(type + data));
}

std::string zlib_stored(const std::string& data) {
  std::string out("\x78\x01", 2);
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char byte : data) {
    a = (a + static_cast<std::uint8_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  for (std::size_t start = 0; start < data.size(); start += 65535) {
    const std::size_t length = std::min<std::size_t>(65535, data.size() - start);
    out.push_back(start + length == data.size() ? '\x01' : '\x00');
    out.push_back(static_cast<char>(length & 0xff));
    out.push_back(static_cast<char>(length >> 8));
    out.push_back(static_cast<char>(~length & 0xff));
    out.push_back(static_cast<char>((~length >> 8) & 0xff));
    out.append(data, start, length);
  }
  append_u32(out, (b << 16) | a);
  return out;
}

}  // namespace

Expected<void> write_png(const Image& image, const std::string& path) {
  if (image.width <= 0 || image.height <= 0)
    return fail(Outcome::kInvalidRequest, path + ": the image is empty; nothing written");
  std::string rows;
  const std::size_t stride = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y) {
    rows.push_back('\0');  // no filter
    rows.append(reinterpret_cast<const char*>(image.rgb.data()) + static_cast<std::size_t>(y) * stride,
                stride);
  }
  std::string header;
  append_u32(header, static_cast<std::uint32_t>(image.width));
  append_u32(header, static_cast<std::uint32_t>(image.height));
  header += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB
  std::string file("\x89PNG\r\n\x1a\n", 8);
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", zlib_stored(rows));
  append_chunk(file, "IEND", "");
  std::ofstream stream(path, std::ios::binary);
  stream.write(file.data(), static_cast<std::streamsize>(file.size()));
  if (!stream)
    return fail(Outcome::kInvalidRequest, path + ": cannot be written; check the folder and its permissions");
  return {};
}

}  // namespace goalnet::sim
