// Memory in one piece: aligned, apart, kept while small; lists and chunks on top of it.
#include "components/planner/arena.h"

#include <gtest/gtest.h>

#include <string>

#include "components/planner/chunks.h"
#include "components/planner/growing.h"

namespace goalnet::planner {
namespace {

TEST(Arena, GivesMemoryThatIsAlignedAndApart) {
  Arena arena;
  std::vector<std::pair<std::uintptr_t, std::size_t>> given;
  for (std::size_t bytes : {1u, 7u, 8u, 4000u, 3u, 5'000'000u, 16u, 1'000'000u, 2u << 20, 1u}) {
    auto* const memory = static_cast<char*>(arena.allocate(bytes, 16));
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    EXPECT_EQ(start % 16, 0u);
    for (const auto& [other, size] : given) EXPECT_TRUE(start + bytes <= other || other + size <= start);
    memory[0] = memory[bytes - 1] = 'x';
    given.emplace_back(start, bytes);
  }
  arena.clear();
  const void* const first = arena.allocate(8, 8);
  arena.clear();
  EXPECT_EQ(arena.allocate(8, 8), first) << "the first block is kept";
}

TEST(Arena, MovesWithItsMemory) {
  Arena arena;
  const std::string_view text = arena.copy_text("what lies here");
  Arena other = std::move(arena);
  arena = Arena();
  EXPECT_EQ(text, "what lies here");
  EXPECT_TRUE(arena.copy_text("").empty());
}

TEST(List, GrowsWithoutMovingWhatIsThere) {
  Arena arena;
  List<int> list;
  EXPECT_TRUE(list.empty());
  int& first = list.push_back(arena, 0);
  for (int i = 1; i < 10'000; ++i) list.push_back(arena, i);
  first = -1;
  EXPECT_EQ(list.size(), 10'000u);
  int expected = -1;
  for (const int value : list) {
    EXPECT_EQ(value, expected);
    expected = expected < 0 ? 1 : expected + 1;
  }
  EXPECT_EQ(list.front(), -1);
}

TEST(Chunks, AreCopiedMovedAndUsedAgain) {
  Chunks<int> chunks;
  for (int i = 0; i < 100'000; ++i) chunks.push_back(i);
  const Chunks<int> copy = chunks;
  Chunks<int> moved = std::move(chunks);
  chunks.clear();
  EXPECT_TRUE(chunks.empty());
  chunks.push_back(5);
  EXPECT_EQ(chunks.back(), 5);
  int count = 0;
  EXPECT_FALSE(moved.each([&](int value) { return value == count && ++count < 70'000; }));
  EXPECT_EQ(count, 70'000);
  moved.clear();
  for (int i = 0; i < 100'000; ++i) ASSERT_EQ(copy[static_cast<std::size_t>(i)], i);
}

// Across the heap, the first pages and several moves of them; what is there stays as it was.
TEST(Growing, KeepsItsElementsHoweverLargeItGrows) {
  constexpr std::uint32_t kMany = 5'000'000;  // 20 MB
  Growing<std::uint32_t> array;
  for (std::uint32_t i = 0; i < kMany; ++i) array.push_back(7 * i);
  ASSERT_EQ(array.size(), kMany);
  const Growing<std::uint32_t> copy = array;
  Growing<std::uint32_t> moved = std::move(array);
  array.push_back(3);
  EXPECT_EQ(array.back(), 3u);
  moved.append(std::span(copy.data(), copy.size()));
  for (std::uint32_t i = 0; i < kMany; ++i) {
    ASSERT_EQ(copy[i], 7 * i);
    ASSERT_EQ(moved[kMany + i], 7 * i);
  }
  moved.truncate(2);
  moved.push_back(moved[1]);
  EXPECT_EQ(moved.size(), 3u);
  EXPECT_EQ(moved.back(), 7u);
  moved.clear();
  EXPECT_TRUE(moved.empty());
  moved.assign(3, 9);
  EXPECT_EQ(std::count(moved.begin(), moved.end(), 9u), 3);
}

}  // namespace
}  // namespace goalnet::planner
