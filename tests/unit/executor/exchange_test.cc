// The lock-free exchanges: every interleaving in a model, wrong variants that the model must reject, and real
// threads.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "executor/spsc_ring.h"
#include "executor/triple_buffer.h"
#include "tests/unit/executor/memory_model.h"
#include "tests/unit/executor/wrong_exchanges.h"

namespace goalnet::executor {
namespace {

// Of the buffer all interleavings; of the longer ring scenario those with at most four preemptions.
constexpr int kBufferPreemptions = 100, kRingPreemptions = 4;

// Writes 1, 2, 3 while reading three times: values only grow, and the newest is not lost.
template <class Buffer>
model::Exploration check_buffer() {
  return model::explore(
      [] {
        auto buffer = std::make_shared<Buffer>();
        auto seen = std::make_shared<std::vector<int>>();
        return model::Scenario{[buffer] {
                                 for (int value = 1; value <= 3; ++value) buffer->write(value);
                               },
                               [buffer, seen] {
                                 for (int n = 0; n < 3; ++n)
                                   if (int value = 0; buffer->read(value)) seen->push_back(value);
                               },
                               [buffer, seen]() -> std::string {
                                 if (int value = 0; buffer->read(value)) seen->push_back(value);
                                 int before = 0;
                                 for (int value : *seen) {
                                   if (value <= before) return "an old value came again";
                                   before = value;
                                 }
                                 return before == 3 ? "" : "the newest value was lost";
                               }};
      },
      kBufferPreemptions);
}

// Pushes 1..4 through two slots while popping: what was accepted arrives once and in order.
template <class Queue>
model::Exploration check_ring() {
  return model::explore(
      [] {
        auto ring = std::make_shared<Queue>();
        auto pushed = std::make_shared<std::vector<int>>(), popped = std::make_shared<std::vector<int>>();
        return model::Scenario{[ring, pushed] {
                                 for (int value = 1; value <= 4; ++value)
                                   if (ring->push(value)) pushed->push_back(value);
                               },
                               [ring, popped] {
                                 for (int n = 0; n < 3; ++n)
                                   if (int value = 0; ring->pop(value)) popped->push_back(value);
                               },
                               [ring, pushed, popped]() -> std::string {
                                 for (int value = 0; ring->pop(value);) popped->push_back(value);
                                 return *popped == *pushed ? "" : "values were lost, doubled or reordered";
                               }};
      },
      kRingPreemptions);
}

TEST(TripleBufferModel, EveryInterleavingIsRight) {
  const auto result = check_buffer<TripleBuffer<int, model::Memory>>();
  EXPECT_EQ(result.failure, "");
  EXPECT_GT(result.interleavings, 1'000u);
  RecordProperty("interleavings", static_cast<int>(result.interleavings));
}

TEST(TripleBufferModel, RejectsWrongVariants) {
  EXPECT_NE((check_buffer<wrong::RelaxedTripleBuffer<int, model::Memory>>().failure), "");
  EXPECT_NE((check_buffer<wrong::TwoStepTripleBuffer<int, model::Memory>>().failure), "");
  EXPECT_NE((check_buffer<wrong::DoubleBuffer<int, model::Memory>>().failure), "");
  // The missing order is found as a race, not by a wrong value: this machine would never show one.
  EXPECT_THAT((check_buffer<wrong::RelaxedTripleBuffer<int, model::Memory>>().failure),
              testing::HasSubstr("race"));
}

TEST(SpscRingModel, EveryInterleavingIsRight) {
  const auto result = check_ring<SpscRing<int, 2, model::Memory>>();
  EXPECT_EQ(result.failure, "");
  EXPECT_GT(result.interleavings, 1'000u);
  RecordProperty("interleavings", static_cast<int>(result.interleavings));
}

TEST(SpscRingModel, RejectsWrongVariants) {
  using wrong::RingSlip;
  EXPECT_NE((check_ring<wrong::Ring<int, 2, RingSlip::kPublishesFirst, model::Memory>>().failure), "");
  EXPECT_NE((check_ring<wrong::Ring<int, 2, RingSlip::kRelaxedPublish, model::Memory>>().failure), "");
  EXPECT_NE((check_ring<wrong::Ring<int, 2, RingSlip::kRelaxedRelease, model::Memory>>().failure), "");
  EXPECT_NE((check_ring<wrong::Ring<int, 2, RingSlip::kNeverFull, model::Memory>>().failure), "");
  EXPECT_NE((check_ring<wrong::Ring<int, 2, RingSlip::kFreesFirst, model::Memory>>().failure), "");
}

TEST(SpscRing, FullAndEmpty) {
  SpscRing<int, 4> ring;
  int value = 0;
  EXPECT_FALSE(ring.pop(value));
  for (int round = 0; round < 1000; ++round) {
    for (int n = 0; n < 4; ++n) EXPECT_TRUE(ring.push(n));
    EXPECT_FALSE(ring.push(99));
    for (int n = 0; n < 4; ++n) {
      ASSERT_TRUE(ring.pop(value));
      EXPECT_EQ(value, n);
    }
    EXPECT_FALSE(ring.pop(value));
  }
}

struct Wide {
  std::array<std::uint64_t, 16> words{};
};

TEST(TripleBuffer, IsNeverTornBetweenThreads) {
  TripleBuffer<Wide> buffer;
  constexpr std::uint64_t kLast = 200'000;
  std::thread writer([&] {
    Wide value;
    for (std::uint64_t n = 1; n <= kLast; ++n) {
      value.words.fill(n);
      buffer.write(value);
    }
  });
  Wide value;
  std::uint64_t before = 0, torn = 0, backwards = 0;
  while (before < kLast) {
    if (!buffer.read(value)) {
      std::this_thread::yield();
      continue;
    }
    for (std::uint64_t word : value.words) torn += word != value.words[0];
    backwards += value.words[0] <= before;
    before = value.words[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
}

TEST(SpscRing, LosesNothingBetweenThreads) {
  SpscRing<std::uint64_t, 8> ring;
  constexpr std::uint64_t kLast = 200'000;
  std::thread producer([&] {
    for (std::uint64_t n = 1; n <= kLast;) {
      if (ring.push(n))
        ++n;
      else
        std::this_thread::yield();
    }
  });
  std::uint64_t expected = 1, wrong = 0;
  while (expected <= kLast) {
    std::uint64_t value = 0;
    if (!ring.pop(value)) {
      std::this_thread::yield();
      continue;
    }
    wrong += value != expected++;
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace goalnet::executor
