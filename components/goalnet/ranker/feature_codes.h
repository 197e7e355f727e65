// The small numbers that features are made of, and how features become buckets.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

inline constexpr std::uint32_t kFeatureBits = 18;
inline constexpr std::uint32_t kFeatureBuckets = 1u << kFeatureBits;

// Small and called very often: a call would cost more than the work.
[[gnu::always_inline]] constexpr std::uint32_t mix(std::uint32_t hash, std::uint32_t value) {
  hash ^= value * 0xcc9e2d51u;
  hash = (hash << 13 | hash >> 19) * 5u + 0xe6546b64u;
  return hash ^ hash >> 15;
}

template <class... Values>
[[gnu::always_inline]] constexpr std::uint32_t feature(std::uint32_t kind, Values... values) {
  std::uint32_t hash = kind * 0x9e3779b1u;
  ((hash = mix(hash, static_cast<std::uint32_t>(values))), ...);
  hash ^= hash >> 16;
  hash *= 0x85ebca6bu;
  hash ^= hash >> 13;
  return hash & (kFeatureBuckets - 1);
}

// feature(kKind, a) and feature(kKind, a, b) of codes below `kFirst` and `kSecond`, from tables made by the
// compiler.
template <std::uint32_t kKind, std::uint32_t kFirst>
std::uint32_t small_feature(std::uint32_t a) {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, kFirst> table{};
    for (std::uint32_t i = 0; i < kFirst; ++i) table[i] = feature(kKind, i);
    return table;
  }();
  return kTable[a];
}
template <std::uint32_t kKind, std::uint32_t kFirst, std::uint32_t kSecond>
std::uint32_t small_feature(std::uint32_t a, std::uint32_t b) {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, kFirst * kSecond> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = feature(kKind, i / kSecond, i % kSecond);
    return table;
  }();
  return kTable[a * kSecond + b];
}

// The features of an action at an earlier moment. Some of them stay as they are as long as the action's
// things do, and to copy them is much quicker than to hash them again.
struct EarlierFeatures {
  std::array<std::uint64_t, 2> things = {~std::uint64_t{0}, 0};  // how they were
  std::vector<std::uint32_t> row;
  std::array<std::uint32_t, 12> ends{};  // of the parts that stay, in the row
};

// Appends features without asking each time whether there is room.
class Appender {
 public:
  Appender(std::vector<std::uint32_t>& out, const Instruction& instruction) : out_(out) {
    constexpr std::size_t kMost = 128, kMostForWord = 5, kMostForPair = 2;
    const std::size_t before = out.size();
    out.resize(before + kMost + kMostForWord * instruction.unigrams.size() +
               kMostForPair * instruction.bigrams.size());
    first_ = next_ = out.data() + before;
  }
  // With steady() parts, that are taken from `earlier` when it was made of the same things, or else are put
  // there.
  Appender(std::vector<std::uint32_t>& out, const Instruction& instruction, EarlierFeatures& earlier,
           std::array<std::uint64_t, 2> things)
      : Appender(out, instruction) {
    earlier_ = &earlier;
    known_ = earlier.things == things;
    earlier.things = things;
    if (known_) std::copy(earlier.row.begin(), earlier.row.end(), first_);
  }
  Appender(const Appender&) = delete;
  Appender& operator=(const Appender&) = delete;
  ~Appender() {
    if (earlier_ != nullptr && !known_) earlier_->row.assign(first_, next_);
    out_.resize(static_cast<std::size_t>(next_ - out_.data()));
  }

  template <class... Values>
  [[gnu::always_inline]] void operator()(Values... values) {
    append(feature(values...));
  }
  void append(std::uint32_t one) { *next_++ = one; }

  // `append` adds the features of the next part that stays.
  template <class Append>
  [[gnu::always_inline]] void steady(Append append) {
    std::uint32_t& end = earlier_->ends[part_++];
    if (known_) {
      next_ = first_ + end;
      return;
    }
    append();
    end = static_cast<std::uint32_t>(next_ - first_);
  }

 private:
  std::vector<std::uint32_t>& out_;
  std::uint32_t *first_ = nullptr, *next_ = nullptr;
  EarlierFeatures* earlier_ = nullptr;
  bool known_ = false;
  std::size_t part_ = 0;
};

// A small count, cut off.
std::uint32_t few(int count, int most);

// Devices are told apart by name (a knob is not a knob); movable things are not.
std::uint32_t verb_code(const SymAction& action);

// A share (0..1) in six steps.
inline constexpr std::uint32_t kVoteCodes = 6;
std::uint32_t vote_code(float weight);

// Whether the verb's first argument is a device or a part of one.
bool uses_device(Verb verb);

// The object that a device part belongs to: what the instruction is likely to name.
Symbol device_of(Symbol part);

// 0: no switch; 1: the action would switch something off (or close it), 2: on.
std::uint32_t switch_code(const SymAction& action, const SymState& state);

// Which devices are on or open.
std::uint32_t world_code(const SymState& state);

}  // namespace goalnet::inference
