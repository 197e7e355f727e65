#include "tests/support/hostile_payloads.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "idl/cdr_check.h"

namespace goalnet::testing_support {
namespace {

class Writer {
 public:
  Writer(const Filling& filling, Bytes& out) : filling_(filling), out_(out) {}

  void write(const idl::TypeDescription& type) {
    for (const idl::FieldDescription& field : type.all_fields()) {
      const std::uint8_t shape = field.type_id >= idl::kSequence          ? idl::kSequence
                                 : field.type_id >= idl::kBoundedSequence ? idl::kBoundedSequence
                                 : field.type_id >= idl::kArray           ? idl::kArray
                                                                          : 0;
      std::uint32_t count = 1;
      if (shape == idl::kArray) count = field.capacity;
      if (shape == idl::kSequence) count = filling_.elements;
      if (shape == idl::kBoundedSequence) count = std::min(filling_.elements, field.capacity);
      if (shape == idl::kSequence || shape == idl::kBoundedSequence) number(count, 4);
      for (std::uint32_t i = 0; i < count; ++i)
        element(field, static_cast<std::uint8_t>(field.type_id - shape));
    }
  }

 private:
  void number(std::uint64_t value, std::size_t size) {
    while ((out_.size() - 4) % size != 0) out_.push_back(0);
    for (std::size_t i = 0; i < size; ++i) out_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void element(const idl::FieldDescription& field, std::uint8_t id) {
    static constexpr std::uint8_t kSizes[] = {0, 0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0, 1, 0, 1, 1};
    if (id == idl::kNested) {
      write(*idl::find_type(field.nested));
    } else if (id == idl::kString || id == idl::kBoundedString) {
      const std::string text =
          field.string_capacity == 0 ? filling_.text : filling_.text.substr(0, field.string_capacity);
      number(text.size() + 1, 4);
      out_.insert(out_.end(), text.begin(), text.end());
      out_.push_back(0);
    } else if (id == 10) {
      const auto real = static_cast<float>(filling_.real);
      std::uint32_t bits = 0;
      std::memcpy(&bits, &real, 4);
      number(bits, 4);
    } else if (id == 11) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &filling_.real, 8);
      number(bits, 8);
    } else if (id == 15) {
      number(filling_.number & 1, 1);
    } else {
      number(filling_.number, kSizes[id]);
    }
  }

  const Filling& filling_;
  Bytes& out_;
};

}  // namespace

Bytes filled_payload(const idl::TypeDescription& type, const Filling& filling) {
  Bytes payload = {0, 1, 0, 0};
  Writer(filling, payload).write(type);
  return payload;
}

std::vector<Bytes> malformed_payloads(const idl::TypeDescription& type, std::mt19937& random) {
  const Bytes good = filled_payload(type, {.number = 1, .real = 0.5, .text = "text", .elements = 3});
  std::vector<Bytes> all = {{0}, {0, 1, 0}, {0, 1, 0, 0}, {0, 3, 0, 0, 1, 0, 0, 0}, {9, 9, 9, 9, 9, 9, 9, 9}};
  all.emplace_back(64, std::uint8_t{0xff});
  for (std::size_t cut = 4; cut < good.size(); cut += 1 + good.size() / 16)
    all.emplace_back(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(cut));
  for (std::size_t at = 4; at + 4 <= good.size() && at < 400; at += 4) {
    for (const std::uint32_t length : {0xffffffffu, 0x7fffffffu, 0x00ffffffu}) {
      all.push_back(good);
      std::memcpy(all.back().data() + at, &length, 4);
    }
  }
  for (const char* text : {"\xff\xfe", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "cut \xe2\x82"}) {
    all.push_back(filled_payload(type, {.number = 1, .real = 0.5, .text = text, .elements = 2}));
  }
  for (int i = 0; i < 20; ++i) {
    Bytes noise = {0, 1, 0, 0};
    for (unsigned left = random() % 300; left > 0; --left)
      noise.push_back(static_cast<std::uint8_t>(random()));
    all.push_back(std::move(noise));
  }
  // Some of these happen to be messages, as an absurd number in a number's place is: those are not malformed.
  // On the wire a payload is filled up to whole words, which makes good a cut through a number's last zeros.
  const idl::CdrLayout layout(type);
  std::erase_if(all, [&](const Bytes& payload) {
    Bytes sent = payload;
    sent.resize((sent.size() + 3) / 4 * 4, 0);
    return layout.check(payload) == nullptr || layout.check(sent) == nullptr;
  });
  return all;
}

std::vector<Bytes> senseless_payloads(const idl::TypeDescription& type) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Filling> fillings = {
      {.number = 0, .real = nan, .text = "", .elements = 0},
      {.number = 1, .real = nan, .text = "NaN", .elements = 1},
      {.number = ~0ull, .real = infinity, .text = "Mug_1", .elements = 2},
      {.number = 0x8000000000000000ull, .real = -infinity, .text = std::string(1000, 'x'), .elements = 7},
      {.number = 7, .real = 1e308, .text = "\x01\x02\x7f\n\r\t\"'\\{}%s%n", .elements = 50},
      {.number = 2, .real = -0.0, .text = "../../../../etc/passwd", .elements = 3},
      {.number = 3, .real = 1e-308, .text = "\xe6\x9d\xaf\xe5\xad\x90 \xf0\x9f\x98\x80", .elements = 300},
  };
  std::vector<Bytes> all;
  for (const Filling& filling : fillings) {
    Bytes payload = filled_payload(type, filling);
    if (payload.size() < 200'000) all.push_back(std::move(payload));
  }
  return all;
}

}  // namespace goalnet::testing_support
