// Model files: the safetensors format (an 8-byte header length, a JSON header, raw little-endian tensors).
// The reader trusts nothing: every length, offset, type and shape is checked before a byte is used, and each
// fault gives one message that says what is wrong with which tensor. Files are read whole; nothing is mapped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

enum class TensorType { kBool, kU8, kI8, kI16, kU16, kF16, kBF16, kI32, kU32, kF32, kF64, kI64, kU64 };

// "F32" and so on; empty for a number that is no type.
std::string_view to_string(TensorType type);
std::size_t bytes_of(TensorType type);

// What a reader accepts. The defaults admit a MiniLM-sized sentence encoder (90 MB) and refuse absurd files.
struct TensorLimits {
  std::uint64_t max_file_bytes = 512ull << 20;
  std::uint64_t max_header_bytes = 16ull << 20;
  std::size_t max_tensors = 8192;
  std::size_t max_dimensions = 8;
};

struct TensorEntry {
  TensorType type = TensorType::kF32;
  std::vector<std::uint64_t> shape;  // empty for a scalar
  std::uint64_t begin = 0, end = 0;  // bytes from the start of the data block
};

// A dense row-major matrix of floats as it stands in a file; vectors have one row dimension only.
struct FloatTensor {
  std::vector<std::uint64_t> shape;
  std::vector<float> values;
};

// A checked file in memory. Immutable; safe to read from several threads.
class SafeTensors {
 public:
  // Errors: kInvalidRequest, the message starts with `path`.
  static Expected<SafeTensors> load(const std::string& path, const TensorLimits& limits = {});
  // The same for bytes in memory; `name` stands for the path in messages.
  static Expected<SafeTensors> parse(std::vector<std::byte> file, const std::string& name,
                                     const TensorLimits& limits = {});

  const std::map<std::string, TensorEntry, std::less<>>& tensors() const { return tensors_; }
  const std::map<std::string, std::string, std::less<>>& metadata() const { return metadata_; }
  // The value of a metadata key; kInvalidRequest when the file lacks it.
  Expected<std::string> metadata(std::string_view key) const;
  bool contains(std::string_view tensor) const { return tensors_.find(tensor) != tensors_.end(); }

  // A tensor of type F32, F16, BF16 or F64 as floats. Fails when it is missing, has another shape than
  // `shape`, or holds a value that is not finite. 0 in `shape` admits any size in that dimension.
  Expected<FloatTensor> floats(std::string_view tensor, std::span<const std::uint64_t> shape) const;
  // The raw bytes of a tensor that exists.
  std::span<const std::byte> bytes(const TensorEntry& entry) const;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::vector<std::byte> file_;
  std::size_t data_ = 0;  // where the data block starts in file_
  std::map<std::string, TensorEntry, std::less<>> tensors_;
  std::map<std::string, std::string, std::less<>> metadata_;
};

// Collects tensors and writes them. The same content gives the same bytes.
class SafeTensorsWriter {
 public:
  void metadata(std::string key, std::string value) { metadata_[std::move(key)] = std::move(value); }
  // `values` has as many elements as the product of `shape`; kInternal otherwise.
  Expected<void> add(const std::string& tensor, std::vector<std::uint64_t> shape,
                     std::span<const float> values);

  std::vector<std::byte> bytes() const;
  // Writes beside `path` and renames, so that a crash never leaves half a model.
  Expected<void> write(const std::string& path) const;

 private:
  std::map<std::string, FloatTensor, std::less<>> tensors_;
  std::map<std::string, std::string, std::less<>> metadata_;
};

}  // namespace goalnet::inference
