// Numbers for steps, counted from zero in the order in which they were first asked for.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "components/goalnet/ranker/step_key.h"

namespace goalnet::inference {

// A hash table in one piece: it is asked for every candidate of every moment, and the standard one divides
// and follows pointers each time.
class StepTable {
 public:
  // The number of a step, and whether it is new.
  std::pair<std::uint32_t, bool> number(StepKey step) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slots_[find(step)];
    if (slot.number != kFree) return {slot.number, false};
    slot = {step, count_};
    return {count_++, true};
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;
  struct Slot {
    StepKey step = 0;
    std::uint32_t number = kFree;
  };

  // Where the step stands, or would.
  std::size_t find(StepKey step) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (step * 0x9e3779b97f4a7c15ull) >> 40 & mask;
    while (slots_[at].number != kFree && slots_[at].step != step) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    std::vector<Slot> before(2 * slots_.size());
    before.swap(slots_);
    for (const Slot& slot : before)
      if (slot.number != kFree) slots_[find(slot.step)] = slot;
  }

  std::vector<Slot> slots_ = std::vector<Slot>(1024);  // a power of two
  std::uint32_t count_ = 0;
};

}  // namespace goalnet::inference
