#include "components/goalnet/safetensors_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

namespace goalnet::inference {
namespace {

struct TypeName {
  std::string_view name;
  TensorType type;
  std::size_t bytes;
};
constexpr std::array<TypeName, 13> kTypes = {{{"BOOL", TensorType::kBool, 1},
                                              {"U8", TensorType::kU8, 1},
                                              {"I8", TensorType::kI8, 1},
                                              {"I16", TensorType::kI16, 2},
                                              {"U16", TensorType::kU16, 2},
                                              {"F16", TensorType::kF16, 2},
                                              {"BF16", TensorType::kBF16, 2},
                                              {"I32", TensorType::kI32, 4},
                                              {"U32", TensorType::kU32, 4},
                                              {"F32", TensorType::kF32, 4},
                                              {"F64", TensorType::kF64, 8},
                                              {"I64", TensorType::kI64, 8},
                                              {"U64", TensorType::kU64, 8}}};

std::string shown(std::string_view text) {
  std::string result(text.substr(0, 60));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return "\"" + result + (text.size() > 60 ? "...\"" : "\"");
}

// A SAX handler instead of a document: the grammar of a header is tiny, and this way depth, duplicates and
// unknown keys are refused where they stand, before anything large is built.
class HeaderReader : public nlohmann::json_sax<nlohmann::json> {
 public:
  HeaderReader(TensorHeader& header, const TensorLimits& limits) : header_(header), limits_(limits) {}
  const std::string& problem() const { return problem_; }

  bool null() override { return refuse("a null"); }
  bool boolean(bool) override { return refuse("a true or false"); }
  bool number_integer(number_integer_t) override { return refuse("a negative number"); }
  bool number_float(number_float_t, const string_t&) override { return refuse("a number that is not whole"); }
  bool binary(binary_t&) override { return refuse("binary data"); }

  bool number_unsigned(number_unsigned_t value) override {
    if (list_ == List::kNone) return refuse("a number where none belongs");
    numbers_.push_back(value);
    if (numbers_.size() > limits_.max_dimensions) return refuse("too many numbers in \"" + field_ + "\"");
    return true;
  }

  bool string(string_t& value) override {
    if (depth_ == 2 && in_metadata_) {
      header_.metadata[key_] = value;
      return true;
    }
    if (depth_ == 2 && field_ == "dtype" && list_ == List::kNone) {
      const auto* found =
          std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& t) { return t.name == value; });
      if (found == kTypes.end()) return refuse("the unknown dtype " + shown(value));
      entry_.type = found->type;
      return true;
    }
    return refuse("a string where none belongs");
  }

  bool start_object(std::size_t) override {
    if (list_ != List::kNone) return refuse("an object inside a list");
    if (++depth_ > 2) return refuse("objects nested too deeply");
    if (depth_ == 1) return true;
    in_metadata_ = key_ == "__metadata__";
    entry_ = {};
    seen_type_ = seen_shape_ = seen_offsets_ = false;
    return true;
  }

  bool key(string_t& value) override {
    if (depth_ == 1) {
      key_ = value;
      tensor_ = value;
      const bool known = value == "__metadata__" ? metadata_seen_ : header_.tensors.contains(value);
      if (known) return refuse("a duplicate entry");
      if (value == "__metadata__") metadata_seen_ = true;
      if (value.empty()) return refuse("a tensor without a name");
      if (header_.tensors.size() >= limits_.max_tensors) return refuse("more tensors than are admitted");
      return true;
    }
    if (in_metadata_) {
      key_ = value;
      return header_.metadata.contains(value) ? refuse("the duplicate metadata key " + shown(value)) : true;
    }
    field_ = value;
    bool* seen = value == "dtype"          ? &seen_type_
                 : value == "shape"        ? &seen_shape_
                 : value == "data_offsets" ? &seen_offsets_
                                           : nullptr;
    if (seen == nullptr) return refuse("the unknown field " + shown(value));
    if (*seen) return refuse("the duplicate field " + shown(value));
    *seen = true;
    return true;
  }

  bool end_object() override {
    if (depth_-- != 2) return true;
    if (in_metadata_) {
      in_metadata_ = false;
      return true;
    }
    if (!seen_type_ || !seen_shape_ || !seen_offsets_) return refuse("no dtype, shape or data_offsets");
    header_.tensors[tensor_] = entry_;
    return true;
  }

  bool start_array(std::size_t) override {
    if (depth_ != 2 || in_metadata_ || list_ != List::kNone) return refuse("a list where none belongs");
    if (field_ != "shape" && field_ != "data_offsets") return refuse("a list as " + shown(field_));
    list_ = field_ == "shape" ? List::kShape : List::kOffsets;
    numbers_.clear();
    return true;
  }

  bool end_array() override {
    if (list_ == List::kShape) entry_.shape = numbers_;
    if (list_ == List::kOffsets) {
      if (numbers_.size() != 2) return refuse("data_offsets that are not two numbers");
      entry_.begin = numbers_[0];
      entry_.end = numbers_[1];
    }
    list_ = List::kNone;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    if (problem_.empty()) problem_ = "its header is not JSON at byte " + std::to_string(8 + position);
    return false;
  }

  // After the last event: a header must be one object whose entries are objects.
  std::optional<std::string> finish() const {
    return depth_ == 0 ? std::nullopt : std::optional<std::string>("its header is cut off");
  }

 private:
  enum class List { kNone, kShape, kOffsets };

  bool refuse(const std::string& what) {
    problem_ = "its header has " + what + (tensor_.empty() ? "" : " at tensor " + shown(tensor_));
    return false;
  }

  TensorHeader& header_;
  const TensorLimits& limits_;
  std::string problem_, key_, tensor_, field_;
  int depth_ = 0;
  bool in_metadata_ = false, metadata_seen_ = false;
  bool seen_type_ = false, seen_shape_ = false, seen_offsets_ = false;
  List list_ = List::kNone;
  TensorEntry entry_;
  std::vector<std::uint64_t> numbers_;
};

// The bytes a tensor of this shape needs; nothing when that overflows.
std::optional<std::uint64_t> needed_bytes(const TensorEntry& entry) {
  std::uint64_t bytes = bytes_of(entry.type);
  bool empty = false;
  for (const std::uint64_t size : entry.shape) {
    if (size == 0) {
      empty = true;
      continue;
    }
    if (bytes > std::numeric_limits<std::uint64_t>::max() / size) return std::nullopt;
    bytes *= size;
  }
  return empty ? 0 : bytes;
}

}  // namespace

std::string_view to_string(TensorType type) {
  for (const TypeName& known : kTypes) {
    if (known.type == type) return known.name;
  }
  return {};
}

std::size_t bytes_of(TensorType type) {
  for (const TypeName& known : kTypes) {
    if (known.type == type) return known.bytes;
  }
  return 0;
}

Expected<TensorHeader> parse_header(std::string_view json, const std::string& name,
                                    const TensorLimits& limits) {
  const auto refuse = [&name](const std::string& why) {
    return fail(Outcome::kInvalidRequest, name + " is no model file: " + why);
  };
  if (!json.starts_with('{')) return refuse("its header does not start with '{'");
  TensorHeader header;
  HeaderReader reader(header, limits);
  if (!nlohmann::json::sax_parse(json, &reader)) return refuse(reader.problem());
  if (const auto problem = reader.finish()) return refuse(*problem);
  return header;
}

Expected<void> check_layout(const TensorHeader& header, std::uint64_t data_bytes, const std::string& name) {
  const auto refuse = [&name](const std::string& tensor, const std::string& why) {
    return fail(Outcome::kInvalidRequest, name + " is no model file: tensor " + shown(tensor) + " " + why);
  };
  std::vector<const std::pair<const std::string, TensorEntry>*> order;
  for (const auto& item : header.tensors) {
    const TensorEntry& entry = item.second;
    if (entry.begin > entry.end || entry.end > data_bytes) return refuse(item.first, "lies outside the file");
    const auto needed = needed_bytes(entry);
    if (!needed || *needed != entry.end - entry.begin)
      return refuse(item.first, "has another length than its shape says");
    order.push_back(&item);
  }
  std::sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return std::pair(a->second.begin, a->second.end) < std::pair(b->second.begin, b->second.end);
  });
  std::uint64_t place = 0;
  for (const auto* item : order) {
    if (item->second.begin < place) return refuse(item->first, "overlaps another one");
    if (item->second.begin > place) return refuse(item->first, "leaves a gap before it");
    place = item->second.end;
  }
  if (place != data_bytes) {
    return fail(Outcome::kInvalidRequest, name + " is no model file: " + std::to_string(data_bytes - place) +
                                              " bytes after the last tensor belong to nothing");
  }
  return {};
}

}  // namespace goalnet::inference
