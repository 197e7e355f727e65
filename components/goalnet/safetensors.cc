#include "components/goalnet/safetensors.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "components/goalnet/safetensors_header.h"

namespace goalnet::inference {
namespace {

static_assert(std::endian::native == std::endian::little, "tensors are copied as they stand in the file");

std::string shape_text(std::span<const std::uint64_t> shape) {
  std::string text = "[";
  for (const std::uint64_t size : shape)
    text += (text.size() > 1 ? ", " : "") + (size == 0 ? "any" : std::to_string(size));
  return text + "]";
}

float half_to_float(std::uint16_t half) {
  const int exponent = (half >> 10) & 0x1f;
  const int mantissa = half & 0x3ff;
  const float sign = (half & 0x8000) != 0 ? -1.0F : 1.0F;
  if (exponent == 0) return sign * std::ldexp(static_cast<float>(mantissa), -24);
  if (exponent == 31) return mantissa != 0 ? std::nanf("") : sign * INFINITY;
  return sign * std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
}

float read_float(TensorType type, const std::byte* place) {
  switch (type) {
    case TensorType::kF32: {
      float value;
      std::memcpy(&value, place, sizeof value);
      return value;
    }
    case TensorType::kF64: {
      double value;
      std::memcpy(&value, place, sizeof value);
      return static_cast<float>(value);
    }
    case TensorType::kF16:
    case TensorType::kBF16: {
      std::uint16_t bits;
      std::memcpy(&bits, place, sizeof bits);
      return type == TensorType::kF16 ? half_to_float(bits)
                                      : std::bit_cast<float>(static_cast<std::uint32_t>(bits) << 16);
    }
    default:
      return std::nanf("");
  }
}

bool is_float(TensorType type) {
  return type == TensorType::kF32 || type == TensorType::kF64 || type == TensorType::kF16 ||
         type == TensorType::kBF16;
}

}  // namespace

Expected<SafeTensors> SafeTensors::load(const std::string& path, const TensorLimits& limits) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error || !std::filesystem::exists(status)) {
    return fail(Outcome::kInvalidRequest, path + ": there is no such model file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    return fail(Outcome::kInvalidRequest, path + " is no model file: it is not a regular file");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) return fail(Outcome::kInvalidRequest, path + " cannot be read: " + error.message());
  if (size > limits.max_file_bytes) {
    return fail(Outcome::kInvalidRequest, path + " is no model file: its " + std::to_string(size) +
                                              " bytes are more than the " +
                                              std::to_string(limits.max_file_bytes) + " admitted");
  }
  std::vector<std::byte> file(size);
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(file.data()), static_cast<std::streamsize>(size))) {
    return fail(Outcome::kInvalidRequest, path + " cannot be read");
  }
  return parse(std::move(file), path, limits);
}

Expected<SafeTensors> SafeTensors::parse(std::vector<std::byte> file, const std::string& name,
                                         const TensorLimits& limits) {
  const auto refuse = [&name](const std::string& why) {
    return fail(Outcome::kInvalidRequest, name + " is no model file: " + why);
  };
  if (file.size() > limits.max_file_bytes) return refuse("it is larger than admitted");
  std::uint64_t length = 0;
  if (file.size() < sizeof length) return refuse("it is shorter than 8 bytes");
  std::memcpy(&length, file.data(), sizeof length);
  if (length > limits.max_header_bytes)
    return refuse("its header of " + std::to_string(length) + " bytes is larger than admitted");
  if (length > file.size() - sizeof length) {
    return refuse("it ends inside its header (" + std::to_string(length) + " bytes announced, " +
                  std::to_string(file.size() - sizeof length) + " there)");
  }
  const std::string_view json(reinterpret_cast<const char*>(file.data()) + sizeof length, length);
  auto header = parse_header(json, name, limits);
  if (!header) return tl::unexpected(header.error());
  if (auto layout = check_layout(*header, file.size() - sizeof length - length, name); !layout) {
    return tl::unexpected(layout.error());
  }
  SafeTensors result;
  result.name_ = name;
  result.file_ = std::move(file);
  result.data_ = sizeof length + length;
  result.tensors_ = std::move(header->tensors);
  result.metadata_ = std::move(header->metadata);
  return result;
}

Expected<std::string> SafeTensors::metadata(std::string_view key) const {
  const auto found = metadata_.find(key);
  if (found == metadata_.end()) {
    return fail(Outcome::kInvalidRequest,
                name_ + " is no goalnet model: its metadata lacks \"" + std::string(key) + "\"");
  }
  return found->second;
}

std::span<const std::byte> SafeTensors::bytes(const TensorEntry& entry) const {
  return std::span<const std::byte>(file_).subspan(data_ + entry.begin, entry.end - entry.begin);
}

Expected<FloatTensor> SafeTensors::floats(std::string_view tensor,
                                          std::span<const std::uint64_t> shape) const {
  const auto refuse = [&](const std::string& why) {
    return fail(Outcome::kInvalidRequest, name_ + ": tensor \"" + std::string(tensor) + "\" " + why);
  };
  const auto found = tensors_.find(tensor);
  if (found == tensors_.end()) return refuse("is missing");
  const TensorEntry& entry = found->second;
  bool fits = entry.shape.size() == shape.size();
  for (std::size_t i = 0; fits && i < shape.size(); ++i) fits = shape[i] == 0 || shape[i] == entry.shape[i];
  if (!fits) return refuse("has the shape " + shape_text(entry.shape) + ", needed is " + shape_text(shape));
  if (!is_float(entry.type))
    return refuse("holds " + std::string(to_string(entry.type)) + ", needed are floats");
  const std::size_t width = bytes_of(entry.type);
  const std::span<const std::byte> raw = bytes(entry);
  FloatTensor result{entry.shape, std::vector<float>(raw.size() / width)};
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = read_float(entry.type, raw.data() + i * width);
    if (!std::isfinite(result.values[i])) return refuse("holds a value that is not finite");
  }
  return result;
}

Expected<void> SafeTensorsWriter::add(const std::string& tensor, std::vector<std::uint64_t> shape,
                                      std::span<const float> values) {
  std::uint64_t count = 1;
  for (const std::uint64_t size : shape) count *= size;
  if (count != values.size()) {
    return fail(Outcome::kInternal, "tensor \"" + tensor + "\": " + std::to_string(values.size()) +
                                        " values do not fill " + shape_text(shape));
  }
  tensors_[tensor] = {std::move(shape), std::vector<float>(values.begin(), values.end())};
  return {};
}

std::vector<std::byte> SafeTensorsWriter::bytes() const {
  nlohmann::ordered_json header;
  if (!metadata_.empty()) {
    for (const auto& [key, value] : metadata_) header["__metadata__"][key] = value;
  }
  std::uint64_t place = 0;
  for (const auto& [name, tensor] : tensors_) {
    const std::uint64_t end = place + tensor.values.size() * sizeof(float);
    header[name] = {{"dtype", "F32"}, {"shape", tensor.shape}, {"data_offsets", {place, end}}};
    place = end;
  }
  std::string json =
      header.is_null() ? "{}" : header.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  json.resize((json.size() + 7) / 8 * 8, ' ');  // keeps the tensors aligned for readers that map the file
  std::vector<std::byte> file(8 + json.size() + place);
  const std::uint64_t length = json.size();
  std::memcpy(file.data(), &length, 8);
  std::memcpy(file.data() + 8, json.data(), json.size());
  std::byte* data = file.data() + 8 + json.size();
  for (const auto& [name, tensor] : tensors_) {
    if (tensor.values.empty()) continue;
    std::memcpy(data, tensor.values.data(), tensor.values.size() * sizeof(float));
    data += tensor.values.size() * sizeof(float);
  }
  return file;
}

Expected<void> SafeTensorsWriter::write(const std::string& path) const {
  const std::vector<std::byte> file = bytes();
  const std::string beside = path + ".part";
  {
    std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    stream.flush();
    if (!stream)
      return fail(Outcome::kInvalidRequest, beside + " cannot be written; check the folder and free space");
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) return fail(Outcome::kInvalidRequest, path + " cannot be written: " + error.message());
  return {};
}

}  // namespace goalnet::inference
