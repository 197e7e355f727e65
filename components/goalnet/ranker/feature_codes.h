// The small numbers that features are made of, and how features become buckets.
#pragma once

#include <cstdint>
#include <vector>

#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

inline constexpr std::uint32_t kFeatureBits = 18;
inline constexpr std::uint32_t kFeatureBuckets = 1u << kFeatureBits;

inline std::uint32_t mix(std::uint32_t hash, std::uint32_t value) {
  hash ^= value * 0xcc9e2d51u;
  hash = (hash << 13 | hash >> 19) * 5u + 0xe6546b64u;
  return hash ^ hash >> 15;
}

template <class... Values>
std::uint32_t feature(std::uint32_t kind, Values... values) {
  std::uint32_t hash = kind * 0x9e3779b1u;
  ((hash = mix(hash, static_cast<std::uint32_t>(values))), ...);
  hash ^= hash >> 16;
  hash *= 0x85ebca6bu;
  hash ^= hash >> 13;
  return hash & (kFeatureBuckets - 1);
}

// Appends features without asking each time whether there is room.
class Appender {
 public:
  Appender(std::vector<std::uint32_t>& out, const Instruction& instruction) : out_(out) {
    constexpr std::size_t kMost = 128, kMostForWord = 8;
    const std::size_t before = out.size();
    out.resize(before + kMost + kMostForWord * (instruction.unigrams.size() + instruction.bigrams.size()));
    next_ = out.data() + before;
  }
  Appender(const Appender&) = delete;
  Appender& operator=(const Appender&) = delete;
  ~Appender() { out_.resize(static_cast<std::size_t>(next_ - out_.data())); }

  template <class... Values>
  void operator()(Values... values) {
    *next_++ = feature(values...);
  }

 private:
  std::vector<std::uint32_t>& out_;
  std::uint32_t* next_ = nullptr;
};

// A small count, cut off.
std::uint32_t few(int count, int most);

// Devices are told apart by name (a knob is not a knob); movable things are not.
std::uint32_t verb_code(const SymAction& action);

// A share (0..1) in six steps.
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
